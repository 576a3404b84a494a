// Results that cannot be written: exit code 5, one line, and nothing left of any of them.
#include "cli/volsurf_program.h"

#include <sys/stat.h>
#include <unistd.h>

namespace volsurf::test {
namespace {

class BadOutput : public VolsurfProgram {
protected:
  void expect_not_written(const std::string &options, const std::vector<std::string> &parts) const
  {
    expect_refused(ball() + " --delta 2 " + options, 5, parts);
  }

  /// `options` ends where the name of a file on a full disk is to follow.
  void expect_full_disk_is_noticed(const std::string &options, const std::string &name) const;
};

void BadOutput::expect_full_disk_is_noticed(const std::string &options, const std::string &name) const
{
  ASSERT_EQ(run(ball() + " --delta 2 " + options + " whole-" + name).exit_code, 0);
  const auto pages_needed = static_cast<int>(std::filesystem::file_size(work / ("whole-" + name)) / 4096 + 1);
  for (const int free_pages : std::set<int>{0, pages_needed / 2, pages_needed - 1}) {
    const SmallDisk disk(free_pages + 1);
    if (!disk.mounted())
      GTEST_SKIP() << "no tmpfs can be mounted here (needs root)";
    write_file(disk / "filler", std::string(4096, 'x'));
    expect_not_written("-o beside.ply " + options + " " + (disk / name).string(), {name});
    EXPECT_EQ(file_count(disk.path()), 1) << "with " << free_pages << " pages free of " << pages_needed;
  }
}

TEST_F(BadOutput, MissingFolderIsNamed)
{
  expect_not_written("-o gone/out.vtp", {"gone/out.vtp: the folder gone does not exist"});
  expect_not_written("--labels gone/out.nrrd", {"gone/out.nrrd: the folder gone does not exist"});
  expect_not_written("--report gone/out.json", {"gone/out.json: the folder gone does not exist"});
}

TEST_F(BadOutput, ReadOnlyFolderIsNamed)
{
  if (geteuid() != 0) {
    std::filesystem::create_directory(work / "locked");
    chmod((work / "locked").c_str(), 0555);
    expect_not_written("-o locked/out.vtp", {"locked/out.vtp: the folder locked cannot be written to: Permission"});
    return;
  }
  const SmallDisk disk(4); // permissions do not bind root, mounts do
  if (!disk.mounted() || !disk.make_read_only())
    GTEST_SKIP() << "root may mount nothing here, and permissions do not bind root";
  expect_not_written("-o " + (disk / "out.vtp").string(), {disk.path().string(), "Read-only file system"});
}

TEST_F(BadOutput, FolderThatTakesNoFilesIsNamed)
{
  expect_not_written("-o /proc/out.vtp", {"/proc/out.vtp: the folder /proc cannot be written to"});
}

TEST_F(BadOutput, FolderInTheOutputsPlaceIsKept)
{
  std::filesystem::create_directory(work / "out.vtp");
  expect_not_written("-o out.vtp", {"out.vtp: found a folder; allowed: a regular file or a new name"});
}

TEST_F(BadOutput, FileInTheFoldersPlaceIsKept)
{
  write_file(work / "file", "precious");
  expect_not_written("-o file/out.vtp", {"file/out.vtp: file is not a folder"});
  EXPECT_EQ(read_file(work / "file"), "precious");
}

TEST_F(BadOutput, DevicesAreNotWrittenTo)
{
  std::filesystem::create_symlink("/dev/full", work / "out.vtp");
  expect_not_written("-o out.vtp", {"out.vtp: found a device or pipe"});
  expect_not_written("--report /dev/full", {"/dev/full: found a device or pipe"});
}

TEST_F(BadOutput, NamesThatCannotBeUsedLeaveTheOtherOutputsUnwritten)
{
  expect_not_written("-o first.vtp -o " + std::string(300, 'n') + ".vtp", {"n.vtp: the name cannot be used"});
  std::filesystem::create_symlink("loop.vtp", work / "loop.vtp");
  expect_not_written("-o first.vtp -o loop.vtp", {"loop.vtp: the link leads to itself"});
}

TEST_F(BadOutput, EarlierResultSurvivesAFailure)
{
  write_file(work / "old.vtp", "old");
  expect_not_written("-o old.vtp -o gone/out.vtp", {"gone/out.vtp"});
  EXPECT_EQ(read_file(work / "old.vtp"), "old");
}

TEST_F(BadOutput, FullDiskIsNoticedForVtp)
{
  expect_full_disk_is_noticed("-o", "out.vtp");
}

TEST_F(BadOutput, FullDiskIsNoticedForStl)
{
  expect_full_disk_is_noticed("-o", "out.stl");
}

TEST_F(BadOutput, FullDiskIsNoticedForPly)
{
  expect_full_disk_is_noticed("-o", "out.ply");
}

TEST_F(BadOutput, FullDiskIsNoticedForObj)
{
  expect_full_disk_is_noticed("-o", "out.obj");
}

TEST_F(BadOutput, FullDiskIsNoticedForVdb)
{
  expect_full_disk_is_noticed("-o", "out.vdb");
}

TEST_F(BadOutput, FullDiskIsNoticedForLabels)
{
  expect_full_disk_is_noticed("--labels", "out.nrrd");
}

TEST_F(BadOutput, FullDiskIsNoticedForTheHierarchy)
{
  expect_full_disk_is_noticed("--save-hierarchy", "out.volsurf");
}

TEST_F(BadOutput, FullDiskIsNoticedForTheReport)
{
  expect_full_disk_is_noticed("--report", "out.json");
}

TEST_F(BadOutput, FullStandardOutputLeavesNoFile)
{
  expect_not_written("--report - >/dev/full", {"standard output: cannot be written to"});
  expect_refused("--help >/dev/full", 5, {"standard output: cannot be written to"});
}

TEST_F(BadOutput, ReaderThatGoesAwayLeavesNoFile)
{
  // The pipe's only reader ends at once; the program is started when it has gone.
  const std::string command = "( sleep 0.3; '" VOLSURF "' " + ball() +
                              " --delta 2 --report -; echo $? >code ) | true; "
                              "while [ ! -s code ]; do sleep 0.1; done";
  const Outcome outcome = run_program(work.path(), command);
  EXPECT_TRUE(contains(outcome.err, "standard output: cannot be written to"));
  EXPECT_EQ(read_file(work / "code"), "5\n");
  EXPECT_EQ(files(), std::set<std::string>{"code"});
}

} // namespace
} // namespace volsurf::test
