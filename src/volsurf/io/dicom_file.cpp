#include "volsurf/io/dicom_file.h"

#include "volsurf/core/error.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

constexpr std::size_t kPreambleBytes = 128;
constexpr std::uint32_t kUndefinedLength = 0xFFFFFFFF;
constexpr std::uint32_t kMetaLength = 0x00020000;
constexpr std::uint32_t kTransferSyntax = 0x00020010;
constexpr std::uint32_t kSamplesPerPixel = 0x00280002;
constexpr std::uint32_t kRows = 0x00280010;
constexpr std::uint32_t kPixelData = 0x7FE00010;
constexpr std::uint32_t kItem = 0xFFFEE000;
constexpr std::uint32_t kItemEnd = 0xFFFEE00D;
constexpr std::uint32_t kSequenceEnd = 0xFFFEE0DD;
constexpr int kDeepestNesting = 64;

class Malformed {};

/// Steps over the elements of a data set (PS3.5, chapter 7).
class Walker {
public:
  explicit Walker(const std::string &bytes) : bytes_(bytes) {}

  /// True where the data set has pixel data.
  bool walk()
  {
    at_ = kPreambleBytes + 4;
    walk_meta_information();
    if (transfer_syntax_ == "1.2.840.10008.1.2.1.99")
      return true; // deflated as a whole: not looked into
    explicit_types_ = transfer_syntax_ != "1.2.840.10008.1.2";
    big_endian_ = transfer_syntax_ == "1.2.840.10008.1.2.2";
    while (at_ < bytes_.size() && !pixel_data_seen_) // what follows is padding
      skip_element(0);
    if (rows_seen_ && !pixel_data_seen_)
      throw Malformed();
    return pixel_data_seen_;
  }

private:
  /// GDCM aborts where these elements are not as they must be, so they are checked one by one.
  void walk_meta_information()
  {
    static const std::set<std::string> types = {"AE", "OB", "SH", "UI", "UL", "UR"};
    need(12);
    if (tag() != kMetaLength || bytes_.compare(at_ + 4, 2, "UL") != 0 || number(at_ + 6, 2) != 4)
      throw Malformed();
    const std::uint32_t length = number(at_ + 8, 4);
    at_ += 12;
    need(length);
    const std::size_t end = at_ + length;
    for (std::uint32_t previous = kMetaLength; at_ < end;) {
      const std::uint32_t tag_here = tag();
      if (tag_here <= previous || tag_here >> 16 != 2 || types.count(bytes_.substr(at_ + 4, 2)) == 0)
        throw Malformed();
      previous = tag_here;
      skip_element(0);
    }
    if (at_ != end)
      throw Malformed();
  }

  void need(std::uint64_t count) const
  {
    if (count > bytes_.size() - at_)
      throw Malformed();
  }

  std::uint32_t number(std::size_t offset, int count) const
  {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) {
      const auto byte = static_cast<unsigned char>(bytes_[offset + static_cast<std::size_t>(i)]);
      value |= std::uint32_t{byte} << (8 * (big_endian_ ? count - 1 - i : i));
    }
    return value;
  }

  std::uint32_t tag() const
  {
    need(8);
    return number(at_, 2) << 16 | number(at_ + 2, 2);
  }

  /// Reads the type and the length of the element at hand and steps to its value.
  std::uint32_t enter_value(std::string &type)
  {
    static const std::set<std::string> long_types = {"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                                     "SV", "UC", "UN", "UR", "UT", "UV"};
    type = explicit_types_ ? bytes_.substr(at_ + 4, 2) : "";
    const bool is_long = long_types.count(type) > 0;
    if (is_long)
      need(12);
    const std::uint32_t length = is_long           ? number(at_ + 8, 4)
                                 : explicit_types_ ? number(at_ + 6, 2)
                                                   : number(at_ + 4, 4);
    at_ += is_long ? 12 : 8;
    return length;
  }

  void skip_element(int depth)
  {
    const std::uint32_t tag_here = tag();
    std::string type;
    const std::uint32_t length = enter_value(type);
    if (length == kUndefinedLength) {
      const bool outer = explicit_types_;
      explicit_types_ = outer && type != "UN"; // the items of an unknown type are implicit
      skip_items(depth + 1);
      explicit_types_ = outer;
    } else {
      need(length);
      if (tag_here == kTransferSyntax)
        transfer_syntax_ = bytes_.substr(at_, std::min<std::size_t>(length, bytes_.find('\0', at_) - at_)); // unpadded
      if (tag_here == kSamplesPerPixel && (length != 2 || number(at_, 2) < 1 || number(at_, 2) > 4))
        throw Malformed(); // GDCM aborts
      at_ += length;
    }
    rows_seen_ = rows_seen_ || (depth == 0 && tag_here == kRows);
    pixel_data_seen_ = pixel_data_seen_ || (depth == 0 && tag_here == kPixelData);
  }

  void skip_items(int depth)
  {
    if (depth > kDeepestNesting)
      throw Malformed();
    for (std::uint32_t tag_here = tag(); tag_here != kSequenceEnd; tag_here = tag()) {
      if (tag_here != kItem)
        throw Malformed();
      const std::uint32_t length = number(at_ + 4, 4);
      at_ += 8;
      if (length == kUndefinedLength) {
        while (tag() != kItemEnd)
          skip_element(depth);
        at_ += 8;
      } else {
        need(length);
        at_ += length;
      }
    }
    at_ += 8;
  }

  const std::string &bytes_;
  std::size_t at_ = 0;
  bool explicit_types_ = true;
  bool big_endian_ = false;
  bool rows_seen_ = false;
  bool pixel_data_seen_ = false;
  std::string transfer_syntax_;
};

} // namespace

bool begins_like_dicom(const fs::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string start(kPreambleBytes + 4, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return stream && start.compare(kPreambleBytes, 4, "DICM") == 0;
}

bool holds_complete_image(const fs::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  try {
    return Walker(bytes).walk();
  } catch (const Malformed &) {
    throw InputError(file.string() + ": found a DICOM file that is damaged or ends too soon; allowed: complete files");
  }
}

} // namespace volsurf
