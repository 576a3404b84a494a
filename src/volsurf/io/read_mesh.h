// Triangle meshes from files, of this program and of others.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/interop/frame.h"

#include <filesystem>
#include <optional>

namespace volsurf {

struct InputMesh {
  Mesh mesh;                       ///< in LPS, with the cell arrays that volsurf knows, if they are there
  std::optional<Frame> frame_mark; ///< the frame that the file names; nothing where it names none
};

/// True for the extensions of surfaces, in either case: .vtp, .stl, .ply, .obj.
bool has_mesh_extension(const std::filesystem::path &path);

/// Reads a surface; polygons and strips are cut into triangles. The frame is the one that the file names in the manner
/// of 3D Slicer: SPACE=LPS or SPACE=RAS in an STL's header or a comment of a PLY or OBJ, a field data array SPACE in a
/// VTP; where it names none, `assumed`. Throws InputError, one line, for a file that cannot be read, holds no triangle,
/// or has a point that is not finite.
InputMesh read_mesh(const std::filesystem::path &path, Frame assumed = Frame::lps);

} // namespace volsurf
