// Memory by the megabyte.
#pragma once
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace texmap {

/// Memory from the system: where it is many bytes, in pages of 2 MiB, if the system has such.
///
/// A page is given when it is first touched. In pages of 4 KiB that takes about as long as filling it: a tenth of the time of a
/// program that loads a picture, draws another and ends.
/// Errors: std::bad_alloc. To be given back by std::free.
[[nodiscard]] void* allocate_bytes(std::size_t bytes);

/// Makes a vector take its memory from allocate_bytes.
template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class Other>
  explicit(false) LargePages(const LargePages<Other>& /*other*/) {}

  [[nodiscard]] T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(allocate_bytes(count * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t /*count*/) { std::free(memory); }
  friend bool operator==(const LargePages& /*a*/, const LargePages& /*b*/) { return true; }
};

/// A vector that may be large.
template <class T>
using LargeArray = std::vector<T, LargePages<T>>;

}  // namespace texmap
