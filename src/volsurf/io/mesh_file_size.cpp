#include "volsurf/io/mesh_file_size.h"

#include "volsurf/core/error.h"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace volsurf {

namespace {

[[noreturn]] void fail(const fs::path &path, const std::string &found)
{
  throw InputError(path.string() + ": found " + found + "; allowed: a complete file");
}

std::string contents(const fs::path &path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct PlyProperty {
  std::size_t count_bytes; ///< of the number of values before a list; 0: not a list
  std::size_t value_bytes;
};

struct PlyElement {
  std::uint64_t count;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  std::string format;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0; ///< with the line end_header
};

std::size_t bytes_of_type(const fs::path &path, const std::string &type)
{
  static const std::map<std::string, std::size_t> bytes{{"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},
                                                        {"short", 2}, {"ushort", 2},  {"int16", 2},  {"uint16", 2},
                                                        {"int", 4},   {"uint", 4},    {"int32", 4},  {"uint32", 4},
                                                        {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = bytes.find(type);
  if (found == bytes.end())
    fail(path, "a PLY property of type \"" + type + "\"");
  return found->second;
}

void read_property(const fs::path &path, std::istringstream &words, PlyHeader &header)
{
  if (header.elements.empty())
    fail(path, "a PLY property without an element");
  std::string type;
  words >> type;
  PlyProperty property{0, 0};
  if (type == "list") {
    words >> type;
    property.count_bytes = bytes_of_type(path, type);
    words >> type;
  }
  property.value_bytes = bytes_of_type(path, type);
  header.elements.back().properties.push_back(property);
}

PlyHeader read_header(const fs::path &path, const std::string &text)
{
  PlyHeader header;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "format")
      words >> header.format;
    else if (word == "element") {
      std::uint64_t count = 0;
      if (!(words >> word >> count))
        fail(path, "a PLY element without a count");
      header.elements.push_back({count, {}});
    } else if (word == "property")
      read_property(path, words, header);
    else if (word == "end_header") {
      header.bytes = static_cast<std::size_t>(lines.tellg());
      return header;
    }
  }
  fail(path, "a PLY header without an end");
}

std::uint64_t list_count(const char *bytes, std::size_t width, bool big_endian)
{
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < width; ++i)
    count |= std::uint64_t{static_cast<unsigned char>(bytes[big_endian ? width - 1 - i : i])} << (8 * i);
  return count;
}

/// Steps over every value of a binary body; only lists have to be looked at.
void check_binary_body(const fs::path &path, const std::string &text, const PlyHeader &header)
{
  std::size_t left = text.size() - header.bytes;
  const bool big_endian = header.format == "binary_big_endian";
  const auto step = [&](std::uint64_t values, std::size_t bytes) {
    if (values > left / bytes)
      fail(path, "a PLY file that ends too early");
    left -= static_cast<std::size_t>(values) * bytes;
  };
  for (const PlyElement &element : header.elements)
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (const PlyProperty &property : element.properties) {
        std::uint64_t values = 1;
        if (property.count_bytes > 0) {
          const char *place = text.data() + (text.size() - left);
          step(1, property.count_bytes);
          values = list_count(place, property.count_bytes, big_endian);
        }
        step(values, property.value_bytes);
      }
}

void check_ascii_body(const fs::path &path, const std::string &text, const PlyHeader &header)
{
  std::uint64_t lines = 0;
  std::istringstream body(text.substr(header.bytes));
  for (std::string line; std::getline(body, line);)
    lines += line.find_first_not_of(" \t\r") != std::string::npos ? 1 : 0;
  for (const PlyElement &element : header.elements) {
    if (element.count > lines)
      fail(path, "a PLY file that ends too early");
    lines -= element.count;
  }
}

} // namespace

void check_stl_size(const fs::path &path)
{
  constexpr std::size_t kHeaderBytes = 84;
  constexpr std::size_t kTriangleBytes = 50;
  const std::string text = contents(path);
  if (text.size() >= kHeaderBytes) {
    const std::uint64_t triangles = list_count(text.data() + kHeaderBytes - 4, 4, false);
    if (text.size() == kHeaderBytes + kTriangleBytes * triangles)
      return;
  }
  const bool is_text = text.rfind("solid", 0) == 0 && text.find("facet") < 1000;
  if (!is_text)
    fail(path,
         "an STL file of " + std::to_string(text.size()) + " bytes, which its number of triangles does not explain");
  if (text.find("endsolid") == std::string::npos)
    fail(path, "an STL file without an end");
}

void check_ply_size(const fs::path &path)
{
  const std::string text = contents(path);
  if (text.rfind("ply", 0) != 0)
    fail(path, "no PLY header");
  const PlyHeader header = read_header(path, text);
  if (header.format == "ascii")
    check_ascii_body(path, text, header);
  else
    check_binary_body(path, text, header);
}

} // namespace volsurf
