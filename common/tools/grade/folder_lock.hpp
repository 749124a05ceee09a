// A folder that one program at a time writes to.
#pragma once
#include <filesystem>
#include <string>

namespace texmap::grade {

/// Keeps a folder for this program and those that it starts, until all have ended. Windows: does
/// nothing.
class FolderLock {
 public:
  /// Makes the folder if it is not there.
  /// @param other  the option that names another folder, such as --work
  /// Errors: FileError if another program has it.
  FolderLock(const std::filesystem::path& folder, const std::string& other);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_ = -1;
};

}  // namespace texmap::grade
