// Files on every system: read whole, written whole or not at all, named in any alphabet.
#include <doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/files/shared.hpp"
#include "engine/files/system.hpp"
#include "support/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using namespace texmap;
using namespace texmap::test;

constexpr std::uint64_t most = 1000;

std::string error_of_reading(const fs::path& path) {
  return image_error_of([&] { static_cast<void>(read_file(path, most)); });
}

std::string error_of_checking(const fs::path& path) {
  return image_error_of([&] { check_writable(path); });
}

std::string error_of_writing(const fs::path& path) {
  return image_error_of([&] { write_text_atomically(path, "new"); });
}

}  // namespace

TEST_CASE("any bytes are written as they are, none at all included") {
  const TemporaryFolder folder;
  const fs::path file = path_of(folder / "some");
  const std::vector<std::uint8_t> bytes = {0, 255, 10, 13, 0, 26, 13, 10};
  write_file_atomically(file, bytes);
  CHECK(bytes_of(folder / "some") == bytes);
  CHECK(read_file(file, most) == bytes);
  write_text_atomically(file, "");
  CHECK(bytes_of(folder / "some").empty());
  CHECK(folder.size() == 1);
}

TEST_CASE("a file is read to the byte in pieces of any size, and refused if it grows or shrinks") {
  std::vector<std::uint8_t> there(999);
  for (std::size_t i = 0; i < there.size(); ++i) there[i] = static_cast<std::uint8_t>(i * i >> 3);
  for (const std::size_t size : {1U, 2U, 998U, 999U, 1000U}) {
    for (const std::size_t piece : {1U, 7U, 998U, 5000U}) {
      std::size_t from = 0;
      std::vector<std::uint8_t> whole;
      const std::string said = image_error_of([&] {
        whole = read_whole(size, most, [&](std::uint8_t* to, std::size_t room) {
          const std::size_t got = std::min({piece, room, there.size() - from});
          std::copy_n(there.begin() + static_cast<std::ptrdiff_t>(from), got, to);
          from += got;
          return got;
        });
      });
      CAPTURE(size);
      CAPTURE(piece);
      CHECK((size == 999 ? whole == there : said == "the file changed while it was being read"));
    }
  }
}

TEST_CASE("what cannot be read is named in the same words on every system") {
  const TemporaryFolder folder;
  put(folder / "empty", {});
  put(folder / "large", std::vector<std::uint8_t>(most + 1));
  put(folder / "largest", std::vector<std::uint8_t>(most));
  CHECK(error_of_reading(path_of("")) == "the name is empty");
  CHECK(error_of_reading(path_of(std::string("a\0b", 3))) == "the name has a zero byte in it");
  CHECK(error_of_reading(path_of(folder / "missing")) == "there is no such file");
  CHECK(error_of_reading(path_of(folder.path())) == "it is a folder, not a file");
  CHECK(error_of_reading(path_of(folder / "empty")) == "the file is empty");
  CHECK(error_of_reading(path_of(folder / "large")) ==
        "the file has 1001 bytes, more than 1000 (0 MiB)");
  CHECK(error_of_reading(path_of(folder / "largest")) == "nothing was thrown");
  CHECK(error_of_reading("/dev/null") == "it is a device, not a file");
}

TEST_CASE("what cannot be written is named before any work and again when writing") {
  const TemporaryFolder folder;
  put(folder / "file", {1});
  for (const auto& [name, why] : std::vector<std::pair<std::string, std::string>>{
           {"", "the name is empty"},
           {std::string("a\0b", 3), "the name has a zero byte in it"},
           {folder.path(), "it is a folder"},
           {folder / "", "the name is that of a folder"},
           {folder / "missing/picture.png",
            "the folder '" + (folder / "missing") + "' does not exist"},
           {folder / "file/picture.png", "'" + (folder / "file") + "' is a file, not a folder"},
           {folder / std::string(256, 'x'), "the name is too long"}}) {
    CHECK(error_of_checking(path_of(name)) == why);
    CHECK(error_of_writing(path_of(name)) == why);
  }
  CHECK(folder.size() == 1);
}

TEST_CASE("a name in any alphabet works, and an old file is replaced") {
  const TemporaryFolder folder;
  for (const std::string name : {"Erde \xC3\xA4\xC3\xB6\xC3\xBC.png", "\xE5\x9C\xB0\xE7\x90\x83",
                                 "\xF0\x9F\x8C\x8D.png", "with spaces & 'quotes'"}) {
    CAPTURE(name);
    const fs::path file = path_of(folder / name);
    CHECK(name_of(file) == folder / name);
    CHECK(error_of_checking(file) == "nothing was thrown");
    write_text_atomically(file, "old");
    write_text_atomically(file, "new");
    CHECK(read_file(file, most) == std::vector<std::uint8_t>{'n', 'e', 'w'});
  }
  CHECK(folder.size() == 4);
}

TEST_CASE("a name without a folder is written into the current folder") {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(path_of(folder.path()));
  const std::string checked = error_of_checking("here");
  const std::string written = error_of_writing("here");
  fs::current_path(before);
  CHECK(checked == "nothing was thrown");
  CHECK(written == "nothing was thrown");
  CHECK(bytes_of(folder / "here").size() == 3);
}

TEST_CASE("readers of a path that several writers replace always see a whole file") {
  const TemporaryFolder folder;
  const fs::path file = path_of(folder / "file");
  const std::array<std::vector<std::uint8_t>, 2> contents = {std::vector<std::uint8_t>(60000, 1),
                                                             std::vector<std::uint8_t>(90000, 2)};
  write_file_atomically(file, contents[0]);
  std::vector<std::thread> writers;
  for (const auto& bytes : contents) {
    writers.emplace_back([&] {
      for (int i = 0; i < 20; ++i) write_file_atomically(file, bytes);
    });
  }
  int whole = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<std::uint8_t> seen = read_file(file, 1U << 20);
    whole += seen == contents[0] || seen == contents[1] ? 1 : 0;
  }
  for (std::thread& writer : writers) writer.join();
  CHECK(whole == 200);
  CHECK(folder.size() == 1);
}

TEST_CASE("the program knows its folder, and what the environment names") {
  CHECK(fs::exists(program_folder()));
  CHECK(folder_in_environment("a variable that nobody has set").empty());
  CHECK_FALSE(folder_in_environment("PATH").empty());
  CHECK(error_of_checking("/dev/null") == "nothing was thrown");
  CHECK(error_of_writing("/dev/null") == "nothing was thrown");
}
