// Named arrays and a few facts about them in one file, which is read whole or not at all.
//
// A file is: a line with its kind and version, a line of JSON with the facts and the names, types and lengths of the
// arrays, the arrays, each in blocks of 1 MiB that are deflated one by one, and a SHA-256 of everything before it.
// docs/hierarchy_format.md tells the bytes. Blocks are packed and unpacked in parallel; the bytes of a file do not
// depend on the number of threads.
#pragma once

#include "volsurf/io/positioned_file.h"

#include <map>
#include <string>
#include <vector>

namespace volsurf {

/// What a file holds, as its first line says it: "volsurf hierarchy 1".
struct ArrayFileKind {
  const char *name;
  int version;
};

enum class ElementType { uint8, int16, uint16, uint32, int64, float32 };

template <typename T> constexpr ElementType kElementType = ElementType{};
template <> inline constexpr ElementType kElementType<std::uint8_t> = ElementType::uint8;
template <> inline constexpr ElementType kElementType<std::int16_t> = ElementType::int16;
template <> inline constexpr ElementType kElementType<std::uint16_t> = ElementType::uint16;
template <> inline constexpr ElementType kElementType<std::uint32_t> = ElementType::uint32;
template <> inline constexpr ElementType kElementType<std::int64_t> = ElementType::int64;
template <> inline constexpr ElementType kElementType<float> = ElementType::float32;

/// An array to write. Does not own its elements.
struct NamedArray {
  std::string name;
  ElementType type;
  const void *data;
  std::int64_t count;
};

template <typename T> NamedArray named_array(const std::string &name, const T *data, std::int64_t count)
{
  return {name, kElementType<T>, data, count};
}

/// `facts` is a JSON value on one line. Throws OutputError.
void write_array_file(const std::filesystem::path &path, const ArrayFileKind &kind, const std::string &facts,
                      const std::vector<NamedArray> &arrays);

/// True where a file begins as those of this kind do, of whatever version.
bool is_array_file(const std::filesystem::path &path, const ArrayFileKind &kind);

/// A file of arrays, open for reading. The arrays are the ones that were written: whatever is damaged, cut short or of
/// another version throws InputError, before memory is taken for what the file only claims to hold.
class ArrayFile {
public:
  /// Reads the whole file once, for its digest.
  ArrayFile(const std::filesystem::path &path, const ArrayFileKind &kind);

  /// A JSON value.
  const std::string &facts() const { return facts_; }

  /// Throw InputError where there is no array of that name.
  ElementType type_of(const std::string &name) const { return array(name).type; }
  std::int64_t count_of(const std::string &name) const { return array(name).count; }

  /// Reads an array, which must have this type and number of elements. Throws InputError.
  template <typename T> void read(const std::string &name, T *out, std::int64_t count) const
  {
    read_elements(name, kElementType<T>, out, count);
  }

private:
  struct Block {
    std::uint64_t offset; // in the file
    std::uint32_t stored_bytes;
  };
  struct Array {
    ElementType type;
    std::int64_t count;
    std::vector<Block> blocks;
  };

  [[noreturn]] void fail(const std::string &found) const;
  void check_kind(const ArrayFileKind &kind) const;
  void check_digest();
  void read_header(std::uint64_t begin);
  std::string read_line(std::uint64_t begin, std::size_t longest) const;
  std::vector<Block> find_blocks(std::uint64_t bytes, std::uint64_t &offset) const;
  const Array &array(const std::string &name) const;
  void read_elements(const std::string &name, ElementType type, void *out, std::int64_t count) const;
  void inflate_block(const Block &block, void *out, std::uint64_t bytes) const;

  PositionedFile file_;
  std::uint64_t end_ = 0; // of what the digest is of
  std::string facts_;
  std::map<std::string, Array> arrays_;
};

} // namespace volsurf
