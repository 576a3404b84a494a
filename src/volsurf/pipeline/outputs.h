// The files of a run.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/io/output_file.h"
#include "volsurf/pipeline/report.h"
#include "volsurf/topology/region_merge.h"

#include <optional>
#include <vector>

namespace volsurf {

/// What the writers draw on.
struct Results {
  double delta;
  const Mesh &mesh;
  const EdgeField &field;
  const RegionMerge &merge;
  const Regions &regions;
  const Grid &grid;
};

/// All files that a run was asked for. They are written under other names, so that they can appear together, at the
/// end, or not at all. Throws OutputError.
class Outputs {
public:
  /// Keeps a reference to `settings`. Fails at once where a file cannot be made.
  explicit Outputs(const Settings &settings);

  void write_results(const Results &results);
  void write_report(const Report &report);

  /// Makes the files appear.
  void commit();

private:
  const Settings &settings_;
  std::vector<PendingOutput> surfaces_;
  std::optional<PendingOutput> labels_;
  std::optional<PendingOutput> report_;
};

} // namespace volsurf
