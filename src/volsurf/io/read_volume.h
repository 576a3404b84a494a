// Volumes from files.
#pragma once

#include "volsurf/core/volume.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace volsurf {

struct ReadOptions {
  std::string series_uid; ///< the series of a DICOM folder; needed where there are several; the start of its UID does
  std::function<void(const Grid &)> check_grid; ///< called when the header is known, before memory is taken; may throw
};

/// What was read, for the report.
struct SourceFile {
  std::string path;         ///< as it was given
  std::uintmax_t bytes = 0; ///< of all files: header and data, or the slices of a series
  std::string sha256;       ///< of the same bytes: header, then data; slices in order of position
};

struct InputVolume {
  Volume volume;          ///< every sample is finite
  std::string pixel_type; ///< of the samples in the file: "uint8", "int16", ..., "float64"
  SourceFile source;
  std::vector<std::string> warnings; ///< what the user should know, one line each
};

/// Reads NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd), NIfTI (.nii, .nii.gz), or a folder with one DICOM series.
/// Throws InputError, one line, for everything that is not a complete scalar 3-D volume of finite samples with two or
/// more on each axis, positive spacing and an invertible direction matrix; before any memory is taken, as far as the
/// header and the size of the (unpacked) data tell.
InputVolume read_volume(const std::filesystem::path &path, const ReadOptions &options = {});

} // namespace volsurf
