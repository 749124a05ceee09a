// PNG, JPEG and .hdr files that are built wrongly, one mistake at a time, and what loading them
// says. Whole files of the corpus are in test_load_image.
#include <doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "engine/files/decode_image.hpp"
#include "engine/files/file_error.hpp"
#include "engine/files/load_light.hpp"
#include "engine/files/read_hdr.hpp"
#include "engine/files/text.hpp"

namespace {

using File = std::vector<std::uint8_t>;

/// The colors of a picture, each once for neighbors that have the same.
template <class Pixels>
std::string colors(const Pixels& pixels, double scale) {
  std::string said = "it loads:";
  std::string before;
  for (const auto& pixel : pixels) {
    const std::string color =
        texmap::text(" %.9g,%.9g,%.9g", scale * pixel.r, scale * pixel.g, scale * pixel.b);
    if (color != before) said += color;
    before = color;
  }
  return said + '.';
}

/// The colors, in bytes or of light in 128ths; or the error.
std::string outcome(const File& file) {
  try {
    std::string note;
    const std::string said =
        texmap::looks_like_hdr(file)
            ? colors(texmap::read_hdr(file, texmap::max_light_texels, &note).pixels, 128)
            : colors(texmap::decode_image(file, &note).pixels, 1);
    return said + (note.empty() ? "!" : " " + note);
  } catch (const texmap::FileError& error) {
    return error.what();
  }
}

/// The bytes that words of damaged.tsv stand for; the file says how.
File bytes_of(const std::string& words, const std::map<std::string, File>& names) {
  File bytes;
  std::istringstream in(words);
  for (std::string word; in >> word;) {
    if (const auto named = names.find(word); named != names.end()) {
      bytes.insert(bytes.end(), named->second.begin(), named->second.end());
    } else if (word[0] == '\'') {
      std::replace(word.begin(), word.end(), '~', ' ');
      bytes.insert(bytes.end(), word.begin() + 1, word.end());
    } else {
      const std::size_t star = std::min(word.find('*'), word.size());
      for (std::size_t i = 0; i < star; i += 2)
        bytes.push_back(static_cast<std::uint8_t>(std::stoi(word.substr(i, 2), nullptr, 16)));
      if (star < word.size())
        bytes.insert(bytes.end(), std::stoul(word.substr(star + 1)) - 1, bytes.back());
    }
  }
  return bytes;
}

}  // namespace

TEST_CASE("a file with one mistake is refused with its reason, and the smallest files load") {
  std::ifstream in(TEXMAP_TESTS_DIR "/corpus/damaged.tsv");
  std::map<std::string, File> names;
  int files = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    CAPTURE(line);
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos) {
      const std::size_t sign = line.find(" = ");
      REQUIRE(sign != std::string::npos);
      names[line.substr(0, sign)] = bytes_of(line.substr(sign + 3), names);
      continue;
    }
    const std::string said = outcome(bytes_of(line.substr(tab + 1), names));
    INFO("said: ", said);
    CHECK(said.find(line.substr(0, tab)) != std::string::npos);
    ++files;
  }
  CHECK(files == 313);
}

TEST_CASE("a file that visits 2^26 blocks is read, and one that visits more is refused") {
  // The codes of 32767 empty blocks are so short that a few kilobytes could keep the decoder busy
  // for minutes. This picture has 2^20 blocks, and each scan visits all of them.
  File all = bytes_of(
      "ffd8 ffdb 0043 00 01*64 ffc4 0014 0001 00*16 ffc4 0014 1001 00*15 e0 "
      "ffc2 000b 081000400001011100 ffda 0008 010100000000 00*131072",
      {});
  const auto add_scan = [&all](std::uint8_t coefficient, const std::string& bits) {
    for (const File& part : {bytes_of("ffda 0008 0101 00", {}), File{coefficient, coefficient},
                             bytes_of(bits + " 00*240", {})})
      all.insert(all.end(), part.begin(), part.end());
  };
  for (std::uint8_t k = 1; k < 64; ++k) add_scan(k, "01");
  // Without an end, so that nothing has to be decoded.
  CHECK(outcome(all).find("end marker is missing") != std::string::npos);
  add_scan(1, "10");
  CHECK(outcome(all).find("too many scans for its size") != std::string::npos);
}
