// What the operating system says about a file, in words that help.
#include "engine/picture/files/errno_message.hpp"

#include <cerrno>
#include <system_error>

#include "engine/picture/files/file_error.hpp"

namespace texmap {

std::string errno_message(int error) {
  switch (error) {
    case ENOENT:
      return "there is no such file";
    case ENOTDIR:
      return "a part of the path is a file, not a folder";
    case EACCES:
    case EPERM:
      return "no permission";
    case ELOOP:
      return "too many symbolic links; one probably points back at itself";
    case ENAMETOOLONG:
      return "the name is too long";
    case ENOSPC:
    case EDQUOT:
      return "the disk is full";
    case EROFS:
      return "the disk is read-only";
    case EFBIG:
      return "the file would be larger than the system allows";
    case ENXIO:
      return "nobody is at the other end of the pipe";
    case EMFILE:
    case ENFILE:
      return "too many files are open";
    default:
      return std::generic_category().message(error);
  }
}

void require_success(bool succeeded) {
  if (!succeeded) throw FileError(errno_message(errno));
}

void check_name(const std::string& path) {
  if (path.empty()) throw FileError("the name is empty");
  if (path.find('\0') != std::string::npos) throw FileError("the name has a zero byte in it");
}

}  // namespace texmap
