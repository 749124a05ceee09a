// Files as Windows has them: NUL, names that cannot be, files that may only be read.
#include <doctest.h>

#include <filesystem>
#include <string>

#include "engine/files/system.hpp"
#include "support/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace texmap;
using namespace texmap::test;

std::string error_of_writing(const fs::path& path) {
  return image_error_of([&] { write_text_atomically(path, "new"); });
}

}  // namespace

TEST_CASE("NUL takes everything, however it is spelt") {
  for (const char* const name : {"NUL", "nul", "/dev/null"}) {
    CAPTURE(name);
    CHECK(error_of_writing(name) == "nothing was thrown");
    CHECK(image_error_of([&] { static_cast<void>(read_file(name, 9)); }) ==
          "it is a device, not a file");
  }
}

TEST_CASE("a file that may only be read stays as it is") {
  const TemporaryFolder folder;
  const fs::path file = path_of(folder / "read-only.png");
  write_text_atomically(file, "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read);
  const std::string said = error_of_writing(file);
  const std::size_t files = folder.size();
  fs::permissions(file, fs::perms::all);
  CHECK(said == "it cannot be written to: no permission");
  CHECK(files == 1);
  CHECK(bytes_of(folder / "read-only.png").size() == 3);
}

TEST_CASE("backslashes separate folders, and reach the same file") {
  const TemporaryFolder folder;
  fs::create_directory(path_of(folder / "below"));
  write_text_atomically(path_of(folder.path() + "\\below\\file"), "old");
  CHECK(bytes_of(folder / "below/file").size() == 3);
}
