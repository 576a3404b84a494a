// The structure of a DICOM file, walked before GDCM sees it: GDCM aborts the program on some truncated files and reads
// others without a word.
#pragma once

#include <filesystem>

namespace volsurf {

/// True for files with DICOM's magic, "DICM" after 128 bytes.
bool begins_like_dicom(const std::filesystem::path &file);

/// Throws InputError unless the file's elements, with all sequences and packed pixel data, end within the file.
void check_complete_dicom(const std::filesystem::path &file);

} // namespace volsurf
