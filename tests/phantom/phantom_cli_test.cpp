// The program volsurf-phantom, run as a user runs it. VOLSURF_PHANTOM is its path.
#include "support/program.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

using volsurf::test::file_count;
using volsurf::test::Outcome;
using volsurf::test::read_file;
using volsurf::test::TemporaryFolder;

Outcome run_phantom(const TemporaryFolder &folder, const std::string &arguments)
{
  return volsurf::test::run_program(folder.path(), "'" VOLSURF_PHANTOM "' " + arguments);
}

void expect_refused(const std::string &arguments, int exit_code, const std::string &message)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_phantom(folder, arguments);
  EXPECT_EQ(outcome.exit_code, exit_code) << arguments;
  EXPECT_NE(outcome.err.find(message), std::string::npos) << arguments << ": " << outcome.err;
  EXPECT_EQ(file_count(folder.path()), 0) << arguments;
}

TEST(PhantomProgram, writes_scan_and_truth_in_silence)
{
  const TemporaryFolder folder;
  const Outcome outcome = run_phantom(folder, "--size 16 -o scan.nrrd --truth truth.nrrd");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
  EXPECT_EQ(read_file(folder / "scan.nrrd").rfind("NRRD000", 0), 0U);
  EXPECT_EQ(read_file(folder / "truth.nrrd").rfind("NRRD000", 0), 0U);
  EXPECT_EQ(file_count(folder.path()), 2);
}

TEST(PhantomProgram, same_options_make_the_same_file_for_any_number_of_threads)
{
  const TemporaryFolder folder;
  const std::string options = "--size 24,20,22 --noise rician:5% --seed 3 ";
  EXPECT_EQ(run_phantom(folder, options + "--threads 1 -o one.nrrd").exit_code, 0);
  EXPECT_EQ(run_phantom(folder, options + "--threads 2 -o two.nrrd").exit_code, 0);
  EXPECT_EQ(run_phantom(folder, options + "--seed 4 -o other.nrrd").exit_code, 2) << "an option given twice";
  EXPECT_EQ(run_phantom(folder, "--size 24,20,22 --noise rician:5% --seed 4 -o other.nrrd").exit_code, 0);
  EXPECT_EQ(read_file(folder / "one.nrrd"), read_file(folder / "two.nrrd"));
  EXPECT_NE(read_file(folder / "one.nrrd"), read_file(folder / "other.nrrd"));
}

TEST(PhantomProgram, writes_each_pixel_type)
{
  const TemporaryFolder folder;
  const auto header_of = [&](const std::string &type) {
    EXPECT_EQ(run_phantom(folder, "--size 8 -o a.nrrd --type " + type).exit_code, 0);
    return read_file(folder / "a.nrrd");
  };
  EXPECT_NE(header_of("uint8").find("type: unsigned char"), std::string::npos);
  EXPECT_NE(header_of("uint16").find("type: unsigned short"), std::string::npos);
  EXPECT_NE(header_of("float").find("type: float"), std::string::npos);
}

std::string data_of(const std::string &nrrd)
{
  return nrrd.substr(nrrd.find("\n\n"));
}

TEST(PhantomProgram, a_scan_gets_the_noise_that_the_same_phantom_would_get)
{
  const TemporaryFolder folder;
  EXPECT_EQ(run_phantom(folder, "--size 16 --type float -o clean.nrrd").exit_code, 0);
  EXPECT_EQ(run_phantom(folder, "--size 16 --type float --noise impulse:10% -o noisy.nrrd").exit_code, 0);
  EXPECT_EQ(run_phantom(folder, "--scan clean.nrrd --noise impulse:10% -o added.nrrd").exit_code, 0);
  EXPECT_EQ(data_of(read_file(folder / "added.nrrd")), data_of(read_file(folder / "noisy.nrrd")));
  EXPECT_NE(data_of(read_file(folder / "added.nrrd")), data_of(read_file(folder / "clean.nrrd")));
}

TEST(PhantomProgram, writes_each_shape_with_its_truth_as_labels_and_as_a_surface)
{
  for (const std::string shape : {"head", "sphere", "torus", "blobs", "shell", "cortex"}) {
    const TemporaryFolder folder;
    const Outcome outcome = run_phantom(
        folder, "--shape " + shape + " --size 20 --spacing 3 -o a.nrrd --truth b.nrrd --truth-surface c.vtp");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_NE(read_file(folder / "c.vtp").find("PolyData"), std::string::npos);
    EXPECT_EQ(file_count(folder.path()), 3);
  }
}

TEST(PhantomProgram, the_same_shape_is_the_same_file_for_any_number_of_threads)
{
  const TemporaryFolder folder;
  const std::string options = "--shape torus --size 24,20,22 --noise gaussian:10% --bias 0.4 ";
  EXPECT_EQ(run_phantom(folder, options + "--threads 1 -o a.nrrd --truth-surface a.vtp").exit_code, 0);
  EXPECT_EQ(run_phantom(folder, options + "--threads 2 -o b.nrrd --truth-surface b.vtp").exit_code, 0);
  EXPECT_EQ(read_file(folder / "a.nrrd"), read_file(folder / "b.nrrd"));
  EXPECT_EQ(read_file(folder / "a.vtp"), read_file(folder / "b.vtp"));
}

TEST(PhantomProgram, a_blurred_scan_differs_and_a_blur_of_nothing_does_not)
{
  const TemporaryFolder folder;
  EXPECT_EQ(run_phantom(folder, "--shape sphere --size 20 --noise gaussian:20% -o noisy.nrrd").exit_code, 0);
  EXPECT_EQ(run_phantom(folder, "--scan noisy.nrrd --blur 0 -o same.nrrd").exit_code, 0);
  EXPECT_EQ(run_phantom(folder, "--scan noisy.nrrd --blur 1 -o blurred.nrrd").exit_code, 0);
  EXPECT_EQ(data_of(read_file(folder / "same.nrrd")), data_of(read_file(folder / "noisy.nrrd")));
  EXPECT_NE(data_of(read_file(folder / "blurred.nrrd")), data_of(read_file(folder / "noisy.nrrd")));
}

TEST(PhantomProgram, tells_its_version_and_its_options)
{
  const TemporaryFolder folder;
  EXPECT_EQ(run_phantom(folder, "--version").out.rfind("volsurf-phantom ", 0), 0U);
  const Outcome help = run_phantom(folder, "--help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("--noise"), std::string::npos);
}

TEST(PhantomProgram, refuses_bad_usage)
{
  expect_refused("", 2, "--output is required");
  expect_refused("-o a.nrrd --bogus", 2, "--bogus");
  expect_refused("-o a.png", 2, "a.png");
  expect_refused("-o a.nrrd --truth a.nrrd --size 8", 2, "--truth: a.nrrd");
  expect_refused("-o a.nrrd --size text", 2, "--size");
  expect_refused("-o a.nrrd --size 8,8", 2, "--size: 2 numbers");
  expect_refused("-o a.nrrd --size 1", 2, "size: 1 samples");
  expect_refused("-o a.nrrd --size 99999999", 2, "size: more samples");
  expect_refused("-o a.nrrd --size 8 --spacing 0", 2, "spacing: 0");
  expect_refused("-o a.nrrd --size 8 --offset 1,0,0", 2, "--offset: moves single bodies");
  expect_refused("-o a.nrrd --truth-surface b.vtp --shape sphere --size 8 --offset 100,0,0", 2,
                 "no sample of the volume is inside");
  expect_refused("-o a.nrrd --size 8 --noise salt:1", 2, "salt:1");
  expect_refused("-o a.nrrd --size 8 --bias 2", 2, "bias: 2");
  expect_refused("-o a.nrrd --size 8 --seed -1", 2, "--seed: -1");
  expect_refused("-o a.nrrd --size 8 --threads -1", 2, "--threads: -1");
  expect_refused("-o a.nrrd --size 8 --type int8", 2, "int8");
  expect_refused("-o a.nrrd --scan b.nrrd --size 8", 2, "--scan");
  expect_refused("-o a.nrrd --shape cube", 2, "cube");
  expect_refused("-o a.nrrd --size 8 --truth-surface a.stl", 2, "a.stl");
  expect_refused("-o a.nrrd --size 8 --blur 1", 2, "--scan");
  expect_refused("-o a.nrrd --scan missing.nrrd", 3, "missing.nrrd");
}

TEST(PhantomProgram, says_where_it_cannot_write)
{
  expect_refused("-o missing/a.nrrd --size 8", 5, "missing/a.nrrd");
  expect_refused("-o a.nrrd --truth missing/b.nrrd --size 8", 5, "missing/b.nrrd");
}

TEST(PhantomProgram, says_so_before_the_work)
{
  // 1024^3 samples would take minutes, and more memory than a test should ask for.
  expect_refused("-o missing/a.nrrd --size 1024", 5, "missing/a.nrrd");
}

TEST(PhantomProgram, leaves_the_old_file_where_the_new_one_fails)
{
  const TemporaryFolder folder;
  volsurf::test::write_file(folder / "a.nrrd", "old");
  EXPECT_EQ(run_phantom(folder, "-o a.nrrd --truth missing/b.nrrd --size 8").exit_code, 5);
  EXPECT_EQ(read_file(folder / "a.nrrd"), "old");
  EXPECT_EQ(file_count(folder.path()), 1);
}

TEST(PhantomProgram, interrupted_it_leaves_nothing)
{
  const TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGINT, SIG_DFL); // whatever the tests' own caller ignores
    if (chdir(folder.path().c_str()) == 0)
      execl(VOLSURF_PHANTOM, "volsurf-phantom", "--size", "384", "-o", "a.nrrd", "--truth", "b.nrrd", nullptr);
    _exit(127);
  }
  for (int i = 0; i < 6000 && file_count(folder.path()) < 2; ++i) // until the work has begun
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(file_count(folder.path()), 2);
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(file_count(folder.path()), 0);
}

} // namespace
