// The program pack_png: packs the pictures of a folder closely, after the course's programs have
// written them fast. The pixels stay.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/app/command_line.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/codecs/bytes.hpp"
#include "engine/picture/codecs/image_limits.hpp"
#include "engine/picture/decode_image.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/render/threads.hpp"
#include "engine/system/system.hpp"

namespace {

using namespace texmap;
using File = std::vector<std::uint8_t>;

/// What a folder's pictures took, and take now.
struct Packed {
  std::atomic<int> pictures = 0;
  std::atomic<std::size_t> before = 0;
  std::atomic<std::size_t> after = 0;
};

/// Only plain files are packed again, with 8 bits a channel, RGB and one chunk of pixels: others
/// may hold more than the pixels. What a zlib stream begins with says how hard it was packed.
bool can_be_packed(const File& file) {
  constexpr std::size_t header = 24;  // bits a channel, RGB, three zeros
  constexpr std::size_t data = 33;    // the chunk's length, name and stream
  constexpr std::size_t around = 33 + 12 + 12;
  constexpr std::array<std::uint8_t, 5> plain = {8, 2, 0, 0, 0};
  return file.size() > around + 2 && std::equal(plain.begin(), plain.end(), &file[header]) &&
         big_endian_32(file, data) + around == file.size() &&
         (file[data + 8] != 0x78 || file[data + 9] != 0xDA);
}

void pack(const std::filesystem::path& path, Packed& packed) {
  with_name("cannot pack", path, [&] {
    const File file = read_file(path, max_file_bytes);
    if (!can_be_packed(file)) return;
    const File closer = encode_png(decode_image(file), Packing::close);
    if (closer.size() < file.size()) write_file_atomically(path, closer);
    packed.pictures += 1;
    packed.before += file.size();
    packed.after += std::min(closer.size(), file.size());
  });
}

void pack_folder(const std::filesystem::path& folder, Packed& packed) {
  std::vector<std::filesystem::path> pictures;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && !entry.is_symlink() && entry.path().extension() == ".png")
      pictures.push_back(entry.path());
  }
  std::sort(pictures.begin(), pictures.end());
  for_each_row(static_cast<int>(pictures.size()), 0, {},
               [&](int i) { pack(pictures[static_cast<std::size_t>(i)], packed); });
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("pack_png", "packs the course's pictures in a folder closely; pixels stay");
  std::string folder;
  line.positional("FOLDER", folder, "its pictures, and those of the folders in it");
  line.statuses("0 all are packed; 1 one could not be; 2 the command line is wrong");
  return run_guarded(line, [&] {
    if (!line.parse(argc, argv)) return;
    Packed packed;
    pack_folder(path_of(folder), packed);
    if (packed.pictures == 0) return;
    print(text("%d pictures packed: %zu KB instead of %zu\n", packed.pictures.load(),
               packed.after / 1024, packed.before / 1024));
  });
}
