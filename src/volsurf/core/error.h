// Errors that a user can cause or mend. Programming mistakes are asserts.
#pragma once

#include <stdexcept>
#include <string>

namespace volsurf {

/// One line for the user: what it is about (a file, an option), what was found, and what is allowed.
class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

class UsageError : public Error { ///< an option is out of its range; exit code 2
public:
  using Error::Error;
};

class InputError : public Error { ///< the input cannot be read or used; exit code 3
public:
  using Error::Error;
};

class EmptyResult : public Error { ///< there is nothing to write; exit code 4
public:
  using Error::Error;
};

class OutputError : public Error { ///< a result cannot be written; exit code 5
public:
  using Error::Error;
};

class Cancelled : public Error { ///< the progress callback asked to stop; exit code 130
public:
  Cancelled() : Error("interrupted, nothing was written") {}
};

} // namespace volsurf
