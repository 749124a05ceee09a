// What the operating system says about a file, in words that help.
#include "system_words.hpp"

#include <cerrno>
#include <system_error>

namespace texmap {

std::string system_words(int error) {
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

}  // namespace texmap
