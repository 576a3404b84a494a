// Triangle meshes as files.
#pragma once

#include "volsurf/core/mesh.h"
#include "volsurf/core/provenance.h"
#include "volsurf/interop/frame.h"

#include <filesystem>
#include <string>
#include <vector>

namespace volsurf {

enum class OutputKind { vtp, stl, ply, obj, vdb };

/// The kind that a file's extension asks for, in either case. Throws UsageError for any other.
OutputKind output_kind_of(const std::filesystem::path &path);

/// Writes a mesh as vtp, stl (binary), ply (binary) or obj; vdb holds no mesh. Coordinates are millimetres in `frame`,
/// and the file says which:
/// - vtp: all arrays, by cell; field data SPACE, Version, Source, Options; inline binary data, zlib
/// - stl: the header holds SPACE and, as far as 80 bytes go, the version and source
/// - ply, obj: comments SPACE, Version, Source, Options; points and triangles only
/// The same input makes the same bytes. Throws OutputError, also where the disk is full.
void write_mesh(const Mesh &mesh, OutputKind kind, const std::filesystem::path &file, const Provenance &provenance,
                Frame frame);

/// One value for each point of a mesh.
struct PointArray {
  std::string name;
  std::vector<float> values;
};

/// The same for a vtp file, with further arrays by point; the first of them is the one that a viewer shows at once.
void write_vtp(const Mesh &mesh, const std::vector<PointArray> &arrays, const std::filesystem::path &file,
               const Provenance &provenance, Frame frame);

} // namespace volsurf
