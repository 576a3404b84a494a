#include "volsurf/pipeline/stored_merge.h"

#include "support/array_file_bytes.h"
#include "support/contains.h"
#include "support/fields.h"
#include "support/grids.h"
#include "support/merge_of_field.h"
#include "support/temporary_folder.h"
#include "volsurf/core/error.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <functional>

using namespace volsurf;
using namespace volsurf::support;
using namespace volsurf::test;

namespace {

/// A volume whose edge strengths make this field, merged.
MergedVolume merged_of(const Field &field, Exterior exterior)
{
  MergedVolume merged;
  merged.input.volume.grid.size = field.size;
  for (const float value : field.values)
    merged.input.volume.samples.push_back(-value);
  merged.input.source = {"folder/scan.nrrd", 1234, std::string(64, 'a')};
  merged.input.pixel_type = "int16";
  merged.input.warnings = {"a \"warning\"", "and\nanother"};
  merged.series_uid = "1.2.3";
  merged.median_voxels = 2;
  merged.field.edge_map = true;
  merged.exterior = exterior;
  merged.non_finite_gradients = 5;
  merge_input(merged);
  return merged;
}

/// So that infinities and the signs of zeros count.
bool same_bytes(const std::vector<float> &a, const std::vector<float> &b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

void expect_equal(const Hierarchy &a, const Hierarchy &b)
{
  RC_ASSERT(same_bytes(a.persistence, b.persistence));
  RC_ASSERT(a.ancestor == b.ancestor);
  RC_ASSERT(a.by_rank == b.by_rank);
  RC_ASSERT(a.rank == b.rank);
  RC_ASSERT(a.roots == b.roots);
  RC_ASSERT(same_bytes(a.values, b.values));
  RC_ASSERT(a.cell_counts == b.cell_counts);
  RC_ASSERT(a.exterior == b.exterior);
  RC_ASSERT(a.background == b.background);
}

MergedVolume stored_and_read(const MergedVolume &merged)
{
  const TemporaryFolder folder;
  write_merge(merged, folder / "a.volsurf");
  return read_merge(folder / "a.volsurf");
}

Exterior any_exterior()
{
  return *rc::gen::element(Exterior::none, Exterior::infinite);
}

} // namespace

RC_GTEST_PROP(StoredMerge, IsReadAsItWasWritten, ())
{
  Dice dice(*random_seed());
  MergedVolume merged = merged_of(*random_field(), any_exterior());
  const Index3 size = merged.input.volume.grid.size;
  merged.input.volume.grid = any_grid(dice);
  merged.input.volume.grid.size = size;
  const MergedVolume read = stored_and_read(merged);

  expect_equal(read.merge.hierarchy, merged.merge.hierarchy);
  const CellLabels &cells = merged.merge.cells;
  RC_ASSERT(read.merge.cells.size == cells.size);
  RC_ASSERT(std::equal(cells.basins.begin(), cells.basins.end(), read.merge.cells.basins.begin(),
                       read.merge.cells.basins.end()));
  RC_ASSERT(same_bytes(read.input.volume.samples, merged.input.volume.samples));
  const Grid &grid = merged.input.volume.grid;
  const Grid &read_grid = read.input.volume.grid;
  RC_ASSERT(read_grid.size == grid.size);
  RC_ASSERT(read_grid.spacing_mm == grid.spacing_mm);
  RC_ASSERT(read_grid.origin_mm == grid.origin_mm);
  RC_ASSERT(read_grid.direction == grid.direction);
}

RC_GTEST_PROP(StoredMerge, IsCutAsTheOneThatWasWritten, ())
{
  const MergedVolume merged = merged_of(*random_field(), any_exterior());
  const MergedVolume read = stored_and_read(merged);
  for (const float delta : deltas_that_matter(positive_persistences(merged.merge.hierarchy)))
    RC_ASSERT(partition_of(read.merge, delta) == partition_of(merged.merge, delta));
}

RC_GTEST_PROP(StoredMerge, KeepsSamplesOfEveryKind, ())
{
  MergedVolume merged = merged_of(*random_field(), Exterior::none);
  Dice dice(*random_seed());
  static constexpr std::array<std::int64_t, 6> kLimits{255, 256, 32767, 32768, 65535, 65536};
  const std::int64_t high = kLimits[static_cast<std::size_t>(dice.between(0, 5))];
  const std::int64_t low = dice.one_in(2) ? 0 : dice.one_in(2) ? -32768 : -32769;
  auto &samples = merged.input.volume.samples;
  for (float &sample : samples)
    sample = static_cast<float>(dice.between(low, high));
  samples[0] = static_cast<float>(low);
  samples[1] = static_cast<float>(high);
  samples[2] = dice.one_in(4) ? -0.0F : dice.one_in(3) ? 0.5F : 0.0F;
  RC_ASSERT(same_bytes(stored_and_read(merged).input.volume.samples, samples));
}

namespace {

/// A small merge with an exterior.
class StoredMergeFile : public testing::Test {
protected:
  StoredMergeFile()
  {
    Field field{{7, 6, 6}, {}};
    Dice dice(7);
    for (int i = 0; i < 7 * 6 * 6; ++i)
      field.values.push_back(-static_cast<float>(dice.between(0, 999)) / 64.0F);
    merged = merged_of(field, Exterior::infinite);
    write_merge(merged, path);
    bytes = read_file(path);
  }

  /// What is wrong with the file; empty where it can be read.
  std::string objection() const
  {
    try {
      read_merge(path);
    } catch (const InputError &error) {
      return error.what();
    }
    return "";
  }

  void expect_refused(const std::string &part) const
  {
    const std::string what = objection();
    EXPECT_TRUE(contains(what, part));
    EXPECT_EQ(what.rfind(path.string() + ": found ", 0), 0U) << what;
  }

  /// `damage` changes the merge before it is written, so that the checksum is right.
  void expect_refused_with(const std::string &part, const std::function<void(MergedVolume &)> &damage)
  {
    const Hierarchy hierarchy = merged.merge.hierarchy;
    const InputVolume input = merged.input;
    damage(merged);
    write_merge(merged, path);
    expect_refused(part);
    merged.merge.hierarchy = hierarchy;
    merged.input = input;
  }

  void expect_refused_hierarchy(const std::string &part, const std::function<void(Hierarchy &)> &damage)
  {
    expect_refused_with(part, [&](MergedVolume &m) { damage(m.merge.hierarchy); });
  }

  void expect_refused_grid(const std::string &part, const std::function<void(Grid &)> &damage)
  {
    expect_refused_with(part, [&](MergedVolume &m) { damage(m.input.volume.grid); });
  }

  /// Replaces a part of the header.
  void expect_refused_header(const std::string &part, const std::string &by, const std::string &found) const
  {
    write_file(path, with_checksum(replaced(without_checksum(bytes), part, by)));
    expect_refused(found);
  }

  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.volsurf";
  MergedVolume merged;
  std::string bytes;
};

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

} // namespace

TEST_F(StoredMergeFile, TellsHowItWasMade)
{
  const MergedVolume read = read_merge(path);
  EXPECT_TRUE(read.is_stored);
  EXPECT_EQ(read.input.source.path, "scan.nrrd") << "without its folder";
  EXPECT_EQ(read.input.source.bytes, merged.input.source.bytes);
  EXPECT_EQ(read.input.source.sha256, merged.input.source.sha256);
  EXPECT_EQ(read.input.pixel_type, merged.input.pixel_type);
  EXPECT_EQ(read.input.warnings, merged.input.warnings);
  EXPECT_EQ(read.series_uid, merged.series_uid);
  EXPECT_EQ(read.median_voxels, merged.median_voxels);
  EXPECT_EQ(read.field.sigma_mm, merged.field.sigma_mm);
  EXPECT_EQ(read.field.edge_map, merged.field.edge_map);
  EXPECT_EQ(read.exterior, merged.exterior);
  EXPECT_EQ(read.non_finite_gradients, merged.non_finite_gradients);
}

TEST_F(StoredMergeFile, IsTheSameWhenItIsReadAndWritten)
{
  write_merge(read_merge(path), folder / "b.volsurf");
  EXPECT_EQ(read_file(folder / "b.volsurf"), bytes);
}

TEST_F(StoredMergeFile, IsKnownByItsBytesWhateverItsName)
{
  std::filesystem::rename(path, folder / "a.nrrd");
  EXPECT_TRUE(is_stored_merge(folder / "a.nrrd"));
  write_file(path, "NRRD0004\n");
  EXPECT_FALSE(is_stored_merge(path));
}

TEST_F(StoredMergeFile, IsRefusedWhereOneByteIsAnother)
{
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << i % 8));
    write_file(path, damaged);
    EXPECT_NE(objection(), "") << "byte " << i;
  }
}

TEST_F(StoredMergeFile, IsRefusedWhereItEndsTooSoon)
{
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    write_file(path, bytes.substr(0, length));
    EXPECT_NE(objection(), "") << length << " bytes";
  }
}

TEST_F(StoredMergeFile, WithAWrongHierarchyIsRefused)
{
  ASSERT_GE(merged.merge.hierarchy.basin_count(), 3U);
  const auto last = static_cast<BasinId>(merged.merge.hierarchy.basin_count() - 1);
  expect_refused_hierarchy("an ancestor that does not exist", [&](auto &h) { h.ancestor[0] = last + 1; });
  const std::string not_before = "an ancestor that is not before its basin";
  expect_refused_hierarchy(not_before, [](auto &h) { h.ancestor[h.by_rank[1]] = h.by_rank[1]; });
  expect_refused_hierarchy(not_before, [](auto &h) { h.ancestor[h.by_rank[1]] = h.by_rank[2]; });
  expect_refused_hierarchy(not_before, [](auto &h) { h.ancestor[h.by_rank[0]] = h.by_rank[1]; });
  const std::string no_rank = "a rank without a basin or a persistence";
  expect_refused_hierarchy(no_rank, [&](auto &h) { h.by_rank[1] = last + 1; });
  expect_refused_hierarchy(no_rank, [](auto &h) { h.persistence[h.by_rank[1]] = kNaN; });
  expect_refused_hierarchy(no_rank, [](auto &h) { h.persistence[h.by_rank.back()] = -1; });
  const std::string no_order = "not in the order of their persistence";
  expect_refused_hierarchy(no_order, [](auto &h) { h.by_rank[2] = h.by_rank[1]; });
  expect_refused_hierarchy(no_order, [](auto &h) { std::swap(h.by_rank[1], h.by_rank[2]); });
  expect_refused_hierarchy(no_order, [](auto &h) { h.persistence[h.by_rank[2]] = kInfinity; });
  expect_refused_hierarchy("no basin that lasts", [](auto &h) { h.persistence[h.by_rank[0]] = 1e30F; });
  const std::string no_root = "a basin whose root is not in it";
  expect_refused_hierarchy(no_root, [](auto &h) { h.roots[0] = 1'000'000; });
  expect_refused_hierarchy(no_root, [](auto &h) { h.roots[0] = -1; });
  expect_refused_hierarchy(no_root, [](auto &h) { h.roots[0] = h.roots[1]; });
  expect_refused_hierarchy(no_root, [](auto &h) { h.roots[*h.exterior] = 0; });
  expect_refused_hierarchy("a background that is no basin", [&](auto &h) { h.background = last + 1; });
  expect_refused_hierarchy("a background that is no basin", [&](auto &h) { h.exterior = last + 1; });
  expect_refused_hierarchy("a value of \"exterior\"", [](auto &h) { h.exterior.reset(); });
}

TEST_F(StoredMergeFile, WithArraysOfOtherLengthsIsRefused)
{
  expect_refused_hierarchy("array \"ancestor\"", [](auto &h) { h.ancestor.pop_back(); });
  expect_refused_hierarchy("array \"ancestor\"", [](auto &h) { h.persistence.push_back(0); });
  expect_refused_hierarchy("a number of basins out of range", [](auto &h) { h.persistence.clear(); });
  expect_refused_with("array \"samples\"", [](MergedVolume &m) { m.input.volume.samples.pop_back(); });
  expect_refused_grid("array \"basins\"", [](Grid &grid) { ++grid.size[2]; });
  expect_refused_header("\"name\":\"basins\",\"type\":\"uint32\"", "\"name\":\"basins\",\"type\":\"float32\"",
                        "array \"basins\"");
  expect_refused_header("\"name\":\"roots\"", "\"name\":\"loots\"", "no array \"roots\"");
}

TEST_F(StoredMergeFile, WithACellInNoBasinIsRefused)
{
  merged.merge.cells.basins[3] = static_cast<BasinId>(merged.merge.hierarchy.basin_count());
  write_merge(merged, path);
  expect_refused("a cell in a basin that does not exist");
}

TEST_F(StoredMergeFile, WithASampleThatIsNotFiniteIsRefused)
{
  expect_refused_with("a sample that is not finite", [](MergedVolume &m) { m.input.volume.samples[5] = kNaN; });
  expect_refused_with("a sample that is not finite", [](MergedVolume &m) { m.input.volume.samples[5] = -kInfinity; });
}

TEST_F(StoredMergeFile, OnAnImpossibleGridIsRefused)
{
  expect_refused_grid("\"size\"", [](Grid &grid) { grid.size[1] = 1; });
  expect_refused_grid("\"size\"", [](Grid &grid) { grid.size[0] = -4; });
  expect_refused_grid("\"size\"", [](Grid &grid) { grid.size = {1L << 40, 1L << 40, 1L << 40}; });
  expect_refused_grid("\"spacing_mm\"", [](Grid &grid) { grid.spacing_mm[2] = 0; });
  expect_refused_grid("\"direction\"", [](Grid &grid) { grid.direction[2] = grid.direction[1]; });
  expect_refused_grid("facts that cannot be understood", [](Grid &grid) { grid.origin_mm[0] = kInfinity; });
  expect_refused_header("\"size\":[7,", "\"size\":[7.5,", "\"size\"");
  expect_refused_header("\"size\":[7,6,6]", "\"size\":[7,6]", "\"size\"");
}

TEST_F(StoredMergeFile, WithFactsOutOfRangeIsRefused)
{
  expect_refused_header("\"edge_map\":true", "\"edge_map\":1", "facts that cannot be understood");
  expect_refused_header("\"exterior\":\"infinite\"", "\"exterior\":\"sphere\"", "\"exterior\"");
  expect_refused_header("\"pixel_type\":\"int16\",", "", "facts that cannot be understood");
  expect_refused_header("\"bytes\":1234", "\"bytes\":-1", "\"bytes\"");
  expect_refused_header("\"background\":", "\"background\":99999999999", "\"background\"");
  expect_refused_header("\"median_voxels\":2", "\"median_voxels\":4", "\"median_voxels\"");
  expect_refused_header("\"sigma_mm\":null,\"edge_map\":true", "\"sigma_mm\":-1,\"edge_map\":false", "\"sigma_mm\"");
  expect_refused_header("\"sigma_mm\":null,\"edge_map\":true", "\"sigma_mm\":1e9,\"edge_map\":false", "\"sigma_mm\"");
}

TEST_F(StoredMergeFile, AsksBeforeItTakesMemory)
{
  const auto refuse = [](const Grid &grid) { throw InputError(std::to_string(grid.sample_count()) + " are too many"); };
  EXPECT_THROW(read_merge(path, refuse), InputError);
}
