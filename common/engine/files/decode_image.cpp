// From the bytes of a PNG or JPEG file to a picture.
#include "engine/files/decode_image.hpp"

#include "engine/files/file_error.hpp"
#include "engine/files/image_limits.hpp"
#include "engine/files/read_jpeg.hpp"
#include "engine/files/read_png.hpp"

namespace texmap {

Image decode_image(Bytes file, std::string* note) {
  if (file.size() > max_file_bytes) throw FileError("the file is too long");
  if (file.empty()) throw FileError("the file is empty");
  if (looks_like_png(file)) return read_png(file);
  if (looks_like_jpeg(file)) return read_jpeg(file, note);
  throw FileError("it is not a PNG or JPEG file, whatever its name says");
}

}  // namespace texmap
