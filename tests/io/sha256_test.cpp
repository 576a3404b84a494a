#include "volsurf/io/sha256.h"

#include "support/temporary_folder.h"
#include "volsurf/core/error.h"

#include <gtest/gtest.h>

namespace volsurf {
namespace {

using test::TemporaryFolder;
using test::write_file;

TEST(Sha256, AgreesWithThePublishedVectors)
{
  const TemporaryFolder folder;
  write_file(folder / "empty", "");
  write_file(folder / "abc", "abc");
  EXPECT_EQ(sha256_of_files({folder / "empty"}).sha256,
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of_files({folder / "abc"}).sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, OfSeveralFilesIsThatOfTheirConcatenation)
{
  const TemporaryFolder folder;
  const std::string large(1000003, 'x');
  write_file(folder / "a", large);
  write_file(folder / "b", "tail");
  write_file(folder / "ab", large + "tail");
  const FileDigest parts = sha256_of_files({folder / "a", folder / "b"});
  EXPECT_EQ(parts.sha256, sha256_of_files({folder / "ab"}).sha256);
  EXPECT_EQ(parts.bytes, 1000007U);
}

TEST(Sha256, OfAMissingFileIsAnInputError)
{
  const TemporaryFolder folder;
  EXPECT_THROW(sha256_of_files({folder / "missing"}), InputError);
}

} // namespace
} // namespace volsurf
