// Names that no system can write a file to.
#pragma once
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace texmap::test {

/// A name, and the reason that an error gives.
struct Unwritable {
  std::string name, why;
};

/// Such names; puts one file into the folder.
[[nodiscard]] inline std::vector<Unwritable> unwritable_names(const TemporaryFolder& folder) {
  put(folder / "file", {1});
  return {
      {"", "the name is empty"},
      {std::string("a\0b", 3), "the name has a zero byte in it"},
      {folder.path(), "it is a folder"},
      {folder / "", "the name is that of a folder"},
      {folder / "missing/picture.png", "the folder '" + (folder / "missing") + "' does not exist"},
      {folder / "file/picture.png", "'" + (folder / "file") + "' is a file, not a folder"},
      {folder / std::string(300, 'x'), "the name is too long"},
      {folder / std::string(256, 'x'), "the name is too long"},
  };
}

}  // namespace texmap::test
