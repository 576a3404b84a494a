// What the readers share: one ITK image IO, asked for its geometry and its samples, without ITK's messages on stderr.
// For the sources of io only, since it includes ITK.
#pragma once

#include "volsurf/core/grid.h"
#include "volsurf/io/read_volume.h"

#include <iostream>
#include <itkImageIOBase.h>
#include <sstream>
#include <string>

namespace volsurf {

/// Keeps ITK, MetaIO and GDCM from printing while it lives: what matters comes as an exception.
class QuietItk {
public:
  QuietItk();
  ~QuietItk();
  QuietItk(const QuietItk &) = delete;
  QuietItk &operator=(const QuietItk &) = delete;

private:
  bool warnings_;
  std::ostringstream swallowed_;
  std::streambuf *out_;
  std::streambuf *error_;
};

/// ITK's reason without class names, addresses and line breaks.
std::string one_line(const itk::ExceptionObject &error);

/// Reads the header. Throws InputError where ITK cannot.
void read_information(itk::ImageIOBase &io, const std::filesystem::path &path, const std::string &format);

/// Size and place of the image, in LPS, by its first three axes.
Grid grid_of(const itk::ImageIOBase &io);

/// The same, but throws InputError unless it is a 3-D scalar image
/// (further axes may have one sample) with positive spacing and axes that span space.
Grid checked_grid(const itk::ImageIOBase &io, const std::filesystem::path &path);

/// Throws InputError where an axis has fewer than 2 samples.
void check_axes(const Grid &grid, const std::filesystem::path &path);

/// Throws InputError where the grid's float32 samples are more than options allow.
void check_memory(const Grid &grid, const std::filesystem::path &path, const ReadOptions &options);

/// "uint8", "int16", ... "float64"
std::string pixel_type_name(const itk::ImageIOBase &io);

/// Reads all samples, `count` of them, as float32. Throws InputError.
void read_samples(itk::ImageIOBase &io, const std::filesystem::path &path, float *samples, std::size_t count);

} // namespace volsurf
