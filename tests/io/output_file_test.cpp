#include "volsurf/io/output_file.h"

#include "support/temporary_folder.h"
#include "volsurf/core/error.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace fs = std::filesystem;

namespace volsurf {
namespace {

using test::file_count;
using test::read_file;
using test::SmallDisk;
using test::TemporaryFolder;
using test::write_file;

std::string refusal(const fs::path &target)
{
  try {
    const PendingOutput output(target);
  } catch (const OutputError &error) {
    return error.what();
  }
  return "";
}

TEST(PendingOutput, AppearsUnderItsNameOnCommitOnly)
{
  const TemporaryFolder folder;
  PendingOutput output(folder / "out.stl");
  write_file(output.temporary_path(), "mesh");
  EXPECT_FALSE(fs::exists(folder / "out.stl"));
  EXPECT_EQ(output.temporary_path().parent_path(), folder.path());
  EXPECT_EQ(output.temporary_path().extension(), ".stl");
  output.commit();
  EXPECT_EQ(read_file(folder / "out.stl"), "mesh");
  EXPECT_EQ(file_count(folder.path()), 1);
}

TEST(PendingOutput, NamesTheTargetWhereAWriterNamesTheTemporaryFile)
{
  const TemporaryFolder folder;
  const PendingOutput output(folder / "out.stl");
  try {
    output.write([](const fs::path &file) { throw OutputError(file.string() + ": no"); });
    ADD_FAILURE();
  } catch (const OutputError &error) {
    EXPECT_EQ(error.what(), (folder / "out.stl").string() + ": no");
  }
}

TEST(PendingOutput, LeavesNothingWhenAnExceptionPasses)
{
  const TemporaryFolder folder;
  try {
    const PendingOutput first(folder / "a.vtp");
    const PendingOutput second(folder / "b.vtp");
    EXPECT_NE(first.temporary_path(), second.temporary_path());
    throw Cancelled();
  } catch (const Cancelled &) {
  }
  EXPECT_EQ(file_count(folder.path()), 0);
}

TEST(PendingOutput, KeepsTheOldFileUntilCommit)
{
  const TemporaryFolder folder;
  write_file(folder / "out.vtp", "old");
  {
    const PendingOutput output(folder / "out.vtp");
    write_file(output.temporary_path(), "new");
  }
  EXPECT_EQ(read_file(folder / "out.vtp"), "old");
}

TEST(PendingOutput, HandsItsFileOnWhenMoved)
{
  const TemporaryFolder folder;
  PendingOutput first(folder / "out.vtp");
  {
    PendingOutput second(std::move(first));
    second.commit();
  }
  EXPECT_TRUE(fs::exists(folder / "out.vtp"));
}

TEST(PendingOutput, HasThePermissionsThatTheUmaskLeaves)
{
  const TemporaryFolder folder;
  const mode_t before = umask(0027);
  PendingOutput output(folder / "out.vtp");
  umask(before);
  output.commit();
  EXPECT_EQ(fs::status(folder / "out.vtp").permissions(), fs::perms(0640));
}

TEST(PendingOutput, FollowsALinkToItsFile)
{
  const TemporaryFolder folder;
  fs::create_directory(folder / "elsewhere");
  fs::create_symlink("elsewhere/real.vtp", folder / "link.vtp");
  PendingOutput output(folder / "link.vtp");
  write_file(output.temporary_path(), "mesh");
  output.commit();
  EXPECT_TRUE(fs::is_symlink(folder / "link.vtp"));
  EXPECT_EQ(read_file(folder / "elsewhere/real.vtp"), "mesh");
}

TEST(PendingOutput, RefusesAMissingFolder)
{
  const TemporaryFolder folder;
  const std::string message = refusal(folder / "missing/out.vtp");
  EXPECT_NE(message.find("out.vtp: the folder " + (folder / "missing").string() + " does not exist"), std::string::npos)
      << message;
}

TEST(PendingOutput, RefusesAFolderThatIsAFile)
{
  const TemporaryFolder folder;
  write_file(folder / "file", "");
  EXPECT_NE(refusal(folder / "file/out.vtp").find("is not a folder"), std::string::npos);
}

TEST(PendingOutput, RefusesATargetThatIsNoRegularFile)
{
  const TemporaryFolder folder;
  fs::create_directory(folder / "out.vtp");
  fs::create_symlink("/dev/full", folder / "full.vtp");
  EXPECT_NE(refusal(folder / "out.vtp").find("found a folder"), std::string::npos);
  EXPECT_NE(refusal(folder / "full.vtp").find("found a device"), std::string::npos);
}

TEST(PendingOutput, RefusesAReadOnlyFolder)
{
  const SmallDisk disk(4);
  if (!disk.mounted() || !disk.make_read_only())
    GTEST_SKIP() << "no tmpfs can be mounted here (needs root)";
  const std::string message = refusal(disk / "out.vtp");
  EXPECT_NE(message.find("cannot be written to: Read-only file system"), std::string::npos) << message;
}

} // namespace
} // namespace volsurf
