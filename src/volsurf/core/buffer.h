// A large array whose memory is first touched by whoever fills it.
#pragma once

#include <cstdint>
#include <memory>
#include <type_traits>

namespace volsurf {

/// Like std::vector, but of fixed size and not initialised: a serial pass of zeros over a volume costs as much as a
/// stage of the algorithm, and the threads that fill the array should be the ones that get its pages.
template <typename T> class Buffer {
  static_assert(std::is_trivially_copyable_v<T>, "elements are never constructed");

public:
  Buffer() = default;
  explicit Buffer(std::int64_t size) : data_(new T[static_cast<std::size_t>(size)]), size_(size) {}

  T *data() { return data_.get(); }
  const T *data() const { return data_.get(); }
  std::int64_t size() const { return size_; }
  T &operator[](std::int64_t i) { return data_[static_cast<std::size_t>(i)]; }
  const T &operator[](std::int64_t i) const { return data_[static_cast<std::size_t>(i)]; }
  const T *begin() const { return data(); }
  const T *end() const { return data() + size_; }

private:
  std::unique_ptr<T[]> data_;
  std::int64_t size_ = 0;
};

} // namespace volsurf
