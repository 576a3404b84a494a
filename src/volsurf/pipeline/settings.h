// All that a run can be told. Defaults stand in the stages' own options, once.
#pragma once

#include "volsurf/field/gradient.h"
#include "volsurf/interop/frame.h"
#include "volsurf/pipeline/method.h"
#include "volsurf/surface/components.h"
#include "volsurf/surface/smoothing.h"
#include "volsurf/topology/cubical_complex.h"
#include "volsurf/topology/delta_choice.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace volsurf {

enum class SurfaceKind {
  all,  ///< between all regions
  hull, ///< between the background region and the others
};

/// Whether each output is one file or one per part.
enum class Split {
  none,
  components, ///< of the kept surface, as they are in it
  regions,    ///< of those that were asked for: the closed surface around each
};

struct Settings {
  std::filesystem::path input;
  std::string series_uid; ///< of a DICOM folder with several series

  std::optional<int> median_voxels; ///< radius of the median filter; not set: none, or what a hierarchy was made with
  std::optional<int> oversampling;  ///< of the grid; not set: as choose_grid.h says, or what a hierarchy was made with
  Method method = Method::volsurf;
  std::optional<double> iso; ///< where the method takes an iso-value; not set: Otsu's
  FieldOptions field;
  DeltaChoice delta = AutomaticDelta{}; ///< the persistence that a boundary must reach, in intensity per mm
  std::optional<Exterior> exterior;     ///< not set: none, or what a stored hierarchy was made with

  SurfaceKind surface = SurfaceKind::all;
  std::vector<Vec3> seeds_mm; ///< in `frame`; not empty: only the boundaries of the regions that hold these points
  std::vector<std::int64_t> region_numbers; ///< >= 1, as in the mesh's arrays; beside the seeds' regions
  double min_volume_mm3 = 0;                ///< >= 0; smaller regions (hull: islands) are not asked for
  ComponentOptions components;
  SmoothingOptions smoothing;
  bool snap = true; ///< move points to the edge of the volume

  std::vector<std::filesystem::path> outputs; ///< by extension; may be empty where labels or a report are wanted
  Split split = Split::none;
  std::optional<std::filesystem::path> labels;    ///< region of each cell, .nrrd or, for 3D Slicer, .seg.nrrd
  std::optional<std::filesystem::path> report;    ///< JSON
  std::optional<std::filesystem::path> hierarchy; ///< of --save-hierarchy, .volsurf
  Frame frame = Frame::lps;

  int threads = 0;                               ///< 0: all that are available
  std::optional<std::uint64_t> max_memory_bytes; ///< not set: what is available
};

/// What a run may take: --max-memory, or what is available now.
std::uint64_t allowed_memory_bytes(const Settings &settings);

/// The options that decide the result, as a command line would give them, with the delta that was used: the provenance
/// of the outputs. Threads and file names are left out, so that they do not show in the bytes.
std::string describe(const Settings &settings, double delta);

/// An option's value as a command line would give it: "all", "3" or "5%"; "faces", "area" or "radius".
std::string keep_text(const Keep &keep);
std::string rank_by_text(RankBy rank_by);

/// "none", "components" or "regions".
std::string split_text(Split split);

/// The program and its version, "volsurf 1.0.0".
std::string version_text();

} // namespace volsurf
