// Volume files made by hand, so that programs are checked against the formats and not against ITK's writers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>
#include <zlib.h>

namespace volsurf::test {

template <typename Value> std::string bytes_of(const std::vector<Value> &values)
{
  return {reinterpret_cast<const char *>(values.data()), values.size() * sizeof(Value)};
}

/// 0, 1, 2, ... as samples of a type.
template <typename Value> std::string ramp(int count)
{
  std::vector<Value> values(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    values[static_cast<std::size_t>(i)] = static_cast<Value>(i);
  return bytes_of(values);
}

inline std::string deflated(const std::string &bytes, int window_bits)
{
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef *>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

inline std::string gzip(const std::string &bytes)
{
  return deflated(bytes, 16 + MAX_WBITS);
}

inline std::string zlib(const std::string &bytes)
{
  return deflated(bytes, MAX_WBITS);
}

/// An NRRD header without its closing empty line.
inline std::string nrrd_header(const std::string &type, const std::string &sizes, const std::string &more)
{
  const auto dimension = 1 + std::count(sizes.begin(), sizes.end(), ' ');
  return "NRRD0004\ntype: " + type + "\ndimension: " + std::to_string(dimension) + "\nsizes: " + sizes +
         "\nendian: little\n" + more;
}

inline std::string meta_header(const std::string &type, const std::string &sizes, const std::string &more,
                               const std::string &data = "LOCAL")
{
  const auto dimension = 1 + std::count(sizes.begin(), sizes.end(), ' ');
  return "ObjectType = Image\nNDims = " + std::to_string(dimension) +
         "\nBinaryData = True\nBinaryDataByteOrderMSB = False\n" + more + "DimSize = " + sizes +
         "\nElementType = " + type + "\nElementDataFile = " + data + "\n";
}

struct NiftiHeader {
  std::vector<std::int16_t> sizes{3, 4, 5};
  std::int16_t datatype = 4; ///< int16
  std::int16_t bits = 16;
  std::array<float, 4> pixdim{1, 1, 1, 1}; ///< qfac, then spacings
  std::int16_t qform_code = 0;
  std::array<float, 6> quaternion_and_offset{};
  std::int16_t sform_code = 0;
  std::array<float, 12> sform{};
  float slope = 0;
  float intercept = 0;

  std::string bytes() const
  {
    std::string header(352, '\0');
    const auto put = [&header](std::size_t offset, auto value) {
      std::memcpy(header.data() + offset, &value, sizeof(value));
    };
    put(0, std::int32_t{348});
    put(40, static_cast<std::int16_t>(sizes.size()));
    for (std::size_t i = 0; i < sizes.size(); ++i)
      put(42 + 2 * i, sizes[i]);
    put(70, datatype);
    put(72, bits);
    for (std::size_t i = 0; i < 4; ++i)
      put(76 + 4 * i, pixdim[i]);
    put(108, 352.0F);
    put(112, slope);
    put(116, intercept);
    put(123, char{2}); // millimetres
    put(252, qform_code);
    put(254, sform_code);
    for (std::size_t i = 0; i < 6; ++i)
      put(256 + 4 * i, quaternion_and_offset[i]);
    for (std::size_t i = 0; i < 12; ++i)
      put(280 + 4 * i, sform[i]);
    std::memcpy(header.data() + 344, "n+1", 3);
    return header;
  }
};

} // namespace volsurf::test
