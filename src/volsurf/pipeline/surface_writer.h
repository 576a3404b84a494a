// What every surface goes through at the end, however it was found: smoothing, check, file.
#pragma once

#include "volsurf/core/progress.h"
#include "volsurf/core/timer.h"
#include "volsurf/pipeline/finishing.h"
#include "volsurf/pipeline/outputs.h"

namespace volsurf {

/// What the stages leave behind them.
struct SurfaceSink {
  Outputs &outputs;
  Report &report;
  StageTimer &timer;
  const Progress &progress;
  const Provenance &provenance;
};

/// Finishes and writes the surfaces of a run.
class SurfaceWriter {
public:
  /// Keeps references to all but the finisher.
  SurfaceWriter(Finisher finisher, const Settings &settings, const SurfaceSink &sink);

  /// With --split components: announces the files of the components that the report counts as kept. Throws as
  /// Outputs::expect_parts().
  void expect_components() const;

  /// The whole mesh, in one file or, with --split components, in one for each. Throws OutputError.
  void write(Mesh mesh);

  /// The surface of one region, the `part`-th of those expected.
  void write_region(std::size_t part, RegionId number, Mesh mesh);

private:
  void smooth(Mesh &mesh);
  void write_part(std::size_t part, std::uint32_t number, const Mesh &mesh, double volume_before_mm3) const;
  void write_components(Mesh mesh);

  Finisher finisher_;
  const Settings &settings_;
  const SurfaceSink &sink_;
};

} // namespace volsurf
