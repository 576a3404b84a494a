// The files of a run.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/core/provenance.h"
#include "volsurf/io/output_file.h"
#include "volsurf/pipeline/merged_volume.h"
#include "volsurf/pipeline/report.h"
#include "volsurf/pipeline/selection.h"

#include <optional>
#include <vector>

namespace volsurf {

/// What the writers of volumes draw on.
struct Results {
  const EdgeField &field;
  const MergedVolume &merged;
  const Regions &regions;
  const Selection &selection;
};

/// All files that a run was asked for. They are written under other names, so that they can appear together, at the
/// end, or not at all. Throws OutputError.
class Outputs {
public:
  /// Keeps a reference to `settings`. Fails at once where a file cannot be made.
  explicit Outputs(const Settings &settings);

  /// The numbers of the regions or components that the surfaces are split into, ascending. Throws UsageError where they
  /// would make more than kMostFiles files, or one of them another file of this run.
  void expect_parts(const std::vector<std::uint32_t> &numbers);

  /// Writes the surface of one part, the `part`-th of those expected, or of the whole, number 0, in all formats that
  /// hold surfaces. Returns their names.
  std::vector<std::filesystem::path> write_surface(std::size_t part, const Mesh &mesh, const Provenance &provenance);

  void write_volumes(const Results &results, const Provenance &provenance);
  void write_report(const Report &report);

  /// Makes the files appear.
  void commit();

private:
  const Settings &settings_;
  std::vector<std::vector<PendingOutput>> surfaces_; // per part; one without a split
  std::vector<PendingOutput> vdb_volumes_;
  std::optional<PendingOutput> labels_;
  std::optional<PendingOutput> report_;
  std::optional<PendingOutput> hierarchy_;
};

/// More are hardly meant.
constexpr std::size_t kMostFiles = 1000;

} // namespace volsurf
