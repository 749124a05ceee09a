// Compresses the rows of a picture, by libdeflate or by stb_image_write.
#include "engine/picture/codecs/deflate.hpp"

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#ifdef TEXMAP_HAVE_LIBDEFLATE
#include <libdeflate.h>
#else
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>
#endif

namespace texmap {

#ifdef TEXMAP_HAVE_LIBDEFLATE

std::vector<std::uint8_t> deflate(Bytes bytes, Packing packing) {
  // Level 1 takes longer for pictures than level 2, which looks for fewer long repetitions.
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(packing == Packing::close ? 12 : 2), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  // Memory as it comes: to clear it would take a tenth of the time.
  const std::size_t most = libdeflate_zlib_compress_bound(compressor.get(), bytes.size());
  const std::unique_ptr<std::uint8_t[]> room(new std::uint8_t[most]);
  const std::size_t size =
      libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), room.get(), most);
  return {room.get(), room.get() + size};
}

#else

std::vector<std::uint8_t> deflate(Bytes bytes, Packing packing) {
  int size = 0;
  const std::unique_ptr<std::uint8_t, decltype(&std::free)> stream(
      stbi_zlib_compress(const_cast<std::uint8_t*>(bytes.data()), static_cast<int>(bytes.size()),
                         &size, packing == Packing::close ? 64 : 5),
      std::free);
  if (!stream) throw std::bad_alloc();
  if (packing == Packing::close) stream.get()[1] = 0xDA;
  return {stream.get(), stream.get() + size};
}

#endif

}  // namespace texmap
