// DICOM series. For read_volume only.
#pragma once

#include "volsurf/io/read_volume.h"

namespace volsurf {

/// Reads the series of a folder (not of the folders in it), or a single file that holds all slices. Throws InputError;
/// where there are several series and options name none, the message lists them.
InputVolume read_dicom_folder(const std::filesystem::path &folder, const ReadOptions &options);

} // namespace volsurf
