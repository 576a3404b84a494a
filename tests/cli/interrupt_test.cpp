// Runs that are stopped: 130 and nothing left, whenever the signal comes.
#include "cli/volsurf_program.h"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <thread>
#include <unistd.h>

namespace volsurf::test {
namespace {

using std::chrono::milliseconds;

class Interrupt : public VolsurfProgram {
protected:
  /// Starts the job on a volume that takes a second or so, in the folder `work`.
  pid_t start(int ignored_signal = 0) const
  {
    const pid_t child = fork();
    if (child != 0)
      return child;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
      std::signal(signal, signal == ignored_signal ? SIG_IGN : SIG_DFL); // whatever the tests' own caller ignores
    const int log = open(log_path().c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    if (chdir(work.path().c_str()) != 0 || dup2(log, STDERR_FILENO) < 0)
      _exit(126);
    execl(VOLSURF, "volsurf", VOLSURF_SOURCE "/data/brain.nrrd", "--delta", "20", "-o", "out.vtp", "-o", "out.vdb",
          "--labels", "labels.nrrd", "--report", "report.json", static_cast<char *>(nullptr));
    _exit(127);
  }

  std::string log_path() const { return (inputs / "log").string(); }

  /// Waits until the outputs have been begun: by then the input has been read and the work has started.
  void wait_for_work() const
  {
    for (int i = 0; i < 6000 && files().empty(); ++i)
      std::this_thread::sleep_for(milliseconds(5));
    ASSERT_FALSE(files().empty());
  }

  static int exit_code_of(pid_t child)
  {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  const std::set<std::string> all_outputs{"out.vtp", "out.vdb", "labels.nrrd", "report.json"};
};

TEST_F(Interrupt, AtTheStartOfTheWorkEndsItWithNothingLeft)
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const pid_t child = start();
    wait_for_work();
    kill(child, signal);
    EXPECT_EQ(exit_code_of(child), 130) << signal;
    EXPECT_EQ(read_file(log_path()), "volsurf: interrupted, nothing was written\n");
    EXPECT_EQ(files(), std::set<std::string>{});
  }
}

TEST_F(Interrupt, AtAnyMomentLeavesAllOutputsOrNone)
{
  for (const int delay_ms : {50, 150, 400, 800, 1400}) {
    const pid_t child = start();
    wait_for_work();
    std::this_thread::sleep_for(milliseconds(delay_ms));
    kill(child, SIGINT);
    const int code = exit_code_of(child);
    EXPECT_TRUE(code == 130 || code == 0) << code << " after " << delay_ms << " ms";
    EXPECT_EQ(files(), code == 0 ? all_outputs : std::set<std::string>{}) << "after " << delay_ms << " ms";
    for (const std::string &file : files())
      std::filesystem::remove(work / file);
  }
}

TEST_F(Interrupt, BeforeTheWorkLeavesNothing)
{
  for (const int delay_ms : {0, 5, 20, 60}) {
    const pid_t child = start();
    std::this_thread::sleep_for(milliseconds(delay_ms));
    kill(child, SIGINT);
    const int code = exit_code_of(child);
    EXPECT_TRUE(code == 130 || code == -SIGINT) << code; // the latter before main has begun
    EXPECT_EQ(files(), std::set<std::string>{});
  }
}

TEST_F(Interrupt, SignalThatTheCallerIgnoresIsIgnored)
{
  const pid_t child = start(SIGHUP);
  wait_for_work();
  kill(child, SIGHUP);
  EXPECT_EQ(exit_code_of(child), 0);
  EXPECT_EQ(files(), all_outputs);
}

} // namespace
} // namespace volsurf::test
