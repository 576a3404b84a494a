#include "program/program.h"

#include "volsurf/core/error.h"
#include "volsurf/core/progress.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <iostream>
#include <new>

namespace volsurf {

namespace {

std::atomic<bool> interrupted{false};

extern "C" void note_interrupt(int)
{
  interrupted = true;
}

} // namespace

void catch_interrupts()
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, note_interrupt) == SIG_IGN)
      std::signal(signal, SIG_IGN);
}

bool was_interrupted()
{
  return interrupted;
}

void ignore_closed_pipes()
{
  std::signal(SIGPIPE, SIG_IGN);
}

std::string one_line(std::string text)
{
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

void print(const std::string &text)
{
  std::cout << text << std::flush;
  if (!std::cout)
    throw OutputError("standard output: cannot be written to (closed, or on a full disk)");
}

int fail(const std::string &program, ExitCode code, const std::string &message)
{
  std::cerr << program << ": " << one_line(message) << '\n';
  return code;
}

int fail_of_exception(const std::string &program)
{
  try {
    throw;
  } catch (const UsageError &error) {
    return fail(program, kUsage, error.what());
  } catch (const InputError &error) {
    return fail(program, kInput, error.what());
  } catch (const EmptyResult &error) {
    return fail(program, kNothingToWrite, error.what());
  } catch (const OutputError &error) {
    return fail(program, kOutput, error.what());
  } catch (const Cancelled &error) {
    return fail(program, kInterrupted, error.what());
  } catch (const std::bad_alloc &) {
    return fail(program, kUnexpected, "out of memory");
  } catch (const std::exception &error) {
    return fail(program, kUnexpected, error.what());
  }
}

void refuse_empty_values(CLI::App &app)
{
  const auto check = [](const std::string &text) {
    return text.empty() ? std::string("found \"\"; allowed are values of one or more characters") : std::string();
  };
  for (CLI::Option *option : app.get_options())
    if (option->get_items_expected_max() > 0)
      option->check(check, "");
}

} // namespace volsurf
