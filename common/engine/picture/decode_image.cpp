// From the bytes of a PNG or JPEG file to a picture.
#include "engine/picture/decode_image.hpp"

#include "engine/picture/codecs/image_limits.hpp"
#include "engine/picture/codecs/read_jpeg.hpp"
#include "engine/picture/codecs/read_png.hpp"
#include "engine/system/file_error.hpp"

namespace texmap {

Image decode_image(Bytes file) {
  if (file.size() > max_file_bytes) throw FileError("the file is too long");
  if (file.empty()) throw FileError("the file is empty");
  if (looks_like_png(file)) return read_png(file);
  if (looks_like_jpeg(file)) return read_jpeg(file);
  throw FileError("it is not a PNG or JPEG file, whatever its name says");
}

}  // namespace texmap
