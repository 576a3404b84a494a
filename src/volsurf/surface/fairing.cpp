#include "volsurf/surface/fairing.h"

#include "volsurf/core/vec3.h"
#include "volsurf/surface/point_loop.h"

#include <algorithm>
#include <utility>

namespace volsurf {

namespace {

constexpr int kShapeRounds = 5;         ///< over which the bends of a surface are averaged
constexpr int kLooksAtCreases = 2;      ///< how often the problem is solved again
constexpr double kCreaseBends = 3;      ///< a bend off by so many sd costs half of what it did
constexpr int kMostIterations = 15;     ///< of one solution; more change the study's distances by less than 0.001 voxel
constexpr double kLeastResidual = 1e-3; ///< squared, relative to the first, where a solution is good enough

/// Calls term(i) for each point and adds up what they return, in an order that no thread changes.
template <typename Term> double sum_over_points(std::size_t points, Term term)
{
  const auto count = static_cast<std::int64_t>(points);
  std::vector<double> of_slab(static_cast<std::size_t>(slab_count(count, kPointsPerSlab)));
  parallel_for_slabs(count, kPointsPerSlab, [&](const Slab &slab) {
    double sum = 0;
    for (std::int64_t i = slab.begin; i < slab.end; ++i)
      sum += term(static_cast<std::size_t>(i));
    of_slab[slab.index] = sum;
  });
  double sum = 0;
  for (const double part : of_slab)
    sum += part;
  return sum;
}

/// How each point's neighbours bend the surface at it: the linear map B of the sum above, and its transpose.
class Bends {
public:
  Bends(const PointNeighbours &neighbours, const std::vector<Target> &targets)
      : neighbours_(neighbours), on_feature_(targets.size()), share_(targets.size())
  {
    for_each_point(targets.size(), [&](std::size_t i) { on_feature_[i] = targets[i].on_feature ? 1 : 0; });
    for_each_point(targets.size(), [&](std::size_t i) {
      std::size_t count = 0;
      neighbours_.for_each(i, [&](PointId j) { count += counts(i, j) ? 1 : 0; });
      if (count > 0 && (on_feature_[i] == 0 || count == 2))
        share_[i] = 1 / static_cast<double>(count);
    });
  }

  /// False at points without neighbours, and at ends and forks of features, which bend as they like.
  bool is_bound(std::size_t i) const { return share_[i] > 0; }

  Vec3 at(std::size_t i, const std::vector<Vec3> &x) const
  {
    if (!is_bound(i))
      return {0, 0, 0};
    Vec3 sum{0, 0, 0};
    neighbours_.for_each(i, [&](PointId j) {
      if (counts(i, j))
        sum = plus(sum, 1, x[j]);
    });
    return minus(scaled(share_[i], sum), x[i]);
  }

  /// What each neighbour of i has in a force on it.
  Vec3 part_of(std::size_t i, const Vec3 &force) const { return scaled(share_[i], force); }

  /// B^T times forces, given as the parts that each neighbour has in them.
  Vec3 transposed_at(std::size_t i, const std::vector<Vec3> &parts) const
  {
    Vec3 sum = is_bound(i) ? scaled(-1 / share_[i], parts[i]) : Vec3{0, 0, 0};
    neighbours_.for_each(i, [&](PointId j) {
      if (counts(j, static_cast<PointId>(i)))
        sum = plus(sum, 1, parts[j]);
    });
    return sum;
  }

private:
  /// Whether i, joined to j by an edge, bends by it.
  bool counts(std::size_t i, PointId j) const { return on_feature_[i] == 0 || on_feature_[j] != 0; }

  const PointNeighbours &neighbours_;
  std::vector<char> on_feature_;
  std::vector<double> share_; // of each neighbour in the mean; 0: not bound
};

/// Rounds carry as far as the square root of their number.
std::vector<Vec3> average_bends(const Bends &bends, const std::vector<Vec3> &shape, int rounds)
{
  std::vector<Vec3> expected(shape.size());
  for_each_point(shape.size(), [&](std::size_t i) { expected[i] = bends.at(i, shape); });
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Vec3> before = expected;
    for_each_point(shape.size(), [&](std::size_t i) { expected[i] = plus(before[i], 0.5, bends.at(i, before)); });
  }
  return expected;
}

/// The sd of a bend, from those of `shape` and their averages; 0 where they tell nothing.
double measure_bend_sd(const Bends &bends, const std::vector<Vec3> &shape, const std::vector<Vec3> &averages)
{
  std::vector<double> deviations;
  for (std::size_t i = 0; i < shape.size(); ++i)
    if (bends.is_bound(i))
      deviations.push_back(length(minus(bends.at(i, shape), averages[i])));
  if (deviations.empty())
    return 0;
  const auto median = deviations.begin() + static_cast<std::ptrdiff_t>(deviations.size() / 2);
  std::nth_element(deviations.begin(), median, deviations.end());
  const double sd = kBendOfDeviation * *median;
  return sd < kBendOfStaircase ? sd : 0;
}

/// The sum to be minimised.
class SmoothingSpline {
public:
  SmoothingSpline(const PointNeighbours &neighbours, const std::vector<Target> &targets, const std::vector<Vec3> &shape,
                  const MeshSampling &sampling)
      : targets_(targets), bends_(neighbours, targets), reach_(sampling.oversampling * sampling.oversampling),
        expected_(average_bends(bends_, shape, kShapeRounds * reach_)), stiffness_(targets.size()),
        weight_(targets.size()), parts_(targets.size())
  {
    const double measured_sd = sampling.is_even ? measure_bend_sd(bends_, shape, expected_) : 0;
    const double bend_sd = std::max(kLeastBend / sampling.oversampling, measured_sd);
    usual_stiffness_ = 1 / (bend_sd * bend_sd);
    for_each_point(size(), [&](std::size_t i) { stiffness_[i] = bends_.is_bound(i) ? usual_stiffness_ : 0; });
    set_targets(targets);
  }

  void set_targets(std::vector<Target> targets)
  {
    targets_ = std::move(targets);
    for_each_point(size(), [&](std::size_t i) { weight_[i] = 1 / (targets_[i].error * targets_[i].error); });
  }

  std::size_t size() const { return targets_.size(); }
  int most_iterations() const { return kMostIterations * reach_; }

  /// Half of the negative gradient of the sum.
  void residual(const std::vector<Vec3> &x, std::vector<Vec3> &result)
  {
    for_each_point(size(), [&](std::size_t i) {
      parts_[i] = bends_.part_of(i, scaled(stiffness_[i], minus(bends_.at(i, x), expected_[i])));
    });
    for_each_point(size(), [&](std::size_t i) {
      const Vec3 pull = minus(targets_[i].position, x[i]);
      result[i] = within_free_axes(i, minus(scaled(weight_[i], pull), bends_.transposed_at(i, parts_)));
    });
  }

  /// The matrix of the normal equations times a vector. Returns the inner product of both.
  double multiply(const std::vector<Vec3> &x, std::vector<Vec3> &result)
  {
    for_each_point(size(),
                   [&](std::size_t i) { parts_[i] = bends_.part_of(i, scaled(stiffness_[i], bends_.at(i, x))); });
    return sum_over_points(size(), [&](std::size_t i) {
      result[i] = within_free_axes(i, plus(bends_.transposed_at(i, parts_), weight_[i], x[i]));
      return dot(x[i], result[i]);
    });
  }

  /// Its diagonal, but for the small part that the bends at neighbours add.
  double diagonal(std::size_t i) const { return weight_[i] + stiffness_[i]; }

  /// Takes as creases what bends sharply in x.
  void relax_creases(const std::vector<Vec3> &x)
  {
    for_each_point(size(), [&](std::size_t i) {
      if (!bends_.is_bound(i))
        return;
      const Vec3 off = minus(bends_.at(i, x), expected_[i]);
      const double squared_sds = dot(off, off) * usual_stiffness_ / (kCreaseBends * kCreaseBends);
      stiffness_[i] = usual_stiffness_ / (1 + squared_sds * squared_sds);
    });
  }

  /// Moves points from the surface to where the triangles around them are on it, on average: over flat triangles
  /// between points of a curved surface it is higher by a quarter of the bend.
  void centre_faces(std::vector<Vec3> &x) const
  {
    const std::vector<Vec3> bends = average_bends(bends_, x, kShapeRounds * reach_);
    for_each_point(size(), [&](std::size_t i) {
      if (!targets_[i].on_feature)
        x[i] = plus(x[i], -0.25, within_free_axes(i, bends[i]));
    });
  }

private:
  Vec3 within_free_axes(std::size_t i, Vec3 v) const
  {
    for (int axis = 0; axis < 3; ++axis)
      v[axis] = targets_[i].free_axes[axis] ? v[axis] : 0;
    return v;
  }

  std::vector<Target> targets_;
  Bends bends_;
  int reach_; // rounds and iterations for one where the grid is the scan's own
  std::vector<Vec3> expected_;
  double usual_stiffness_ = 0;    // of a bend that is no crease
  std::vector<double> stiffness_; // per bend
  std::vector<double> weight_;    // per target
  std::vector<Vec3> parts_;       // scratch
};

/// Conjugate gradients. Goes on from x until the residual is small, or small beside `first_residual`, which is set
/// where it is 0. Each loop does all that it can while it has a point at hand: waiting for memory takes the time.
void minimise(SmoothingSpline &spline, std::vector<Vec3> &x, double &first_residual)
{
  const std::size_t points = spline.size();
  std::vector<Vec3> residual(points);
  std::vector<Vec3> conditioned(points);
  std::vector<Vec3> product(points);
  const auto condition = [&](std::size_t i) {
    conditioned[i] = scaled(1 / spline.diagonal(i), residual[i]);
    return dot(residual[i], conditioned[i]);
  };
  spline.residual(x, residual);
  double size = sum_over_points(points, condition);
  if (first_residual == 0)
    first_residual = size;
  std::vector<Vec3> direction = conditioned;
  for (int iteration = 0; iteration < spline.most_iterations() && size > kLeastResidual * first_residual; ++iteration) {
    const double step = size / spline.multiply(direction, product);
    const double before = size;
    size = sum_over_points(points, [&](std::size_t i) {
      x[i] = plus(x[i], step, direction[i]);
      residual[i] = plus(residual[i], -step, product[i]);
      return condition(i);
    });
    for_each_point(points, [&](std::size_t i) { direction[i] = plus(conditioned[i], size / before, direction[i]); });
  }
}

} // namespace

MeshSampling sampling_of(const Grid &grid)
{
  return {grid.oversampling, !has_thick_slices(grid)};
}

std::vector<Vec3> fair_positions(const PointNeighbours &neighbours, const std::vector<Target> &targets,
                                 const std::vector<Vec3> &shape, const MeshSampling &sampling)
{
  SmoothingSpline spline(neighbours, targets, shape, sampling);
  std::vector<Vec3> x = shape;
  double first_residual = 0;
  minimise(spline, x, first_residual);
  for (int look = 0; look < kLooksAtCreases; ++look) {
    spline.relax_creases(x);
    minimise(spline, x, first_residual);
  }
  spline.centre_faces(x);
  return x;
}

std::vector<Vec3> fair_positions(const PointNeighbours &neighbours, const FindTargets &find_targets, int rounds,
                                 const std::vector<Vec3> &shape, const MeshSampling &sampling)
{
  std::vector<Vec3> x = shape;
  SmoothingSpline spline(neighbours, find_targets(x), shape, sampling);
  for (int round = 0; round < rounds; ++round) {
    if (round > 0) {
      spline.relax_creases(x);
      spline.set_targets(find_targets(x));
    }
    double first_residual = 0;
    minimise(spline, x, first_residual);
  }
  return x;
}

} // namespace volsurf
