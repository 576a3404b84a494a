#include "volsurf/interop/openvdb_grid.h"

#include "volsurf/core/error.h"

#include <cassert>
#include <cstdio>
#include <fstream>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

namespace volsurf {

namespace {

/// Writes through a stream of ours, because io::File does not notice when the disk is full at its last flush.
class StreamArchive : public openvdb::io::Archive {
public:
  using Archive::write;
  void write_seekable(std::ostream &stream, const openvdb::GridCPtrVec &grids) const
  {
    Archive::write(stream, grids, /*seekable=*/true);
  }
};

/// OpenVDB multiplies row vectors from the left, so the rows are the grid's axes and its origin.
openvdb::math::Transform::Ptr index_to_world_transform(const Grid &grid, Frame frame)
{
  openvdb::Mat4d matrix = openvdb::Mat4d::identity();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 3; ++column) {
      const double lps = row < 3 ? grid.spacing_mm[row] * grid.direction[column][row] : grid.origin_mm[column];
      const bool turned = frame == Frame::ras && column < 2;
      matrix[row][column] = turned ? 0.0 - lps : lps + 0.0; // never -0
    }
  // The simplest map that fits, since some programs read only scales and translations.
  const openvdb::math::AffineMap map(matrix);
  return std::make_shared<openvdb::math::Transform>(openvdb::math::simplify(map.getAffineMap()));
}

template <typename VdbGrid, typename Value>
typename VdbGrid::Ptr to_vdb(const Grid &grid, const std::vector<Value> &values, Frame frame)
{
  using VdbValue = typename VdbGrid::ValueType;
  static_assert(sizeof(VdbValue) == sizeof(Value));
  assert(static_cast<std::int64_t>(values.size()) == grid.sample_count());
  const openvdb::CoordBBox box(openvdb::Coord(0), openvdb::Coord(static_cast<openvdb::Int32>(grid.size[0] - 1),
                                                                 static_cast<openvdb::Int32>(grid.size[1] - 1),
                                                                 static_cast<openvdb::Int32>(grid.size[2] - 1)));
  // Dense wants a pointer it may write through; copyFromDense only reads.
  auto *data = const_cast<VdbValue *>(reinterpret_cast<const VdbValue *>(values.data()));
  const openvdb::tools::Dense<VdbValue, openvdb::tools::LayoutXYZ> dense(box, data);
  auto result = VdbGrid::create(VdbValue(0));
  openvdb::tools::copyFromDense(dense, *result, VdbValue(0));
  result->setTransform(index_to_world_transform(grid, frame));
  return result;
}

void describe(openvdb::GridBase &grid, const char *name, const Provenance &provenance, Frame frame)
{
  grid.setName(name);
  grid.setCreator(provenance.version);
  grid.insertMeta("SPACE", openvdb::StringMetadata(frame_name(frame)));
  grid.insertMeta("Version", openvdb::StringMetadata(provenance.version));
  grid.insertMeta("Source", openvdb::StringMetadata(provenance.source));
  grid.insertMeta("Options", openvdb::StringMetadata(provenance.options));
}

/// Every archive gets a random UUID after its magic number, three version numbers and a flag. A fixed one in its place
/// makes equal input give equal bytes; OpenVDB only compares it to tell whether a file changed while it was open.
void fix_uuid(std::fstream &stream)
{
  constexpr std::streamoff kOffset = 8 + 3 * 4 + 1;
  constexpr char kUuid[] = "766f6c73-7572-4665-8000-000000000000";
  std::string found(sizeof(kUuid) - 1, ' ');
  stream.seekg(kOffset);
  stream.read(found.data(), static_cast<std::streamsize>(found.size()));
  if (found[8] != '-' || found[13] != '-' || found[18] != '-' || found[23] != '-')
    throw Error("this version of OpenVDB keeps its UUID elsewhere");
  stream.seekp(kOffset);
  stream.write(kUuid, sizeof(kUuid) - 1);
}

} // namespace

void write_vdb(const LabelVolume &regions, const Volume &gradient_magnitude, const std::filesystem::path &file,
               const Provenance &provenance, Frame frame)
{
  openvdb::initialize();
  const auto labels = to_vdb<openvdb::Int32Grid>(regions.grid, regions.labels, frame);
  const auto magnitude = to_vdb<openvdb::FloatGrid>(gradient_magnitude.grid, gradient_magnitude.samples, frame);
  describe(*labels, "regions", provenance, frame);
  describe(*magnitude, "gradient_magnitude", provenance, frame);
  magnitude->setGridClass(openvdb::GRID_FOG_VOLUME);
  try {
    std::fstream stream;
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    stream.open(file, std::ios::binary | std::ios::in | std::ios::out | std::ios::trunc);
    StreamArchive().write_seekable(stream, {labels, magnitude});
    fix_uuid(stream);
    stream.close();
  } catch (const std::exception &error) {
    throw OutputError(file.string() + ": cannot be written as OpenVDB (is the disk full?): " + error.what());
  }
}

} // namespace volsurf
