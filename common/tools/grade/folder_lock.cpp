// A folder that one program at a time writes to.
#include "folder_lock.hpp"

#include <system_error>

#include "engine/system/file_error.hpp"

#ifndef _WIN32
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#endif

namespace texmap::grade {

FolderLock::FolderLock(const std::filesystem::path& folder, const std::string& other) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw FileError("cannot make the folder '" + name_of(folder) + "': " + error.message());
  }
#ifndef _WIN32
  // Programs that are started inherit the open file: the builder may outlive a killed grade.
  file_ = open((folder / ".lock").c_str(), O_RDWR | O_CREAT, 0666);
  if (file_ < 0) {
    throw FileError("cannot write to the folder '" + name_of(folder) +
                    "': " + std::generic_category().message(errno));
  }
  // Some network file systems have no locks: what then fails is not another program.
  if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(file_);
    throw FileError("another ./course grade is using the folder '" + name_of(folder) +
                    "'; wait for it, or name another folder with " + other);
  }
#else
  static_cast<void>(other);
#endif
}

FolderLock::~FolderLock() {
#ifndef _WIN32
  close(file_);
#endif
}

}  // namespace texmap::grade
