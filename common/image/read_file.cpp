// A whole file, read into memory.
#include "read_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>

#include "file_descriptor.hpp"
#include "image_error.hpp"
#include "image_limits.hpp"
#include "system_words.hpp"

namespace texmap {
namespace {

// open() alone says the same about a missing file and about a link that leads nowhere.
std::string why_not_opened(const std::string& path, int error) {
  struct stat link {};
  if (error == ENOENT && lstat(path.c_str(), &link) == 0 && S_ISLNK(link.st_mode)) {
    return "it is a link to a file that does not exist";
  }
  if (error == EACCES || error == EPERM) return "no permission to read it";
  return system_words(error);
}

std::string what_it_is(mode_t mode) {
  if (S_ISDIR(mode)) return "it is a folder, not an image file";
  if (S_ISFIFO(mode)) return "it is a pipe, not an image file";
  return "it is a device, not an image file";
}

}  // namespace

std::vector<std::uint8_t> read_file(const std::string& path) {
  if (path.empty()) throw Refusal("the name is empty");
  if (path.find('\0') != std::string::npos) throw Refusal("the name has a zero byte in it");

  // Opening a pipe would wait for a writer without O_NONBLOCK.
  FileDescriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.number() < 0) throw Refusal(why_not_opened(path, errno));

  struct stat status {};
  if (fstat(file.number(), &status) != 0) throw Refusal(system_words(errno));
  if (!S_ISREG(status.st_mode)) throw Refusal(what_it_is(status.st_mode));
  if (status.st_size <= 0) throw Refusal("the file is empty");
  if (static_cast<std::uint64_t>(status.st_size) > max_file_bytes) {
    throw Refusal("the file has " + std::to_string(status.st_size) + " bytes, more than " + std::to_string(max_file_bytes) +
                  " (64 MiB)");
  }

  // One byte more than the size, to notice a file that grows.
  const auto expected = static_cast<std::size_t>(status.st_size);
  std::vector<std::uint8_t> bytes(expected + 1);
  std::size_t have = 0;
  while (have < bytes.size()) {
    const ssize_t got = read(file.number(), bytes.data() + have, bytes.size() - have);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Refusal(system_words(errno));
    if (got == 0) break;
    have += static_cast<std::size_t>(got);
  }
  if (have != expected) throw Refusal("the file changed while it was being read");
  bytes.resize(expected);
  return bytes;
}

}  // namespace texmap
