#include "volsurf/surface/extract.h"

#include "volsurf/core/parallel.h"
#include "volsurf/surface/point_numbering.h"

#include <algorithm>

namespace volsurf {

namespace {

constexpr std::int64_t kPlanesPerSlab = 16;

/// A cell next to a face, or what is outside the volume.
struct FaceSide {
  bool is_cell;
  BasinId basin;
  RegionId region;
  RegionId side;
};

class FaceSides {
public:
  FaceSides(const Sides &sides, const RegionsOfCells &regions) : sides_(sides), regions_(regions) {}

  FaceSide at(const Index3 &cell) const
  {
    const Index3 &n = regions_.cells.size;
    for (int axis = 0; axis < 3; ++axis)
      if (cell[axis] < 0 || cell[axis] >= n[axis])
        return {false, regions_.background_basin, regions_.background, sides_.outside};
    const BasinId basin = regions_.cells.basins[(cell[2] * n[1] + cell[1]) * n[0] + cell[0]];
    return {true, basin, regions_.of_basin[basin], sides_.of_basin[basin]};
  }

  /// Larger ids are smaller regions.
  bool first_is_inside(const FaceSide &first, const FaceSide &second) const
  {
    if (first.side == 0 || second.side == 0)
      return second.side == 0;
    if (first.region == regions_.background || second.region == regions_.background)
      return second.region == regions_.background;
    return first.region > second.region;
  }

private:
  const Sides &sides_;
  const RegionsOfCells &regions_;
};

/// The corners of a face's polygon, midpoints of pinched sides among them, turning about its axis. Corners alternate
/// with slots for the midpoints.
struct FacePolygon {
  std::array<PointId, 8> points;
  int count = 0;
  int first_midpoint = -1;

  void add(PointId point) { points[static_cast<std::size_t>(count++)] = point; }
};

FacePolygon polygon_of(const PointNumbering &numbering, const FacePosition &face)
{
  const int a = (face.axis + 1) % 3;
  const int b = (face.axis + 2) % 3;
  std::array<Index3, 4> corners{face.corner, face.corner, face.corner, face.corner};
  for (const int i : {1, 2})
    ++corners[i][a];
  for (const int i : {2, 3})
    ++corners[i][b];
  FacePolygon polygon;
  for (int i = 0; i < 4; ++i) {
    polygon.add(numbering.corner(face, corners[i]));
    const int axis = i % 2 == 0 ? a : b;
    const Index3 &low = i < 2 ? corners[i] : corners[(i + 1) % 4];
    if (numbering.has_midpoint(low, axis)) {
      if (polygon.first_midpoint < 0)
        polygon.first_midpoint = polygon.count;
      polygon.add(numbering.midpoint(face, low, axis));
    }
  }
  return polygon;
}

/// A fan from the first midpoint, so that no triangle is flat, or from the lowest corner.
Triangle fan_triangle(const FacePolygon &polygon, int i, bool flip)
{
  const int apex = std::max(polygon.first_midpoint, 0);
  const auto at = [&](int k) { return polygon.points[static_cast<std::size_t>((apex + k) % polygon.count)]; };
  return flip ? Triangle{at(0), at(i + 2), at(i + 1)} : Triangle{at(0), at(i + 1), at(i + 2)};
}

class MeshFiller {
public:
  MeshFiller(const KeptFaces &kept, const Sides &sides, const RegionsOfCells &regions, const PointNumbering &numbering,
             bool mirrored, Mesh &mesh)
      : kept_(kept), face_sides_(sides, regions), regions_(regions), numbering_(numbering), mirrored_(mirrored),
        mesh_(mesh)
  {
  }

  void resize(std::size_t triangles)
  {
    mesh_.triangles.resize(triangles);
    mesh_.region_a.resize(triangles);
    mesh_.region_b.resize(triangles);
    mesh_.persistence.resize(triangles);
    mesh_.component.resize(triangles);
    mesh_.cap.resize(triangles);
  }

  /// Writes the first two triangles of a face to its place; returns the number of further ones.
  int fill_face(FaceIndex index, const FacePosition &face)
  {
    const FacePolygon polygon = polygon_of(numbering_, face);
    const Attributes attributes = attributes_of(index, face);
    for (int i = 0; i < 2; ++i)
      fill_triangle(2 * static_cast<std::size_t>(index) + static_cast<std::size_t>(i), polygon, attributes, i);
    return polygon.count - 4;
  }

  /// Appends the triangles of a face with midpoints from the third on.
  void append_rest(FaceIndex index, const FacePosition &face)
  {
    const FacePolygon polygon = polygon_of(numbering_, face);
    const Attributes attributes = attributes_of(index, face);
    for (int i = 2; i < polygon.count - 2; ++i) {
      resize(mesh_.triangles.size() + 1);
      fill_triangle(mesh_.triangles.size() - 1, polygon, attributes, i);
    }
  }

private:
  struct Attributes {
    bool flip; // the polygon turns against the outward direction
    RegionId region_a;
    RegionId region_b;
    float persistence;
    ComponentId component;
    std::uint8_t cap;
  };

  Attributes attributes_of(FaceIndex index, const FacePosition &face) const
  {
    Index3 lower_cell = face.corner;
    --lower_cell[face.axis];
    FaceSide inside = face_sides_.at(lower_cell);
    FaceSide outside = face_sides_.at(face.corner);
    const bool lower_is_inside = face_sides_.first_is_inside(inside, outside);
    if (!lower_is_inside)
      std::swap(inside, outside);
    return {lower_is_inside == mirrored_,
            inside.region,
            outside.region,
            regions_.saliency(inside.basin, outside.basin),
            kept_.component[index],
            static_cast<std::uint8_t>(inside.is_cell && outside.is_cell ? 0 : 1)};
  }

  void fill_triangle(std::size_t at, const FacePolygon &polygon, const Attributes &attributes, int i)
  {
    mesh_.triangles[at] = fan_triangle(polygon, i, attributes.flip);
    mesh_.region_a[at] = attributes.region_a;
    mesh_.region_b[at] = attributes.region_b;
    mesh_.persistence[at] = attributes.persistence;
    mesh_.component[at] = attributes.component;
    mesh_.cap[at] = attributes.cap;
  }

  const KeptFaces &kept_;
  FaceSides face_sides_;
  const RegionsOfCells &regions_;
  const PointNumbering &numbering_;
  bool mirrored_;
  Mesh &mesh_;
};

void place_points(const PointNumbering &numbering, const Grid &grid, Mesh &mesh)
{
  mesh.points.resize(numbering.point_count());
  numbering.for_each_point([&](PointId point, const Vec3 &index) {
    const Vec3 world = index_to_world(grid, index);
    mesh.points[point] = {static_cast<float>(world[0]), static_cast<float>(world[1]), static_cast<float>(world[2])};
  });
}

} // namespace

Mesh extract_mesh(const KeptFaces &kept, const Grid &grid, const Sides &sides, const RegionsOfCells &regions,
                  bool manifold)
{
  const FaceSides face_sides(sides, regions);
  IsInside is_inside;
  if (manifold)
    is_inside = [&](const Index3 &cell) { return face_sides.at(cell).side != 0; };
  const PointNumbering numbering(kept.faces, is_inside);

  Mesh mesh;
  place_points(numbering, grid, mesh);
  MeshFiller filler(kept, sides, regions, numbering, is_mirrored(grid), mesh);
  filler.resize(2 * static_cast<std::size_t>(kept.faces.size()));
  const std::int64_t planes = kept.faces.samples()[2];
  std::vector<std::vector<std::pair<FaceIndex, FacePosition>>> unfinished(
      static_cast<std::size_t>(slab_count(planes, kPlanesPerSlab)));
  parallel_for_slabs(planes, kPlanesPerSlab, [&](const Slab &slab) {
    kept.faces.for_each(slab.begin, slab.end, [&](FaceIndex index, const FacePosition &face) {
      if (filler.fill_face(index, face) > 0)
        unfinished[static_cast<std::size_t>(slab.index)].emplace_back(index, face);
    });
  });
  for (const auto &slab : unfinished)
    for (const auto &[index, face] : slab)
      filler.append_rest(index, face);
  return mesh;
}

} // namespace volsurf
