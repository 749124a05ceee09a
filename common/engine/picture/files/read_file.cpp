// A whole file, read into memory.
#include "engine/picture/files/read_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>

#include "engine/picture/files/errno_message.hpp"
#include "engine/picture/files/file_descriptor.hpp"
#include "engine/picture/files/file_error.hpp"
#include "engine/picture/files/image_limits.hpp"

namespace texmap {
namespace {

// open() alone says the same about a missing file and about a link that leads nowhere.
std::string why_not_opened(const std::string& path, int error) {
  struct stat link {};
  if (error == ENOENT && lstat(path.c_str(), &link) == 0 && S_ISLNK(link.st_mode)) {
    return "it is a link to a file that does not exist";
  }
  if (error == EACCES || error == EPERM) return "no permission to read it";
  return errno_message(error);
}

std::string what_it_is(mode_t mode) {
  if (S_ISDIR(mode)) return "it is a folder, not an image file";
  if (S_ISFIFO(mode)) return "it is a pipe, not an image file";
  return "it is a device, not an image file";
}

}  // namespace

std::vector<std::uint8_t> read_file(const std::string& path) {
  check_name(path);

  // Opening a pipe would wait for a writer without O_NONBLOCK.
  FileDescriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.number() < 0) throw FileError(why_not_opened(path, errno));

  struct stat status {};
  require_success(fstat(file.number(), &status) == 0);
  if (!S_ISREG(status.st_mode)) throw FileError(what_it_is(status.st_mode));
  if (status.st_size <= 0) throw FileError("the file is empty");
  if (static_cast<std::uint64_t>(status.st_size) > max_file_bytes) {
    throw FileError("the file has " + std::to_string(status.st_size) + " bytes, more than " +
                    std::to_string(max_file_bytes) + " (64 MiB)");
  }

  // One byte more than the size, to notice a file that grows.
  const auto expected = static_cast<std::size_t>(status.st_size);
  std::vector<std::uint8_t> bytes(expected + 1);
  std::size_t have = 0;
  while (have < bytes.size()) {
    const ssize_t got = read(file.number(), bytes.data() + have, bytes.size() - have);
    if (got < 0 && errno == EINTR) continue;
    require_success(got >= 0);
    if (got == 0) break;
    have += static_cast<std::size_t>(got);
  }
  if (have != expected) throw FileError("the file changed while it was being read");
  bytes.resize(expected);
  return bytes;
}

}  // namespace texmap
