// Where the samples of a volume file lie, by its header: for checking that all of them are there before any memory is
// taken for them (ITK fills up what is missing in some formats), and for naming all files that the volume is made of.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace volsurf {

enum class VolumeFormat { nrrd, meta, nifti };

/// By extension, confirmed by the file's first bytes. Throws InputError.
VolumeFormat volume_format_of(const std::filesystem::path &path);

/// "NRRD", "MetaImage", "NIfTI"
std::string format_name(VolumeFormat format);

struct DataLayout {
  enum class Packing { raw, deflate, other };

  Packing packing = Packing::raw;
  std::vector<std::filesystem::path> data_files; ///< each holds an equal share of the samples
  bool detached = false;                         ///< the data files are not the header's file
  std::uint64_t packed_offset = 0;               ///< bytes of a file before its compressed stream
  std::uint64_t offset = 0;                      ///< bytes before the samples, in the file or the unpacked stream
  std::optional<std::uint64_t> data_bytes;       ///< of all samples, where the format's header says it by itself
};

/// Reads the header of a volume file. Throws InputError where it cannot be understood or a data file is missing.
DataLayout read_data_layout(const std::filesystem::path &path, VolumeFormat format);

/// Throws InputError unless the data files hold all of `data_bytes` bytes of samples.
void check_data_size(const std::filesystem::path &path, const DataLayout &layout, std::uint64_t data_bytes);

} // namespace volsurf
