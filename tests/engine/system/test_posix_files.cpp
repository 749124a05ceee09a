// Files as Linux, macOS and their like have them: links, pipes, devices, permissions, signals.
#include <doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/system/system.hpp"
#include "support/image_errors.hpp"
#include "support/made_pictures.hpp"
#include "support/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace texmap;
using namespace texmap::test;

std::string error_of_loading(const std::string& path) {
  return image_error_of([&] { static_cast<void>(load_image(path)); });
}

mode_t permissions(const std::string& path) {
  struct stat status {};
  REQUIRE(stat(path.c_str(), &status) == 0);
  return status.st_mode & 07777U;
}

std::string error_of_saving(const std::string& path) {
  return image_error_of([&] { save_png(noise(3, 2, 1), path); });
}

std::string error_of_checking(const std::string& path) {
  return image_error_of([&] { check_output(path); });
}

// How work in a child process ends: its exit status, or 1000 plus the signal that ended it.
template <class Work>
int outcome_in_child(Work work) {
  const pid_t child = fork();
  if (child == 0) {
    int status = 99;
    try {
      status = work();
    } catch (...) {
      status = 98;
    }
    _exit(status);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

}  // namespace

TEST_CASE("folders and files without permission are refused to all but root") {
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::all);
  put(folder / "read-only.png", {1, 2, 3});
  fs::permissions(folder / "read-only.png", fs::perms::owner_read);
  fs::create_directory(folder / "closed");
  fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec);
  put(folder / "secret.png", {1, 2, 3});
  fs::permissions(folder / "secret.png", fs::perms::none);
  const int status = outcome_in_child([&] {
    if (geteuid() == 0 && setuid(65534) != 0) return 3;
    int allowed = 0;
    for (const std::string& path : {folder / "read-only.png", folder / "closed/new.png"}) {
      for (const auto& say : {error_of_checking, error_of_saving})
        allowed += say(path).find("permission") == std::string::npos ? 1 : 0;
    }
    return allowed + (error_of_loading(folder / "secret.png").ends_with("read it") ? 0 : 1);
  });
  CHECK(status == 0);
  CHECK(bytes_of(folder / "read-only.png") == std::vector<std::uint8_t>{1, 2, 3});
  fs::permissions(folder / "closed", fs::perms::owner_all);
}

TEST_CASE("a symbolic link stays one and the file it points to is replaced") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "below");
  put(folder / "below/target.png", {1, 2, 3});
  fs::create_symlink("below/target.png", folder / "link.png");
  fs::create_symlink("link.png", folder / "link to link.png");
  save_png(noise(5, 4, 1), folder / "link to link.png");
  CHECK(fs::is_symlink(folder / "link to link.png"));
  CHECK(fs::is_symlink(folder / "link.png"));
  CHECK_FALSE(fs::is_symlink(folder / "below/target.png"));
  CHECK(load_image(folder / "below/target.png") == noise(5, 4, 1));
  CHECK(folder.size() == 3);
  fs::create_symlink(folder / "new.png", folder / "to new.png");
  save_png(noise(5, 4, 2), folder / "to new.png");
  CHECK(fs::is_symlink(folder / "to new.png"));
  CHECK(load_image(folder / "new.png") == noise(5, 4, 2));
}

TEST_CASE("a new file has the permissions that the umask leaves and a replaced one keeps its own") {
  const TemporaryFolder folder;
  for (const mode_t mask : {mode_t{0}, mode_t{022}, mode_t{027}, mode_t{077}}) {
    const mode_t before = umask(mask);
    const std::string path = folder / std::to_string(mask);
    save_png(noise(2, 2, 1), path);
    CHECK(permissions(path) == (0666U & ~mask));
    CHECK(umask(before) == mask);
  }
  put(folder / "own.png", {1});
  REQUIRE(chmod((folder / "own.png").c_str(), 0640) == 0);
  save_png(noise(2, 2, 1), folder / "own.png");
  CHECK(permissions(folder / "own.png") == 0640);
}

TEST_CASE("a device and a pipe are written to and stay what they are") {
  CHECK_NOTHROW(check_output("/dev/null"));
  CHECK_NOTHROW(save_png(noise(40, 30, 1), "/dev/null"));
  CHECK(fs::is_character_file("/dev/null"));
  if (fs::exists("/dev/full")) {
    CHECK(error_of_saving("/dev/full") == "cannot write '/dev/full': the disk is full");
    CHECK(fs::is_character_file("/dev/full"));
  }
  const TemporaryFolder folder;
  const std::string pipe = folder / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(error_of_saving(pipe) ==
        "cannot write '" + pipe + "': nobody is at the other end of the pipe");
  std::vector<std::uint8_t> received;
  std::thread reader([&] { received = bytes_of(pipe); });
  while (error_of_saving(pipe) != "nothing was thrown") {  // until the reader is there
  }
  reader.join();
  put(folder / "received.png", received);
  CHECK(load_image(folder / "received.png") == noise(3, 2, 1));
}

TEST_CASE("when the disk is full the old picture stays as it was and nothing else is left") {
  const TemporaryFolder folder;
  save_png(noise(10, 10, 1), folder / "old.png");
  const std::vector<std::uint8_t> before = bytes_of(folder / "old.png");
  for (const std::string name : {"old.png", "new.png"}) {
    CAPTURE(name);
    CHECK(outcome_in_child([&] {
            const rlimit limit = {4096, 4096};
            ::signal(SIGXFSZ, SIG_IGN);
            if (setrlimit(RLIMIT_FSIZE, &limit) != 0) return 3;
            const std::string said =
                image_error_of([&] { save_png(noise(100, 100, 1), folder / name); });
            return said == "cannot write '" + (folder / name) +
                               "': the file would be larger than the system allows"
                       ? 0
                       : 4;
          }) == 0);
    CHECK(bytes_of(folder / "old.png") == before);
    CHECK(folder.size() == 1);
  }
}

TEST_CASE("with the first three descriptors closed the picture is whole and holds nothing else") {
  const TemporaryFolder folder;
  CHECK(outcome_in_child([&] {
          for (const int number : {0, 1, 2}) close(number);
          secure_standard_streams();
          for (const int number : {0, 1, 2}) {
            if (fcntl(number, F_GETFD) == -1) return 3;  // a file would get this number
          }
          save_png(noise(20, 10, 1), folder / "picture.png");
          return 0;
        }) == 0);
  CHECK(load_image(folder / "picture.png") == noise(20, 10, 1));
}

TEST_CASE("special files are refused at once") {
  const TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  fs::create_symlink("nowhere", folder / "dangling");
  fs::create_symlink("loop", folder / "loop");
  for (const auto& say : {error_of_checking, error_of_saving}) {
    CHECK(say(folder / "loop") ==
          "cannot write '" + (folder / "loop") +
              "': too many symbolic links; one probably points back at itself");
  }
  put(folder / "empty.png", {});
  put(folder / "sparse.png", {});
  fs::resize_file(folder / "sparse.png", std::uintmax_t{10} << 30);
  const std::string too_long = folder / std::string(300, 'x');

  const std::vector<std::pair<std::string, std::string>> table = {
      {folder / "empty.png/below.png", "a part of the path is a file, not a folder"},
      {folder / "dangling", "it is a link to a file that does not exist"},
      {folder / "loop", "too many symbolic links; one probably points back at itself"},
      {too_long, "the name is too long"},
      {folder / "pipe", "it is a pipe, not a file"},
      {folder / "sparse.png", "the file has 10737418240 bytes, more than 67108864 (64 MiB)"},
      {"/dev/zero", "it is a device, not a file"},
  };
  for (const auto& [path, why] : table) {
    CHECK(error_of_loading(path) ==
          "cannot load texture '" + std::string(path.c_str()) + "': " + why);
  }
}
