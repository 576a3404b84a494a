// Where two rows of numbers differ, as bits.
#pragma once

#include <cstdint>

namespace volsurf {

/// Gives word x / 64 the bits x % 64 of all x, 0 <= x < count, where a[x] != b[x]. Words without any are left as they
/// are.
void mark_differences(const std::uint32_t *a, const std::uint32_t *b, std::int64_t count, std::uint64_t *words);

} // namespace volsurf
