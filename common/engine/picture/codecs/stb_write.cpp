// The only file of the project that compiles stb_image_write: encoding, nothing else.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include "engine/picture/codecs/checksums.hpp"
#include "engine/picture/codecs/deflate.hpp"

namespace {

// stb_image_write goes on with a null pointer when memory runs out; an exception stops it in time.
void* allocate(std::size_t bytes) {
  void* const memory = std::malloc(bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

// Replaces stb's own compressor, which takes about fifteen times as long (docs/packages.md). stb
// frees the result.
unsigned char* compress(unsigned char* data, int size, int* compressed_size, int /*level*/) {
  const texmap::Bytes bytes(data, static_cast<std::size_t>(size));
  const std::size_t most = texmap::most_deflated_bytes(bytes.size());
  auto* const room = static_cast<unsigned char*>(allocate(most));
  *compressed_size = static_cast<int>(texmap::deflate(bytes, {room, most}));
  return room;
}

std::uint32_t checksum(const unsigned char* data, int size) {
  return texmap::crc32({data, static_cast<std::size_t>(size)});
}

}  // namespace

#define STBIW_MALLOC(size) allocate(size)
#define STBIW_REALLOC(memory, size) std::realloc(memory, size)  // used by its own compressor alone
#define STBIW_FREE(memory) std::free(memory)
#define STBIW_ZLIB_COMPRESS compress
#define STBIW_CRC32 checksum

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
