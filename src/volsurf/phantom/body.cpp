#include "volsurf/phantom/body.h"

#include "volsurf/core/error.h"
#include "volsurf/phantom/head.h"
#include "volsurf/phantom/shapes.h"

#include <map>
#include <string>

namespace volsurf {

namespace {

/// What the sizes of a body go by.
struct BodyFrame {
  Vec3 centre;
  double extent_mm;
  double voxel_mm;
};

BodyFrame frame_of(const Grid &grid)
{
  const Vec3 off_the_samples{0.31, -0.17, 0.23};
  Vec3 centre{};
  Vec3 sides{};
  for (int axis = 0; axis < 3; ++axis) {
    centre[axis] = 0.5 * static_cast<double>(grid.size[axis] - 1) + off_the_samples[axis];
    sides[axis] = grid.spacing_mm[axis] * static_cast<double>(grid.size[axis]);
  }
  return {index_to_world(grid, centre), *std::min_element(sides.begin(), sides.end()), smallest_spacing_mm(grid)};
}

double ball(const Vec3 &p, const Vec3 &centre, double radius)
{
  return length(minus(p, centre)) - radius;
}

SignedDistance torus(const BodyFrame &frame)
{
  constexpr Vec3 kAxis{0.36, 0.48, 0.8};
  return [=](const Vec3 &p) {
    const Vec3 offset = minus(p, frame.centre);
    const double height = dot(offset, kAxis);
    const double from_axis = std::sqrt(std::max(dot(offset, offset) - height * height, 0.0));
    return std::hypot(from_axis - 0.25 * frame.extent_mm, height) - 0.1 * frame.extent_mm;
  };
}

SignedDistance blobs(const BodyFrame &frame)
{
  constexpr Vec3 kDirection{0.48, 0.64, 0.6};
  const double radius = 0.2 * frame.extent_mm;
  const double half_way = radius - 0.5 * frame.voxel_mm;
  Vec3 first = frame.centre;
  Vec3 second = frame.centre;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] -= half_way * kDirection[axis];
    second[axis] += half_way * kDirection[axis];
  }
  return [=](const Vec3 &p) { return std::min(ball(p, first, radius), ball(p, second, radius)); };
}

SignedDistance shell(const BodyFrame &frame)
{
  const double outer = 0.3 * frame.extent_mm;
  const double inner = outer - 3 * frame.voxel_mm;
  return [=](const Vec3 &p) { return std::max(ball(p, frame.centre, outer), -ball(p, frame.centre, inner)); };
}

SignedDistance brain(std::uint64_t anatomy)
{
  return [folds = make_fold_pattern(anatomy)](const Vec3 &p) {
    const BodyDistances bodies = head_distances(folds, p);
    double nearest = bodies.back();
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (is_brain(kBodyTissues[i]))
        nearest = std::min(nearest, bodies[i]);
    return nearest;
  };
}

SignedDistance centred_distance(BodyKind body, const Grid &grid, std::uint64_t anatomy)
{
  const BodyFrame frame = frame_of(grid);
  switch (body) {
  case BodyKind::kSphere:
    return [=](const Vec3 &p) { return ball(p, frame.centre, 0.3 * frame.extent_mm); };
  case BodyKind::kTorus:
    return torus(frame);
  case BodyKind::kBlobs:
    return blobs(frame);
  case BodyKind::kShell:
    return shell(frame);
  default:
    return brain(anatomy);
  }
}

} // namespace

SignedDistance body_distance(BodyKind body, const Grid &grid, std::uint64_t anatomy, const Vec3 &offset_mm)
{
  SignedDistance centred = centred_distance(body, grid, anatomy);
  if (offset_mm == Vec3{})
    return centred;
  return [=](const Vec3 &p) { return centred(minus(p, offset_mm)); };
}

std::optional<BodyKind> parse_body(std::string_view name)
{
  static const std::map<std::string_view, BodyKind> bodies{{"sphere", BodyKind::kSphere},
                                                           {"torus", BodyKind::kTorus},
                                                           {"blobs", BodyKind::kBlobs},
                                                           {"shell", BodyKind::kShell},
                                                           {"cortex", BodyKind::kCortex}};
  if (name == "head")
    return {};
  const auto found = bodies.find(name);
  if (found == bodies.end())
    throw UsageError("--shape: \"" + std::string(name) + "\" is not head, sphere, torus, blobs, shell or cortex");
  return found->second;
}

} // namespace volsurf
