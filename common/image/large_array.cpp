// Memory in large pages.
#include "large_array.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace texmap {
namespace {

constexpr std::size_t large_page = std::size_t{2} << 20;

}  // namespace

void* allocate_bytes(std::size_t bytes) {
  if (bytes > static_cast<std::size_t>(-1) / 2) throw std::bad_alloc();  // so much that rounding up would give 0
  const bool large = bytes >= large_page / 2;
  const std::size_t rounded = (bytes + large_page - 1) / large_page * large_page;
  void* const memory = large ? std::aligned_alloc(large_page, rounded) : std::malloc(bytes);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
  // A wish: a system that has no large pages for us gives small ones.
  if (large) (void)madvise(memory, rounded, MADV_HUGEPAGE);
#endif
  return memory;
}

}  // namespace texmap
