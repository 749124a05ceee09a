// What Linux, macOS and their like say of files: links, pipes, devices. Permissions, and that
// pictures get through whole, are for tests/faults to see, with the programs.
#include <doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "support/made_pictures.hpp"
#include "support/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace texmap;
using namespace texmap::test;

std::string error_of_saving(const std::string& path) {
  return image_error_of([&] { save_png(noise(100, 100, 1), path); });
}

std::string error_of_checking(const std::string& path) {
  return image_error_of([&] { check_output(path); });
}

}  // namespace

TEST_CASE("what cannot be loaded or written is named in words, and at once") {
  const TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  fs::create_symlink("nowhere", folder / "dangling");
  fs::create_symlink("loop", folder / "loop");
  fs::create_symlink(folder / "ring", folder / "ring");
  put(folder / "empty.png", {});
  put(folder / "sparse.png", {});
  fs::resize_file(folder / "sparse.png", std::uintmax_t{10} << 30);
  const std::string loop = "too many symbolic links; one probably points back at itself";
  for (const auto& [path, why] : std::vector<std::pair<std::string, std::string>>{
           {folder / "empty.png/below.png", "a part of the path is a file, not a folder"},
           {folder / "dangling", "it is a link to a file that does not exist"},
           {folder / "loop", loop},
           {folder / std::string(300, 'x'), "the name is too long"},
           {folder / "pipe", "it is a pipe, not a file"},
           {folder / "sparse.png", "the file has 10737418240 bytes, more than 67108864 (64 MiB)"},
           {"/dev/zero", "it is a device, not a file"}}) {
    CHECK(image_error_of([&, file = path] { static_cast<void>(load_image(file)); }) ==
          "cannot load texture '" + path + "': " + why);
  }
  for (const std::string& path : {folder / "loop", folder / "ring"})
    CHECK(error_of_checking(path) == "cannot write '" + path + "': " + loop);
  CHECK(error_of_saving(folder / "pipe") ==
        "cannot write '" + (folder / "pipe") + "': nobody is at the other end of the pipe");
  if (fs::exists("/dev/full"))
    CHECK(error_of_saving("/dev/full") == "cannot write '/dev/full': the disk is full");
}

TEST_CASE("a file that is open already is written to where it is, not replaced") {
  const TemporaryFolder folder;
  const std::string log = folder / "log", other = folder / "picture.png";
  write_text_atomically(log, "a line\n");
  const int opened = open(log.c_str(), O_WRONLY | O_APPEND);
  REQUIRE(opened >= 0);
  const std::string name = "/dev/fd/" + std::to_string(opened);
  fs::create_symlink(name, folder / "link.png");
  const Image picture = noise(9, 7, 1);
  save_png(picture, other);
  for (const std::string& path : {name, folder / "link.png"}) {
    const std::string before = text_in(log);
    save_png(picture, path);
    CHECK(text_in(log) == before + text_in(other));
  }
  close(opened);
  CHECK(error_of_checking(name) == "cannot write '" + name + "': no file with this number is open");
  const int read = open(log.c_str(), O_RDONLY);
  const std::string no = "/proc/self/fd/" + std::to_string(read);
  CHECK(error_of_checking(no) == "cannot write '" + no + "': it was opened for reading");
  close(read);
}
