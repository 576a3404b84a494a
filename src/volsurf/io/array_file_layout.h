// What the writer and the reader of array files agree on. For them only.
#pragma once

#include "volsurf/io/array_file.h"

#include <array>

namespace volsurf {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "files are little-endian, and so are the machines we know");

/// Elements are deflated in blocks of so many bytes, but for an array's last.
constexpr std::uint64_t kBlockBytes = std::uint64_t{1} << 20;

using StoredSize = std::uint32_t; ///< comes before each block

struct ElementKind {
  ElementType type;
  const char *name; ///< as numpy calls it
  int bytes;
};

constexpr std::array<ElementKind, 6> kElementKinds{{{ElementType::uint8, "uint8", 1},
                                                    {ElementType::int16, "int16", 2},
                                                    {ElementType::uint16, "uint16", 2},
                                                    {ElementType::uint32, "uint32", 4},
                                                    {ElementType::int64, "int64", 8},
                                                    {ElementType::float32, "float32", 4}}};

constexpr const ElementKind &kind_of(ElementType type)
{
  return kElementKinds[static_cast<std::size_t>(type)];
}

inline std::string first_line_of(const ArrayFileKind &kind)
{
  return std::string(kind.name) + " " + std::to_string(kind.version) + "\n";
}

} // namespace volsurf
