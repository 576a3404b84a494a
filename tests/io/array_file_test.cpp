#include "volsurf/io/array_file.h"

#include "io/full_disk.h"
#include "support/array_file_bytes.h"
#include "support/contains.h"
#include "support/volume_bytes.h"
#include "volsurf/core/error.h"
#include "volsurf/core/parallel.h"

using namespace volsurf;
using namespace volsurf::test;

namespace {

constexpr ArrayFileKind kKind{"test arrays", 3};
constexpr char kFacts[] = R"({"name":"ball","size":[1,2,3]})";

/// Values that deflate does not pack to nothing.
template <typename T> std::vector<T> values(std::size_t count)
{
  std::vector<T> result(count);
  std::uint32_t state = 1;
  for (T &value : result)
    value = static_cast<T>((state = state * 1664525U + 1013904223U) >> 20);
  return result;
}

template <typename T> NamedArray named(const std::string &name, const std::vector<T> &array)
{
  return named_array(name, array.data(), static_cast<std::int64_t>(array.size()));
}

class ArrayFiles : public testing::Test {
protected:
  std::string small_file() const
  {
    const auto numbers = values<std::uint32_t>(40);
    const auto bytes = values<std::uint8_t>(3);
    write_array_file(path, kKind, kFacts, {named("numbers", numbers), named("bytes", bytes)});
    return read_file(path);
  }

  /// What is wrong with a file of these bytes; empty where it can be read.
  std::string objection(const std::string &bytes) const
  {
    write_file(path, bytes);
    try {
      const ArrayFile file(path, kKind);
      std::vector<std::uint32_t> numbers(40);
      file.read("numbers", numbers.data(), 40);
    } catch (const InputError &error) {
      return error.what();
    }
    return "";
  }

  void expect_refused(const std::string &bytes, const std::string &part) const
  {
    const std::string what = objection(bytes);
    EXPECT_TRUE(contains(what, part));
    EXPECT_EQ(what.rfind(path.string() + ": ", 0), 0U) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }

  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.arrays";
};

template <typename T> void expect_round_trip(std::size_t count)
{
  const TemporaryFolder folder;
  const auto array = values<T>(count);
  const std::vector<T> other(5, T{7});
  write_array_file(folder / "a", kKind, kFacts, {named("array", array), named("other", other)});
  const ArrayFile file(folder / "a", kKind);
  EXPECT_EQ(file.facts(), kFacts);
  EXPECT_EQ(file.type_of("array"), kElementType<T>);
  ASSERT_EQ(file.count_of("array"), static_cast<std::int64_t>(count));
  std::vector<T> found(count);
  file.read("array", found.data(), file.count_of("array"));
  EXPECT_TRUE(found == array) << count;
  std::vector<T> found_other(5);
  file.read("other", found_other.data(), 5);
  EXPECT_EQ(found_other, other);
}

} // namespace

TEST_F(ArrayFiles, HoldEveryTypeAtEveryLengthAroundABlock)
{
  constexpr std::size_t kBlock = std::size_t{1} << 20;
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{8}, kBlock - 8, kBlock, kBlock + 8, 3 * kBlock + 16}) {
    expect_round_trip<std::uint8_t>(bytes);
    expect_round_trip<std::int16_t>(bytes / 2);
    expect_round_trip<std::uint16_t>(bytes / 2);
    expect_round_trip<std::uint32_t>(bytes / 4);
    expect_round_trip<float>(bytes / 4);
    expect_round_trip<std::int64_t>(bytes / 8);
  }
}

TEST_F(ArrayFiles, HaveTheSameBytesForAnyNumberOfThreads)
{
  std::vector<std::int64_t> array(9'000'000); // more blocks than are packed at once
  for (std::size_t i = 0; i < array.size(); ++i)
    array[i] = static_cast<std::int64_t>(i / 1000);
  std::string first;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    write_array_file(path, kKind, kFacts, {named("array", array)});
    const std::string bytes = read_file(path);
    EXPECT_TRUE(first.empty() || first == bytes) << threads << " threads";
    first = bytes;
  }
}

TEST_F(ArrayFiles, AreRefusedWhereOneByteIsAnother)
{
  const std::string whole = small_file();
  ASSERT_EQ(objection(whole), "");
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (const char flip : {'\x01', '\x80', '\xFF'}) {
      std::string damaged = whole;
      damaged[i] = static_cast<char>(damaged[i] ^ flip);
      EXPECT_NE(objection(damaged), "") << "byte " << i;
    }
}

TEST_F(ArrayFiles, AreRefusedWhereTheyEndTooSoonOrTooLate)
{
  const std::string whole = small_file();
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_NE(objection(whole.substr(0, length)), "") << length << " bytes";
  expect_refused(whole + "x", "checksum");
  expect_refused(with_checksum(without_checksum(whole) + "x"), "bytes that belong to no array");
}

TEST_F(ArrayFiles, OfAnotherKindOrVersionAreNamed)
{
  const std::string whole = without_checksum(small_file());
  expect_refused("NRRD0004\n", "found no test arrays in it");
  expect_refused(std::string(1000, 'x'), "found no line that ends");
  expect_refused(with_checksum(replaced(whole, "test arrays 3", "test arrays 4")),
                 "found \"test arrays 4\", a version that this program does not know; allowed: \"test arrays 3\"");
  EXPECT_TRUE(is_array_file(path, kKind)) << "of a version to come";
  EXPECT_FALSE(is_array_file(path, {"test array", 3}));
  EXPECT_FALSE(is_array_file(folder / "gone", kKind));
  EXPECT_FALSE(is_array_file(folder.path(), kKind));
}

TEST_F(ArrayFiles, ThatContradictThemselvesAreRefusedInSpiteOfTheirChecksum)
{
  const std::string whole = without_checksum(small_file());
  const auto expect_header_refused = [&](const std::string &part, const std::string &by, const std::string &found) {
    expect_refused(with_checksum(replaced(whole, part, by)), found);
  };
  const std::string bad_array = "an array of an unknown type or length";
  expect_header_refused("uint32", "uint64", bad_array);
  for (const std::string count : {"-1", "40.5", "\"40\"", "1e3", "null", "9000000000000000000", "18446744073709551615"})
    expect_header_refused("\"count\":40", "\"count\":" + count, bad_array);
  expect_header_refused("\"count\":40", "\"count\":200000000000", "cannot be as long as it says");
  expect_header_refused("\"count\":40", "\"count\":0", "cannot be as long as it says");
  expect_header_refused("\"count\":40", "\"count\":41", "found an array \"numbers\" of 41 uint32; allowed here: 40");
  expect_header_refused("\"count\":3", "\"count\":0", "bytes that belong to no array");
  expect_header_refused("\"count\":40", "\"counts\":40", "a header that cannot be understood");
  expect_header_refused("\"name\":\"numbers\"", "\"name\":3", "a header that cannot be understood");
  expect_header_refused("{\"facts\"", "{{\"facts\"", "a header that cannot be understood");
  expect_header_refused("numbers", "others", "no array \"numbers\"");
}

TEST_F(ArrayFiles, WithBlocksThatDoNotFitAreRefusedInSpiteOfTheirChecksum)
{
  const std::string whole = without_checksum(small_file());
  const std::size_t first_block = whole.find('\n', whole.find('\n') + 1) + 1;
  for (const int stored_bytes : {0, 1, 10, 1000, -1}) {
    std::string damaged = whole;
    std::memcpy(damaged.data() + first_block, &stored_bytes, sizeof(stored_bytes));
    EXPECT_NE(objection(with_checksum(damaged)), "") << stored_bytes;
  }
  std::string damaged = whole;
  damaged[first_block + 8] = static_cast<char>(damaged[first_block + 8] ^ 1);
  expect_refused(with_checksum(damaged), "cannot be unpacked");
}

TEST_F(ArrayFiles, WithAHeaderOfManyBracketsAreRefused)
{
  expect_refused(with_checksum("test arrays 3\n" + std::string(500'000, '[') + "\n"),
                 "a header that cannot be understood");
}

TEST_F(ArrayFiles, AreWrittenWholeOrNotAtAll)
{
  const auto array = values<std::int64_t>(12'000);
  expect_full_disk_is_noticed("a.arrays", [&](const std::filesystem::path &file) {
    write_array_file(file, kKind, kFacts, {named("array", array)});
  });
}
