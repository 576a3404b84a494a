// What all programs of volsurf have in common: signals, messages, exit codes.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace volsurf {

enum ExitCode {
  kDone = 0,
  kUnexpected = 1,
  kUsage = 2,
  kInput = 3,
  kNothingToWrite = 4,
  kOutput = 5, ///< or a requirement that is not met
  kInterrupted = 130,
};

/// From now on SIGINT, SIGTERM and SIGHUP are noted only. What the caller has turned off, as nohup does, stays off.
void catch_interrupts();

/// Whether a signal was noted.
bool was_interrupted();

/// A reader of standard output that goes away becomes an error of writing, like a full disk.
void ignore_closed_pipes();

/// File names may hold line breaks, a message has none.
std::string one_line(std::string text);

/// To standard output. Throws OutputError.
void print(const std::string &text);

/// One line on stderr that begins with the program's name. Returns the code.
int fail(const std::string &program, ExitCode code, const std::string &message);

/// Says what the exception that is being handled says; to be called in a catch (...). Returns the exit code for it.
int fail_of_exception(const std::string &program);

/// CLI11 takes an empty text for no value where an option has a default.
void refuse_empty_values(CLI::App &app);

} // namespace volsurf
