// A large array whose memory is first touched by whoever fills it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <sys/mman.h>
#include <type_traits>

namespace volsurf {

/// Like std::vector, but of fixed size and not initialised: a serial pass of zeros over a volume costs as much as a
/// stage of the algorithm, and the threads that fill the array should be the ones that get its pages. Where the system
/// has large pages, long arrays get those.
template <typename T> class Buffer {
  static_assert(std::is_trivially_copyable_v<T>, "elements are never constructed");

public:
  Buffer() = default;
  explicit Buffer(std::int64_t size) : data_(allocate(static_cast<std::size_t>(size) * sizeof(T))), size_(size) {}

  /// Zeros, which cost nothing where they are never written: the system has pages of them at hand.
  static Buffer zeros(std::int64_t size)
  {
    Buffer buffer;
    buffer.data_.reset(static_cast<T *>(std::calloc(static_cast<std::size_t>(size) + 1, sizeof(T))));
    buffer.size_ = size;
    if (buffer.data_ == nullptr)
      throw std::bad_alloc();
    return buffer;
  }

  T *data() { return data_.get(); }
  const T *data() const { return data_.get(); }
  std::int64_t size() const { return size_; }
  T &operator[](std::int64_t i) { return data_.get()[i]; }
  const T &operator[](std::int64_t i) const { return data_.get()[i]; }
  const T *begin() const { return data(); }
  const T *end() const { return data() + size_; }

private:
  struct Free {
    void operator()(T *data) const { std::free(data); }
  };

  static T *allocate(std::size_t bytes)
  {
    constexpr std::size_t kLargePage = std::size_t{1} << 21;
    constexpr std::size_t kCacheLine = 64;
    const bool is_long = bytes >= 2 * kLargePage;
    const std::size_t unit = is_long ? kLargePage : kCacheLine;
    const std::size_t rounded = (bytes / unit + 1) * unit;
    void *const data = std::aligned_alloc(unit, rounded);
    if (data == nullptr)
      throw std::bad_alloc();
    if (is_long)
      madvise(data, rounded, MADV_HUGEPAGE); // a wish: it may be refused without harm
    return static_cast<T *>(data);
  }

  std::unique_ptr<T, Free> data_;
  std::int64_t size_ = 0;
};

} // namespace volsurf
