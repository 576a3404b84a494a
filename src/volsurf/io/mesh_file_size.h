// Whether a surface's file is as long as its header promises.
#pragma once

#include <filesystem>

namespace volsurf {

/// VTK's readers take what is there of a file that is cut short, or abort the program. Throws InputError for an STL or
/// PLY file that ends before its last element, and for a PLY whose header cannot be understood. O(bytes).
void check_stl_size(const std::filesystem::path &path);
void check_ply_size(const std::filesystem::path &path);

} // namespace volsurf
