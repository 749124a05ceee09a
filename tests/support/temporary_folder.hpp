// A folder for one test, gone with it; files, and the message of an error about one.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/files/file_error.hpp"

namespace texmap::test {

/// A new empty folder that vanishes with everything in it at the end of the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const std::filesystem::path place = std::filesystem::temp_directory_path();
    std::random_device random;
    do {
      path_ = (place / ("texmap-test-" + std::to_string(random()))).generic_string();
    } while (!std::filesystem::create_directory(path_));  // false where there is one
  }
  ~TemporaryFolder() {
    std::error_code nobody_asks;
    std::filesystem::remove_all(path_, nobody_asks);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  [[nodiscard]] const std::string& path() const { return path_; }

  /// How many files and folders are in it.
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_),
                                                  std::filesystem::directory_iterator()));
  }

 private:
  std::string path_;
};

/// All of a file: as text, or as bytes.
[[nodiscard]] inline std::string text_in(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("a test cannot read " + path.string());
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}
[[nodiscard]] inline std::vector<std::uint8_t> bytes_of(const std::string& path) {
  const std::string text = text_in(path);
  return {text.begin(), text.end()};
}

/// True if the words are in the text.
[[nodiscard]] inline bool has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// Makes or replaces a file.
inline void put(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream file(path, std::ios::binary);
  for (const std::uint8_t byte : bytes) file.put(static_cast<char>(byte));
  if (!file.flush()) throw std::runtime_error("a test cannot write " + path);
}

/// What a FileError thrown by `work` says, or "nothing was thrown". Other exceptions go on.
template <class Work>
[[nodiscard]] std::string image_error_of(Work work) {
  try {
    work();
  } catch (const FileError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace texmap::test
