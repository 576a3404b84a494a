// How the merge gets its field: plane by plane, never as a whole.
#pragma once

#include <cstdint>
#include <functional>

namespace volsurf {

/// Writes I of sample plane z to `out`: size[0] * size[1] finite floats, x fastest. It is called from several threads,
/// more than once for some planes, and must give the same values each time.
using PlaneSource = std::function<void(std::int64_t z, float *out)>;

} // namespace volsurf
