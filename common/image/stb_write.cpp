// The body of stb_image_write: encoding, and nothing else. The only file of the project that holds it.
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

// stb_image_write goes on with a null pointer when memory runs out; an exception stops it in time.
void* memory_or_throw(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

#define STBIW_MALLOC(size) memory_or_throw(std::malloc(size))
#define STBIW_REALLOC(memory, size) memory_or_throw(std::realloc(memory, size))
#define STBIW_FREE(memory) std::free(memory)

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
