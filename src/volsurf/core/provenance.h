// What a result says about its own making.
#pragma once

#include <string>
#include <vector>

namespace volsurf {

/// Written into every output file beside its data.
struct Provenance {
  std::string version; ///< "volsurf 1.0.0"
  std::string source;  ///< file name of the input, without its folder
  std::string options; ///< the options as used, in the form of a command line
};

} // namespace volsurf
