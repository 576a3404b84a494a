// The structure of a DICOM file, walked before GDCM sees it: GDCM aborts the program on some truncated files and reads
// others without a word.
#pragma once

#include <filesystem>

namespace volsurf {

/// True for files with DICOM's magic, "DICM" after 128 bytes.
bool begins_like_dicom(const std::filesystem::path &file);

/// Whether a file with that magic holds an image; others (reports, directories) are not for GDCM. Throws InputError
/// where its elements, with all sequences and packed pixel data, do not end within the file.
bool holds_complete_image(const std::filesystem::path &file);

} // namespace volsurf
