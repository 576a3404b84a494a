#include "volsurf/io/write_volume.h"

#include "volsurf/core/error.h"
#include "volsurf/io/data_layout.h"
#include "volsurf/io/itk_image_io.h"
#include "volsurf/io/output_file.h"

#include <algorithm>
#include <cmath>
#include <itkMetaDataObject.h>
#include <itkNrrdImageIO.h>
#include <limits>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

using Component = itk::IOComponentEnum;

itk::NrrdImageIO::Pointer describe(const Grid &grid, Component type, const fs::path &file, const KeyValues &fields)
{
  const auto io = itk::NrrdImageIO::New();
  io->SetFileName(file.string());
  io->SetNumberOfDimensions(3);
  io->SetPixelType(itk::IOPixelEnum::SCALAR);
  io->SetNumberOfComponents(1);
  io->SetComponentType(type);
  io->SetUseCompression(true);
  itk::ImageIORegion region(3);
  for (unsigned int axis = 0; axis < 3; ++axis) {
    const auto samples = static_cast<itk::SizeValueType>(grid.size[axis]);
    io->SetDimensions(axis, samples);
    io->SetSpacing(axis, grid.spacing_mm[axis]);
    io->SetOrigin(axis, grid.origin_mm[axis]);
    io->SetDirection(axis,
                     std::vector<double>{grid.direction[0][axis], grid.direction[1][axis], grid.direction[2][axis]});
    region.SetSize(axis, samples);
  }
  io->SetIORegion(region);
  itk::MetaDataDictionary &dictionary = io->GetMetaDataDictionary();
  for (const auto &[key, value] : fields)
    itk::EncapsulateMetaData<std::string>(dictionary, key, value);
  return io;
}

KeyValues fields_of(const Provenance &provenance)
{
  return {{"Version", provenance.version}, {"Source", provenance.source}, {"Options", provenance.options}};
}

/// ITK does not look at the result of its last flush, so the compressed data are unpacked again. A file cut within its
/// header tells no packing.
void check_written(const fs::path &file, std::uint64_t data_bytes)
{
  bool complete = false;
  try {
    const DataLayout layout = read_data_layout(file, VolumeFormat::nrrd);
    check_data_size(file, layout, data_bytes);
    complete = layout.packing == DataLayout::Packing::deflate;
  } catch (const InputError &) {
  }
  if (!complete)
    throw OutputError(file.string() + ": cannot be written (is the disk full?)");
}

template <typename Value>
void write(const Grid &grid, Component type, const std::vector<Value> &values, const fs::path &file,
           const KeyValues &fields)
{
  const QuietItk quiet;
  try {
    describe(grid, type, file, fields)->Write(values.data());
  } catch (const itk::ExceptionObject &error) {
    throw OutputError(file.string() + ": cannot be written: " + one_line(error));
  }
  check_written(file, values.size() * sizeof(Value));
}

template <typename Value> std::vector<Value> narrowed(const std::vector<std::uint32_t> &labels)
{
  std::vector<Value> values(labels.size());
  std::transform(labels.begin(), labels.end(), values.begin(), [](std::uint32_t v) { return static_cast<Value>(v); });
  return values;
}

template <typename Value> std::vector<Value> rounded(const std::vector<float> &samples)
{
  const float low = std::numeric_limits<Value>::min();
  const float high = std::numeric_limits<Value>::max();
  std::vector<Value> values(samples.size());
  std::transform(samples.begin(), samples.end(), values.begin(),
                 [low, high](float v) { return static_cast<Value>(std::clamp(std::round(v), low, high)); });
  return values;
}

} // namespace

void require_nrrd_extension(const fs::path &path)
{
  require_extension(path, ".nrrd");
}

void write_labels(const LabelVolume &labels, const fs::path &file, const Provenance &provenance, const KeyValues &more)
{
  KeyValues fields = fields_of(provenance);
  fields.insert(fields.end(), more.begin(), more.end());
  const auto largest = std::max_element(labels.labels.begin(), labels.labels.end());
  const std::uint32_t highest = largest == labels.labels.end() ? 0 : *largest;
  if (highest <= std::numeric_limits<std::uint8_t>::max())
    write(labels.grid, Component::UCHAR, narrowed<std::uint8_t>(labels.labels), file, fields);
  else if (highest <= std::numeric_limits<std::uint16_t>::max())
    write(labels.grid, Component::USHORT, narrowed<std::uint16_t>(labels.labels), file, fields);
  else
    write(labels.grid, Component::UINT, labels.labels, file, fields);
}

void write_volume(const Volume &volume, PixelType type, const fs::path &file, const Provenance &provenance)
{
  const KeyValues fields = fields_of(provenance);
  switch (type) {
  case PixelType::uint8:
    return write(volume.grid, Component::UCHAR, rounded<std::uint8_t>(volume.samples), file, fields);
  case PixelType::int16:
    return write(volume.grid, Component::SHORT, rounded<std::int16_t>(volume.samples), file, fields);
  case PixelType::uint16:
    return write(volume.grid, Component::USHORT, rounded<std::uint16_t>(volume.samples), file, fields);
  case PixelType::float32:
    return write(volume.grid, Component::FLOAT, volume.samples, file, fields);
  }
}

} // namespace volsurf
