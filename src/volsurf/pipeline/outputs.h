// The files of a run.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/io/output_file.h"
#include "volsurf/pipeline/merged_volume.h"
#include "volsurf/pipeline/report.h"

#include <optional>
#include <vector>

namespace volsurf {

/// What the writers draw on.
struct Results {
  double delta;
  const Mesh &mesh;
  const EdgeField &field;
  const MergedVolume &merged;
  const Regions &regions;
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
  std::optional<PendingOutput> hierarchy_;
};

} // namespace volsurf
