#include "volsurf/phantom/head.h"

#include "volsurf/phantom/random.h"
#include "volsurf/phantom/shapes.h"

namespace volsurf {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFarMm = 1000; // larger than any head: "not here"

// Around the brain stands a moat of dark fluid and bone, everywhere wider than a few voxels of a 128^3 volume: where it
// were thinner, the wall of the brain would have a weak point, and the brain would be one region with what is outside.
// The scalp is thick enough that its middle lies clear of the gradients of both its walls, a weak path along which it
// leaks into the air.
constexpr double kCsfGapMm = 4.4;
constexpr double kSkullMm = 5.5;
constexpr double kScalpMm = 7;
constexpr double kFatMm = 7; // below the skin, wherever soft tissue is thicker than the scalp

constexpr double kFissureHalfWidthMm = 2.2;
constexpr double kRibbonMm = 3.2;
constexpr double kSulcusHalfWidthMm = 1.2;
constexpr double kSulcusDepthMm = 11;
constexpr double kMouthMm = 2.2;    // by which each bank of a sulcus gives way at the hull, so that the fluid outside
                                    // reaches into it along a weak gradient
constexpr double kMouthDepthMm = 9; // below the hull, where the banks stand upright again
constexpr double kFoldWavelengthMm = 27; // two sulci per wavelength
constexpr double kFoldedShellMm = 24;    // folds and ribbon do not reach deeper than this

/// The anatomy but its folds is symmetric: left and right share one side.
Vec3 to_left_side(const Vec3 &p)
{
  return {std::abs(p[0]), p[1], p[2]};
}

/// Cerebrum without temporal lobes and without the fissure between the hemispheres.
double upper_cerebrum(const Vec3 &p)
{
  const double floor = -(p[2] + 9);
  return smooth_intersection(ellipsoid(p, {0, 4, 25}, {65, 80, 56}), floor, 14);
}

double temporal_lobe(const Vec3 &left)
{
  return ellipsoid(left, {41, -2, -11}, {22, 51, 22});
}

/// What holds the hemispheres together, around the third ventricle.
double diencephalon(const Vec3 &left)
{
  return ellipsoid(left, {0, 5, 14}, {23, 37, 21});
}

double brain_stem(const Vec3 &p)
{
  constexpr std::array<TubePoint, 5> kAxis{TubePoint{{0, 8, 2}, 12}, TubePoint{{0, 11, -24}, 14},
                                           TubePoint{{0, 17, -44}, 11}, TubePoint{{0, 24, -70}, 7.5},
                                           TubePoint{{0, 26, -kFarMm}, 7.5}};
  return tube(p, kAxis, 4);
}

double cerebellum_hull(const Vec3 &p)
{
  const double groove = 5 * std::exp(-p[0] * p[0] / 60) * smooth_step(45, 75, p[1]);
  return ellipsoid(p, {0, 46, -35}, {51, 31, 24}) + groove;
}

double peduncle(const Vec3 &left)
{
  return tube_piece(left, {{0, 12, -32}, 8}, {{20, 42, -34}, 6});
}

double corpus_callosum(const Vec3 &left)
{
  constexpr std::array<TubePoint, 5> kArch{TubePoint{{0, -31, 22}, 5}, TubePoint{{0, -22, 32}, 4.5},
                                           TubePoint{{0, 2, 38}, 4}, TubePoint{{0, 26, 35}, 4.5},
                                           TubePoint{{0, 38, 25}, 5.5}};
  constexpr double kHalfBreadthMm = 16;
  return tube({std::max(left[0] - kHalfBreadthMm, 0.0), left[1], left[2]}, kArch, 4);
}

double ventricles(const Vec3 &left)
{
  constexpr std::array<TubePoint, 5> kBody{TubePoint{{8, -28, 19}, 4.5}, TubePoint{{8.5, -4, 28}, 4.5},
                                           TubePoint{{14, 20, 27}, 5}, TubePoint{{21, 34, 16}, 6},
                                           TubePoint{{24, 55, 12}, 3}};
  constexpr std::array<TubePoint, 3> kTemporalHorn{TubePoint{{21, 34, 16}, 5}, TubePoint{{36, 16, -8}, 3},
                                                   TubePoint{{38, -10, -13}, 3}};
  const double third = ellipsoid(left, {0, 6, 11}, {2.2, 15, 11});
  const double fourth = ellipsoid(left, {0, 25, -34}, {7, 4, 10});
  const double lateral = smooth_union(tube(left, kBody, 5), tube(left, kTemporalHorn, 3), 3);
  return std::min({lateral, third, fourth});
}

/// Thalamus, and caudate nucleus with putamen as one.
double deep_grey(const Vec3 &left)
{
  return std::min(ellipsoid(left, {11.5, 9, 13}, {7.5, 14, 8}), ellipsoid(left, {25, -8, 11}, {6.5, 19, 10}));
}

/// The cerebrum as if nothing but its great fissure were folded in.
double cerebrum_hull(const Vec3 &p)
{
  const Vec3 left = to_left_side(p);
  const double hemisphere = smooth_intersection(upper_cerebrum(p), kFissureHalfWidthMm - left[0], 6);
  return smooth_union(smooth_union(hemisphere, temporal_lobe(left), 6), diencephalon(left), 6);
}

/// Gradient of the distance to the cerebrum's hull; its length is 1 but near the middle between two walls, where it
/// turns.
Vec3 hull_gradient(const Vec3 &p, double hull)
{
  constexpr double kStepMm = 0.5;
  Vec3 gradient{};
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 step = p;
    step[axis] += kStepMm;
    gradient[axis] = (cerebrum_hull(step) - hull) / kStepMm;
  }
  return gradient;
}

/// The upright sheet in the middle of a sulcus, as seen from a point: how far away it is, how far below the hull it
/// reaches.
struct SulcusSheet {
  double distance_mm;
  double depth_mm;
};

/// The pattern is looked up at the nearest point of the hull, so that the walls of the sulci stand upright on it.
SulcusSheet nearest_sulcus(const FoldPattern &folds, const Vec3 &p, double hull)
{
  const Vec3 outward = hull_gradient(p, hull);
  const double certainty = std::max(length(outward), 1e-6);
  const Vec3 normal{outward[0] / certainty, outward[1] / certainty, outward[2] / certainty};
  const Vec3 q{p[0] - hull * normal[0], p[1] - hull * normal[1], p[2] - hull * normal[2]};
  double value = 0;
  Vec3 gradient{};
  for (const Wave &wave : folds) {
    const double angle = dot(wave.wave_vector, q) + wave.phase;
    value += std::cos(angle);
    const double slope = -std::sin(angle);
    for (int axis = 0; axis < 3; ++axis)
      gradient[axis] += slope * wave.wave_vector[axis];
  }
  const double upright = dot(gradient, normal);
  const double steepness = std::sqrt(std::max(dot(gradient, gradient) - upright * upright, 0.0));
  const double typical = std::sqrt(folds.size() / 2.0) * 2 * kPi / kFoldWavelengthMm;
  // Where the pattern is nearly level at a zero, two sulci meet or a gyrus is thinner than its ribbons. There is no
  // sulcus there, but a bridge: a ridge that thins out slowly would be a gap in the wall around the brain.
  const double room = smooth_step(0.25, 0.55, steepness / typical) * smooth_step(0.7, 0.95, certainty);
  return {std::abs(value) / std::hypot(steepness, 0.3 * typical), kSulcusDepthMm * room};
}

/// Distance to an upright sheet that thickens towards the hull.
double distance_to_slit(const SulcusSheet &sheet, double hull)
{
  const double below = std::max(-hull - sheet.depth_mm, 0.0);
  const double mouth = kMouthMm * std::min(sheet.depth_mm / kSulcusDepthMm, 1.0) * smooth_step(-kMouthDepthMm, 0, hull);
  return std::sqrt(sheet.distance_mm * sheet.distance_mm + below * below) - mouth;
}

/// Distance to the middle of the nearest sulcus, or of the fissure above the temporal lobe.
double distance_to_sulci(const FoldPattern &folds, const Vec3 &p, double hull, double ventricle)
{
  const Vec3 left = to_left_side(p);
  // No sulcus may open into a ventricle, nor cut the middle of the brain.
  const double room = smooth_step(4, 14, std::min(ventricle, diencephalon(left)));
  SulcusSheet fold = nearest_sulcus(folds, p, hull);
  fold.depth_mm *= room;
  const SulcusSheet sylvian{0.7 * std::abs(upper_cerebrum(p) - temporal_lobe(left)),
                            17 * room * smooth_step(26, 40, left[0]) * (1 - smooth_step(10, 34, p[1]))};
  return std::min(distance_to_slit(fold, hull), distance_to_slit(sylvian, hull) - 0.8);
}

struct Cortex {
  double grey;
  double white;
};

Cortex cerebral_cortex(const FoldPattern &folds, const Vec3 &p, double hull, double ventricle)
{
  if (hull > 4 || hull < -kFoldedShellMm)
    return {hull, hull + kRibbonMm};
  const double sulci = distance_to_sulci(folds, p, hull, ventricle);
  return {smooth_intersection(hull, kSulcusHalfWidthMm - sulci, 3),
          smooth_intersection(hull + kRibbonMm, kSulcusHalfWidthMm + kRibbonMm - sulci, 3)};
}

/// Its leaves fan out from the stem.
Cortex cerebellar_cortex(const Vec3 &p, double cerebrum)
{
  const double hull = cerebellum_hull(p);
  if (hull > 6)
    return {hull, hull};
  constexpr double kLeafMm = 12;
  const double fan = 34 * std::atan2(p[2] + 35, std::max(p[1] - 12, 1.0));
  const double leaf = std::cos(2 * kPi * fan / kLeafMm);
  const double tree = std::cos(2 * kPi * fan / (2 * kLeafMm));
  const double below_cerebrum = kCsfGapMm + 0.4 - cerebrum;
  const double grey = smooth_intersection(hull + 2.2 + 2.2 * leaf, below_cerebrum, 3);
  return {grey, grey + 4 + tree};
}

/// The fluid-filled space: around the brain, and down the spinal canal with the stem.
double cavity(const Vec3 &p, double stem)
{
  const double cerebrum = smooth_union(upper_cerebrum(p), temporal_lobe(to_left_side(p)), 10);
  const double brain = smooth_union(cerebrum, cerebellum_hull(p), 12);
  return smooth_union(brain, stem, 6) - kCsfGapMm;
}

double face(const Vec3 &p)
{
  const Vec3 left = to_left_side(p);
  const double cheeks = ellipsoid(p, {0, -40, -52}, {58, 48, 72});
  const double chin = ellipsoid(p, {0, -72, -88}, {20, 15, 14});
  const double nose = tube_piece(p, {{0, -84, -24}, 5}, {{0, -90, -46}, 8});
  const double eye_socket = ellipsoid(left, {30, -99, -20}, {17, 17, 13});
  const double brow = smooth_intersection(smooth_union(cheeks, chin, 18), -eye_socket, 8);
  return smooth_union(brow, nose, 9);
}

double head_hull(const Vec3 &p, double skull)
{
  const double neck = tube_piece(p, {{0, 20, -60}, 54}, {{0, 26, -kFarMm}, 54});
  const double ear = ellipsoid(to_left_side(p), {80, 12, -25}, {6, 15, 24});
  double head = smooth_union(skull - kScalpMm, face(p), 24);
  head = smooth_union(head, neck, 24);
  return smooth_union(head, ear, 8);
}

/// Grey matter, white matter, deep grey matter and ventricles, into the places that kBodyTissues gives them.
void add_brain(const FoldPattern &folds, const Vec3 &p, double stem, BodyDistances *bodies)
{
  const Vec3 left = to_left_side(p);
  const double hull = cerebrum_hull(p);
  const double ventricle = ventricles(left);
  const Cortex cerebrum = cerebral_cortex(folds, p, hull, ventricle);
  const Cortex cerebellum = cerebellar_cortex(p, hull);
  const double callosum = corpus_callosum(left);
  const double tracts = smooth_union(smooth_union(stem, peduncle(left), 3), callosum, 3);
  (*bodies)[4] = std::min({cerebrum.grey, cerebellum.grey, tracts});
  (*bodies)[5] = std::min(smooth_union(cerebrum.white, tracts, 3), cerebellum.white);
  (*bodies)[6] = deep_grey(left);
  (*bodies)[7] = ventricle;
}

} // namespace

FoldPattern make_fold_pattern(std::uint64_t seed)
{
  FoldPattern folds{};
  const double wave_number = 2 * kPi / kFoldWavelengthMm;
  for (std::size_t i = 0; i < folds.size(); ++i) {
    // Directions spread evenly over the sphere by a spiral, turned at random; opposite ones would be the same wave.
    const double height = (static_cast<double>(i) + random_uniform(seed, 3 * i)) / static_cast<double>(folds.size());
    const double radius = std::sqrt(1 - height * height);
    const double turn = 2 * kPi * random_uniform(seed, 3 * i + 1);
    folds[i].wave_vector = {wave_number * radius * std::cos(turn), wave_number * radius * std::sin(turn),
                            wave_number * height};
    folds[i].phase = 2 * kPi * random_uniform(seed, 3 * i + 2);
  }
  return folds;
}

BodyDistances head_distances(const FoldPattern &folds, const Vec3 &point)
{
  BodyDistances bodies;
  bodies.fill(kFarMm);
  const double stem = brain_stem(point);
  const double inside = cavity(point, stem);
  const double skull = inside - kSkullMm;
  bodies[0] = head_hull(point, skull);
  bodies[1] = bodies[0] + kFatMm;
  bodies[2] = skull;
  bodies[3] = inside;
  // The brain's own distances cost most, and only the cavity can hold brain.
  if (inside < 0)
    add_brain(folds, point, stem, &bodies);
  return bodies;
}

} // namespace volsurf
