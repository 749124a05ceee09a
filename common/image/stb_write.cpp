// The body of stb_image_write: encoding, and nothing else. The only file of the project that holds it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "checksums.hpp"
#include "deflate.hpp"
#include "large_array.hpp"

namespace {

// Takes the place of stb's own compressor, which needs some fifteen times as long (docs/packages.md). stb frees what it
// returns.
unsigned char* compress(unsigned char* data, int size, int* compressed_size, int /*level*/) {
  const texmap::Bytes bytes(data, static_cast<std::size_t>(size));
  const std::size_t most = texmap::most_deflated_bytes(bytes.size());
  auto* const room = static_cast<unsigned char*>(texmap::allocate_bytes(most));
  *compressed_size = static_cast<int>(texmap::deflate(bytes, {room, most}));
  return room;
}

std::uint32_t checksum(const unsigned char* data, int size) { return texmap::crc32({data, static_cast<std::size_t>(size)}); }

}  // namespace

// stb_image_write goes on with a null pointer when memory runs out; an exception stops it in time.
#define STBIW_MALLOC(size) texmap::allocate_bytes(size)
#define STBIW_REALLOC(memory, size) std::realloc(memory, size)  // used by its own compressor alone
#define STBIW_FREE(memory) std::free(memory)
#define STBIW_ZLIB_COMPRESS compress
#define STBIW_CRC32 checksum

#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
