// Writing a picture: whole or not at all.
#include <doctest.h>
#include <signal.h>
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG  // the programs have no PNG decoder of stb_image
#include <stb_image.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/picture/decode_image.hpp"
#include "engine/picture/files/write_file.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/picture/save_png.hpp"
#include "support/image_errors.hpp"
#include "support/running.hpp"
#include "support/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using texmap::check_output;
using texmap::encode_png;
using texmap::Image;
using texmap::load_image;
using texmap::Rgb8;
using texmap::save_png;
using texmap::test::bytes_of;
using texmap::test::image_error_of;
using texmap::test::put;
using texmap::test::TemporaryFolder;

// A picture in which every pixel, and every channel, differs from its neighbours.
Image colorful(int width, int height) {
  Image image(width, height);
  std::uint32_t number = 1;
  for (Rgb8& pixel : image.pixels) {
    for (std::uint8_t* channel : {&pixel.r, &pixel.g, &pixel.b}) {
      number = number * 1664525U + 1013904223U;
      *channel = static_cast<std::uint8_t>(number >> 24);
    }
  }
  return image;
}

// The picture that `color(column, row)` gives.
template <class ColorAt>
Image painted(int width, int height, ColorAt color) {
  Image image(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) image.at(column, row) = color(column, row);
  }
  return image;
}

std::uint8_t byte(int number) { return static_cast<std::uint8_t>(number & 0xFF); }

// Pictures whose filtered rows are of every kind: noise, flat, smooth, striped, and mixed.
std::vector<Image> kinds(int width, int height) {
  return {
      colorful(width, height),
      Image(width, height),
      Image(width, height, {255, 254, 1}),
      painted(width, height,
              [](int column, int row) {
                return Rgb8{byte(column), byte(row), byte(column + row)};
              }),
      painted(width, height,
              [](int column, int row) {
                return (column / 5 + row / 3) % 2 == 0 ? Rgb8{255, 0, 0} : Rgb8{};
              }),
      painted(width, height,
              [noise = colorful(width, height)](int column, int row) {
                return column < row ? noise.at(column, row) : Rgb8{byte(row), byte(row), 255};
              }),
  };
}

// What stb_image, which checks no sums, makes of a file in memory.
Image decoded_by_stb(const std::vector<std::uint8_t>& file) {
  int width = 0;
  int height = 0;
  int channels = 0;
  stbi_uc* const pixels = stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &width,
                                                &height, &channels, 3);
  REQUIRE(pixels != nullptr);
  const Image image = painted(width, height, [at = pixels](int, int) mutable {
    return Rgb8{*at++, *at++, *at++};
  });
  stbi_image_free(pixels);
  CHECK(channels == 3);
  return image;
}

mode_t permissions(const std::string& path) {
  struct stat status {};
  REQUIRE(stat(path.c_str(), &status) == 0);
  return status.st_mode & 07777U;
}

std::string error_of_saving(const std::string& path) {
  return image_error_of([&] { save_png(colorful(3, 2), path); });
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

TEST_CASE("a picture comes back from its file as it was") {
  const TemporaryFolder folder;
  const std::array<std::pair<int, int>, 9> sizes = {
      {{1, 1}, {1, 2}, {2, 1}, {3, 5}, {7, 1}, {1, 257}, {255, 3}, {641, 479}, {16384, 1}}};
  for (const auto& size : sizes) {
    CAPTURE(size.first);
    CAPTURE(size.second);
    const Image image = colorful(size.first, size.second);
    save_png(image, folder / "picture.png");
    CHECK(load_image(folder / "picture.png") == image);
  }
  CHECK(folder.size() == 1);
}

TEST_CASE(
    "pictures of every kind and shape come back from their bytes, by stb_image and by our own "
    "checks of the sums") {
  const std::vector<std::pair<int, int>> sizes = {
      {1, 1},  {1, 2},   {2, 1},   {1, 301}, {301, 1},  {3, 3},    {16, 1},    {16, 9},
      {17, 5}, {86, 86}, {85, 87}, {87, 85}, {101, 67}, {341, 33}, {4097, 11}, {11, 4097}};
  for (const auto& size : sizes) {
    CAPTURE(size.first);
    CAPTURE(size.second);
    for (const Image& image : kinds(size.first, size.second)) {
      const std::vector<std::uint8_t> file = encode_png(image);
      CHECK(decoded_by_stb(file) == image);
      CHECK(texmap::decode_image(file) == image);
    }
  }
}

TEST_CASE("the bytes are the same however many threads encode at once") {
  const std::vector<Image> images = kinds(257, 129);
  std::vector<std::vector<std::uint8_t>> alone;
  for (const Image& image : images) alone.push_back(encode_png(image));
  std::array<bool, 8> same{};
  std::vector<std::thread> threads;
  for (bool& mine : same) {
    threads.emplace_back([&] {
      mine = true;
      for (std::size_t i = 0; i < images.size(); ++i)
        mine = mine && encode_png(images[i]) == alone[i];
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const bool mine : same) CHECK(mine);
}

// A flat row is one match after another. Noise takes nine bits for 112 of 256 bytes, else eight.
TEST_CASE("flat pictures are small, and noise is hardly larger than its pixels") {
  CHECK(encode_png(Image(800, 600, {120, 130, 140})).size() < 16000);
  CHECK(encode_png(colorful(800, 600)).size() < 800 * 600 * 3 * 107 / 100);
}

// The table has the sizes of the golden pictures as stb_image_write itself writes them, with its
// default settings.
TEST_CASE("the course's pictures take at most a quarter more than with stb's own compressor") {
  const std::vector<std::pair<std::string, std::size_t>> table = {
      {"01_plain_spheres", 61705}, {"02_checkerboard_uv", 71857}, {"03_image_texture", 89188},
      {"05_y_rotation", 91021},    {"04_uv_conventions", 256430}, {"06_phong_texture_blend", 91137},
  };
  for (const auto& row : table) {
    CAPTURE(row.first);
    CHECK(encode_png(load_image(TEXMAP_TESTS_DIR "/golden/" + row.first + ".png")).size() * 4 <=
          row.second * 5);
  }
}

TEST_CASE("ImageMagick reads the files without a warning and sees the same pixels") {
  if (texmap::test::run("identify -version && compare -version").status != 0) {
    MESSAGE("skipped: there is no ImageMagick here");
    return;
  }
  const TemporaryFolder folder;
  int number = 0;
  for (const Image& image : kinds(101, 67)) {
    const std::string name = folder / std::to_string(number++);
    save_png(image, name + ".png");
    const auto identified = texmap::test::run("identify -regard-warnings '" + name + ".png'");
    CHECK(identified.status == 0);
    CHECK(identified.err == "");
    // The same pixels in the simplest of all formats, which needs no decoder.
    std::string plain = "P6 101 67 255\n";
    for (const Rgb8& pixel : image.pixels) {
      for (const std::uint8_t channel : {pixel.r, pixel.g, pixel.b})
        plain.push_back(static_cast<char>(channel));
    }
    put(name + ".ppm", {plain.begin(), plain.end()});
    CHECK(texmap::test::run("compare -metric AE '" + name + ".png' '" + name + ".ppm' null:").err ==
          "0");
  }
}

TEST_CASE("rows run from the top and channels from red") {
  const TemporaryFolder folder;
  Image image(2, 2);
  image.at(0, 0) = {255, 0, 0};
  image.at(1, 0) = {0, 255, 0};
  image.at(0, 1) = {0, 0, 255};
  save_png(image, folder / "corners.png");
  const Image again = load_image(folder / "corners.png");
  CHECK(again.at(0, 0) == Rgb8{255, 0, 0});
  CHECK(again.at(1, 0) == Rgb8{0, 255, 0});
  CHECK(again.at(0, 1) == Rgb8{0, 0, 255});
  CHECK(again.at(1, 1) == Rgb8{0, 0, 0});
}

TEST_CASE("a picture without pixels, with too many or with a wrong count is not written") {
  const TemporaryFolder folder;
  const std::string path = folder / "none.png";
  const std::string front = "cannot write '" + path + "': ";
  Image wrong(4, 4);
  wrong.pixels.pop_back();
  Image negative;
  negative.width = -1;
  negative.height = 1;
  Image wide;
  wide.width = 16385;
  wide.height = 1;
  Image large;
  large.width = 16384;
  large.height = 16384;
  for (const Image& image : {Image(), wrong, negative, wide, large}) {
    const std::string said = image_error_of([&] { save_png(image, path); });
    INFO("said: ", said);
    CHECK(said.substr(0, front.size()) == front);
    CHECK(folder.size() == 0);
  }
}

TEST_CASE("checking a path that can be written says nothing and makes nothing") {
  const TemporaryFolder folder;
  put(folder / "old.png", {1, 2, 3});
  fs::create_symlink("made later.png", folder / "link.png");
  for (const std::string& path :
       {folder / "new.png", folder / "old.png", folder / "link.png", std::string("/dev/null")}) {
    CHECK_NOTHROW(check_output(path));
  }
  CHECK(folder.size() == 2);
  CHECK(bytes_of(folder / "old.png") == std::vector<std::uint8_t>{1, 2, 3});
}

TEST_CASE("a path that cannot be written is named before any work and again when writing") {
  const TemporaryFolder folder;
  put(folder / "file", {1});
  fs::create_symlink("loop", folder / "loop");
  const std::vector<std::pair<std::string, std::string>> table = {
      {"", "the name is empty"},
      {std::string("a\0b", 3), "the name has a zero byte in it"},
      {folder.path(), "it is a folder"},
      {folder / "", "the name is that of a folder"},
      {folder / "missing/picture.png", "the folder '" + (folder / "missing") + "' does not exist"},
      {folder / "file/picture.png",
       std::string("'") + (folder / "file") + "' is a file, not a folder"},
      {folder / std::string(300, 'x'), "the name is too long"},
      {folder / std::string(256, 'x'), "the name is too long"},
      {folder / "loop", "too many symbolic links; one probably points back at itself"},
  };
  for (const auto& [path, why] : table) {
    const std::string expected = "cannot write '" + std::string(path.c_str()) + "': " + why;
    CHECK(error_of_checking(path) == expected);
    CHECK(error_of_saving(path) == expected);
  }
  CHECK(folder.size() == 2);
}

TEST_CASE("a name of 255 bytes, the longest there is, is written") {
  const TemporaryFolder folder;
  const std::string path = folder / std::string(255, 'x');
  CHECK_NOTHROW(check_output(path));
  CHECK_NOTHROW(save_png(colorful(2, 2), path));
  CHECK(load_image(path) == colorful(2, 2));
}

TEST_CASE("a name without a folder is written into the current folder") {
  const TemporaryFolder folder;
  CHECK(outcome_in_child([&] {
          if (chdir(folder.path().c_str()) != 0) return 3;
          check_output("here.png");
          save_png(colorful(2, 2), "here.png");
          return 0;
        }) == 0);
  CHECK(load_image(folder / "here.png") == colorful(2, 2));
}

TEST_CASE("folders and files without permission are refused to all but root") {
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::all);
  put(folder / "read-only.png", {1, 2, 3});
  fs::permissions(folder / "read-only.png", fs::perms::owner_read);
  fs::create_directory(folder / "closed");
  fs::permissions(folder / "closed", fs::perms::owner_read | fs::perms::owner_exec);
  const int status = outcome_in_child([&] {
    if (geteuid() == 0 && setuid(65534) != 0) return 3;
    if (error_of_checking(folder / "read-only.png").find("permission") == std::string::npos)
      return 4;
    if (error_of_saving(folder / "read-only.png").find("permission") == std::string::npos) return 5;
    if (error_of_checking(folder / "closed/new.png").find("permission") == std::string::npos)
      return 6;
    if (error_of_saving(folder / "closed/new.png").find("permission") == std::string::npos)
      return 7;
    if (image_error_of([&] {
          static_cast<void>(load_image(folder / "read-only.png"));
        }).find("permission") == std::string::npos) {
      return geteuid() == 65534 ? 8 : 0;
    }
    return 0;
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
  save_png(colorful(5, 4), folder / "link to link.png");
  CHECK(fs::is_symlink(folder / "link to link.png"));
  CHECK(fs::is_symlink(folder / "link.png"));
  CHECK_FALSE(fs::is_symlink(folder / "below/target.png"));
  CHECK(load_image(folder / "below/target.png") == colorful(5, 4));
  CHECK(folder.size() == 3);
}

TEST_CASE("a symbolic link that leads nowhere yet leads to the new file") {
  const TemporaryFolder folder;
  fs::create_symlink(folder / "new.png", folder / "link.png");
  save_png(colorful(5, 4), folder / "link.png");
  CHECK(fs::is_symlink(folder / "link.png"));
  CHECK(load_image(folder / "new.png") == colorful(5, 4));
}

TEST_CASE("a new file has the permissions that the umask leaves and a replaced one keeps its own") {
  const TemporaryFolder folder;
  for (const mode_t mask : {mode_t{0}, mode_t{022}, mode_t{027}, mode_t{077}}) {
    const mode_t before = umask(mask);
    const std::string path = folder / std::to_string(mask);
    save_png(colorful(2, 2), path);
    CHECK(permissions(path) == (0666U & ~mask));
    CHECK(umask(before) == mask);
  }
  put(folder / "own.png", {1});
  REQUIRE(chmod((folder / "own.png").c_str(), 0640) == 0);
  save_png(colorful(2, 2), folder / "own.png");
  CHECK(permissions(folder / "own.png") == 0640);
}

TEST_CASE("a device is written to and stays a device") {
  CHECK_NOTHROW(check_output("/dev/null"));
  CHECK_NOTHROW(save_png(colorful(40, 30), "/dev/null"));
  CHECK(fs::is_character_file("/dev/null"));
  if (fs::exists("/dev/full")) {
    CHECK(error_of_saving("/dev/full") == "cannot write '/dev/full': the disk is full");
    CHECK(fs::is_character_file("/dev/full"));
  }
}

TEST_CASE("a pipe that nobody reads is an error and one that somebody reads gets the picture") {
  const TemporaryFolder folder;
  const std::string pipe = folder / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(error_of_saving(pipe) ==
        "cannot write '" + pipe + "': nobody is at the other end of the pipe");

  const Image image = colorful(200, 200);  // more than a pipe holds at once
  std::vector<std::uint8_t> received;
  std::thread reader([&] { received = bytes_of(pipe); });
  bool sent = false;
  for (int attempt = 0; attempt < 1000 && !sent; ++attempt) {
    sent = image_error_of([&] { save_png(image, pipe); }) == "nothing was thrown";
    if (!sent) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  REQUIRE(sent);
  reader.join();
  put(folder / "received.png", received);
  CHECK(load_image(folder / "received.png") == image);
}

// A limit on the size of files acts like a full disk: the write stops in the middle.
TEST_CASE("when the disk is full the old picture stays as it was and nothing else is left") {
  const TemporaryFolder folder;
  save_png(colorful(10, 10), folder / "old.png");
  const std::vector<std::uint8_t> before = bytes_of(folder / "old.png");
  for (const std::string name : {"old.png", "new.png"}) {
    CAPTURE(name);
    CHECK(outcome_in_child([&] {
            const rlimit limit = {4096, 4096};
            if (setrlimit(RLIMIT_FSIZE, &limit) != 0) return 3;
            const std::string said =
                image_error_of([&] { save_png(colorful(100, 100), folder / name); });
            return said == "cannot write '" + (folder / name) +
                               "': the file would be larger than the system allows"
                       ? 0
                       : 4;
          }) == 0);
    CHECK(bytes_of(folder / "old.png") == before);
    CHECK(folder.size() == 1);
  }
}

TEST_CASE("a signal while writing waits until the file is whole and none is lost") {
  const TemporaryFolder folder;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    save_png(colorful(10, 10), folder / "picture.png");
    const pid_t child = fork();
    if (child == 0) {
      ::signal(signal, SIG_DFL);  // the framework of the tests has put its own handler there
      while (true) save_png(colorful(60, 60), folder / "picture.png");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    REQUIRE(kill(child, signal) == 0);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(load_image(folder / "picture.png") == colorful(60, 60));
    CHECK(folder.size() == 1);
  }
}

TEST_CASE("readers of a path that several writers replace always see a whole picture") {
  const TemporaryFolder folder;
  const std::string path = folder / "picture.png";
  const std::array<Image, 2> pictures = {colorful(60, 60), colorful(90, 30)};
  save_png(pictures[0], path);
  std::vector<std::thread> writers;
  for (const Image& picture : pictures) {
    writers.emplace_back([&picture, &path] {
      for (int i = 0; i < 20; ++i) save_png(picture, path);
    });
  }
  int whole = 0;
  for (int i = 0; i < 40; ++i) {
    const Image seen = load_image(path);
    whole += seen == pictures[0] || seen == pictures[1] ? 1 : 0;
  }
  for (std::thread& writer : writers) writer.join();
  CHECK(whole == 40);
  CHECK(folder.size() == 1);
}

TEST_CASE("with the first three descriptors closed the picture is whole and holds nothing else") {
  const TemporaryFolder folder;
  CHECK(outcome_in_child([&] {
          for (const int number : {0, 1, 2}) close(number);
          save_png(colorful(20, 10), folder / "picture.png");
          return 0;
        }) == 0);
  CHECK(load_image(folder / "picture.png") == colorful(20, 10));
}

TEST_CASE("any bytes are written as they are, none at all included") {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> bytes = {0, 255, 10, 13, 0};
  texmap::write_file_atomically(folder / "some", bytes);
  CHECK(bytes_of(folder / "some") == bytes);
  texmap::write_file_atomically(folder / "some", {});
  CHECK(bytes_of(folder / "some").empty());
  CHECK_THROWS_AS(texmap::write_file_atomically(folder / "missing/some", bytes), texmap::FileError);
}
