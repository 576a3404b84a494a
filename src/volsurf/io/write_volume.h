// Volumes as NRRD files.
#pragma once

#include "volsurf/core/provenance.h"
#include "volsurf/core/volume.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace volsurf {

enum class PixelType { uint8, int16, uint16, float32 };

/// Throws UsageError unless the extension is .nrrd, the one that write_labels and write_volume write.
void require_nrrd_extension(const std::filesystem::path &path);

using KeyValues = std::vector<std::pair<std::string, std::string>>;

/// Writes labels in the smallest of uint8, uint16 and uint32 that holds them, gzip compressed, at the grid's place in
/// the world, with Version, Source and Options and what `more` holds as key/value pairs, by key. The same input makes
/// the same bytes. Throws OutputError.
void write_labels(const LabelVolume &labels, const std::filesystem::path &file, const Provenance &provenance,
                  const KeyValues &more = {});

/// The same for scalars. Integer types are rounded to nearest and clamped to their range.
void write_volume(const Volume &volume, PixelType type, const std::filesystem::path &file,
                  const Provenance &provenance);

} // namespace volsurf
