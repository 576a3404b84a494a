// Programs run as a user runs them, through a shell.
#pragma once

#include "support/temporary_folder.h"

#include <cstdlib>
#include <string>
#include <sys/wait.h>

namespace volsurf::test {

struct Outcome {
  int exit_code; ///< -1 where a signal ended the program
  std::string out;
  std::string err;
};

/// Runs a command line in `folder`. What it prints goes to another folder, so that the files it leaves can be counted;
/// a redirection in the command line wins.
inline Outcome run_program(const std::filesystem::path &folder, const std::string &command_line)
{
  const TemporaryFolder log;
  const std::string command = "cd '" + folder.string() + "' && exec >'" + (log / "out").string() + "' 2>'" +
                              (log / "err").string() + "' && " + command_line;
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(log / "out"), read_file(log / "err")};
}

/// True where a program can be found.
inline bool has_program(const std::string &name)
{
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

} // namespace volsurf::test
