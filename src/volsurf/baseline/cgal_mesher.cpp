#include "volsurf/baseline/cgal_mesher.h"

#include "volsurf/baseline/level_crossings.h"
#include "volsurf/core/vec3.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <limits>
#include <unordered_map>
#include <utility>

namespace volsurf {

namespace {

constexpr std::uint64_t kBytesPerPoint = 2400; // measured: its cells, their circumcentres, the queue

/// A vertex or cell that is ordered by the time of its birth, not by its address, so that each run does the same.
template <typename Base> class Numbered : public Base {
public:
  // CGAL asks for these names.
  using Has_timestamp = CGAL::Tag_true;                 // NOLINT(readability-identifier-naming)
  template <typename Triangulation> struct Rebind_TDS { // NOLINT(readability-identifier-naming)
    using Other = Numbered<typename Base::template Rebind_TDS<Triangulation>::Other>;
  };
  using Base::Base;

  std::size_t time_stamp() const { return birth_; }
  void set_time_stamp(std::size_t birth) { birth_ = birth; }

private:
  std::size_t birth_ = static_cast<std::size_t>(-1);
};

using Kernel = CGAL::Robust_circumcenter_traits_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Vertex = Numbered<CGAL::Surface_mesh_vertex_base_3<Kernel>>;
using Cell = Numbered<
    CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<Kernel, CGAL::Surface_mesh_cell_base_3<Kernel>>>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;
using Complex = CGAL::Complex_2_in_triangulation_3<Triangulation>;
using Position = Kernel::Point_3;

/// The mesher works in mm along the grid's own axes.
Vec3 index_of(const Position &p, const Grid &grid)
{
  return {p.x() / grid.spacing_mm[0], p.y() / grid.spacing_mm[1], p.z() / grid.spacing_mm[2]};
}

/// The volume as the mesher asks for it.
class Body {
public:
  Body(const Volume &volume, double iso) : volume_(&volume), iso_(iso) {}

  /// -1 inside, 1 outside: the mesher looks at the sign only.
  double operator()(const Position &p) const { return reaches(*volume_, iso_, index_of(p, volume_->grid)) ? -1 : 1; }

private:
  const Volume *volume_;
  double iso_;
};

using Surface = CGAL::Implicit_surface_3<Kernel, Body>;
using Oracle = Surface::Surface_mesher_traits_3;
using Criteria = CGAL::Surface_mesh_default_criteria_3<Triangulation>;
using Mesher = CGAL::Surface_mesher_generator<Complex, Oracle, Criteria, CGAL::Manifold_tag>::type;

Kernel::Sphere_3 sphere_around(const Grid &grid)
{
  Vec3 half{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    half[axis] = grid.spacing_mm[axis] * static_cast<double>(grid.size[axis] - 1) / 2;
  return {Position(half[0], half[1], half[2]), 1.1 * dot(half, half)};
}

/// Far outside, so that the triangulation is never flat. No triangle of theirs is small enough to stay.
void insert_far_corners(const Kernel::Sphere_3 &sphere, Triangulation &triangulation)
{
  const double far = 8 * std::sqrt(sphere.squared_radius());
  for (const auto &corner : {Kernel::Vector_3(1, 1, 1), Kernel::Vector_3(1, -1, -1), Kernel::Vector_3(-1, 1, -1),
                             Kernel::Vector_3(-1, -1, 1)})
    triangulation.insert(sphere.center() + far * corner);
}

void insert_seeds(const std::vector<Vec3> &seeds, const Grid &grid, Triangulation &triangulation,
                  const Progress &progress)
{
  constexpr std::size_t kAtOnce = 20000;
  std::vector<Position> points;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const Vec3 &seed = seeds[i];
    points.emplace_back(seed[0] * grid.spacing_mm[0], seed[1] * grid.spacing_mm[1], seed[2] * grid.spacing_mm[2]);
    if (points.size() < kAtOnce && i + 1 < seeds.size())
      continue;
    report_progress(progress, "surface", 0);
    triangulation.insert(points.begin(), points.end());
    points.clear();
  }
}

void require_memory(const Triangulation &triangulation, const CgalMesherOptions &options)
{
  const std::uint64_t bytes = kBytesPerPoint * triangulation.number_of_vertices();
  if (options.most_memory_bytes != 0 && bytes > options.most_memory_bytes)
    throw InputError("CGAL's mesher has outgrown its memory at " + std::to_string(triangulation.number_of_vertices()) +
                     " points");
}

/// Whether all triangles are as small and well shaped as they have to be; edges of more than two may be left.
bool meets_criteria(const Mesher &mesher)
{
  using Base = CGAL::Surface_mesher::Surface_mesher_base<Complex, Surface, Oracle, Criteria>;
  return static_cast<const Base &>(mesher).no_longer_element_to_refine_impl();
}

/// Where the surface itself touches itself, mending edges of more than two triangles would never end: at most as many
/// steps go into it as there are points before.
void refine(Mesher &mesher, const Triangulation &triangulation, const CgalMesherOptions &options,
            const Progress &progress)
{
  constexpr std::size_t kStepsAtOnce = 1000;
  const auto seeds = static_cast<double>(triangulation.number_of_vertices());
  std::size_t most_steps = std::numeric_limits<std::size_t>::max();
  mesher.init();
  for (std::size_t step = 0; step < most_steps && !mesher.is_algorithm_done(); ++step) {
    if (most_steps == std::numeric_limits<std::size_t>::max() && meets_criteria(mesher))
      most_steps = step + triangulation.number_of_vertices();
    mesher.one_step(CGAL::Null_mesh_visitor());
    if (step % kStepsAtOnce != 0)
      continue;
    require_memory(triangulation, options);
    report_progress(progress, "surface", 1 - seeds / static_cast<double>(triangulation.number_of_vertices()));
  }
}

/// Takes over facets as triangles, and of the points those that they need.
class MeshBuilder {
public:
  explicit MeshBuilder(const Grid &grid) : grid_(grid) {}

  void add(const std::array<Triangulation::Vertex_handle, 3> &corners)
  {
    Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] = point_id(corners[i]);
    if (is_mirrored(grid_))
      std::swap(triangle[1], triangle[2]);
    mesh_.triangles.push_back(triangle);
  }

  Mesh take() { return std::move(mesh_); }

private:
  PointId point_id(Triangulation::Vertex_handle vertex)
  {
    const auto [entry, is_new] = ids_.emplace(vertex, static_cast<PointId>(mesh_.points.size()));
    if (is_new) {
      const Vec3 p = index_to_world(grid_, index_of(vertex->point(), grid_));
      mesh_.points.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
    }
    return entry->second;
  }

  const Grid &grid_;
  std::unordered_map<Triangulation::Vertex_handle, PointId> ids_;
  Mesh mesh_;
};

/// The circumcentres of a facet's two cells lie on the two sides of the surface; CGAL lists the facet's corners
/// counter-clockwise as seen from its own cell.
Mesh mesh_of(const Triangulation &triangulation, const Body &body, const Grid &grid)
{
  MeshBuilder builder(grid);
  for (auto facet = triangulation.finite_facets_begin(); facet != triangulation.finite_facets_end(); ++facet) {
    const auto &[cell, index] = *facet;
    if (!cell->is_facet_on_surface(index))
      continue;
    std::array<Triangulation::Vertex_handle, 3> corners{};
    for (int i = 0; i < 3; ++i)
      corners[static_cast<std::size_t>(i)] = cell->vertex(Triangulation::vertex_triple_index(index, i));
    const bool cell_is_inside = !triangulation.is_infinite(cell) && body(triangulation.dual(cell)) < 0;
    if (cell_is_inside)
      std::swap(corners[1], corners[2]);
    builder.add(corners);
  }
  return builder.take();
}

} // namespace

bool has_cgal_mesher()
{
  return true;
}

Mesh cgal_surface(const Volume &volume, double iso, const CgalMesherOptions &options, const Progress &progress)
{
  const Grid &grid = volume.grid;
  const std::vector<Vec3> seeds = level_crossings(volume, iso, options.seed_block);
  if (seeds.empty())
    return {};
  const Kernel::Sphere_3 sphere = sphere_around(grid);
  Triangulation triangulation;
  insert_far_corners(sphere, triangulation);
  insert_seeds(seeds, grid, triangulation, progress);
  require_memory(triangulation, options);

  const double voxel = smallest_spacing_mm(grid);
  constexpr double kPrecision = 1e-3; // of a point's place on the surface, in voxels
  const Body body(volume, iso);
  const Surface surface(body, sphere, kPrecision * voxel / std::sqrt(sphere.squared_radius()));
  const Criteria criteria(options.smallest_angle_degrees, options.facet_radius * voxel, options.facet_distance * voxel);
  Complex complex(triangulation);
  const Oracle oracle;
  Mesher mesher(complex, surface, oracle, criteria);
  refine(mesher, triangulation, options, progress);
  return mesh_of(triangulation, body, grid);
}

} // namespace volsurf
