// From a picture to a PNG file.
#include "engine/picture/save_png.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/measure/stopwatch.hpp"
#include "engine/picture/codecs/checksums.hpp"
#include "engine/picture/codecs/image_limits.hpp"
#include "engine/picture/codecs/png_chunks.hpp"
#include "engine/system/system.hpp"

namespace texmap {
namespace {

using File = std::vector<std::uint8_t>;

// The pixels as PNG stores them: each row begins with the number of its filter. Filter 1 in every
// row is each byte minus the one a pixel to its left.
void filter_rows(const Image& image, std::uint8_t* to) {
  static_assert(sizeof(Rgb8) == 3);
  const std::size_t size = 3 * static_cast<std::size_t>(image.width);
  const auto* row = reinterpret_cast<const std::uint8_t*>(image.pixels.data());
  for (int i = 0; i < image.height; ++i, row += size, to += size) {
    *to++ = 1;
    std::copy(row, row + 3, to);
    for (std::size_t k = 3; k < size; ++k) to[k] = static_cast<std::uint8_t>(row[k] - row[k - 3]);
  }
}

/// What a filter expects of a byte. Source: PNG specification, section 9.
/// @param a, b, c  the bytes a pixel to the left, above, and above to the left
int expected(int filter, int a, int b, int c) {
  if (filter < 4) return filter == 0 ? 0 : filter == 1 ? a : filter == 2 ? b : (a + b) / 2;
  const int from_a = std::abs(b - c);
  const int from_b = std::abs(a - c);
  const int from_c = std::abs(a + b - 2 * c);
  return from_a <= from_b && from_a <= from_c ? a : from_b <= from_c ? b : c;
}

/// A row with its filter's number.
/// @param above  the row above it, zeros for the first
File filtered_row(Bytes row, Bytes above, int filter) {
  File filtered{static_cast<std::uint8_t>(filter)};
  filtered.reserve(row.size() + 1);
  for (std::size_t k = 0; k < row.size(); ++k) {
    const bool has_left = k >= 3;
    const int guess =
        expected(filter, has_left ? row[k - 3] : 0, above[k], has_left ? above[k - 3] : 0);
    filtered.push_back(static_cast<std::uint8_t>(row[k] - guess));
  }
  return filtered;
}

/// Counts how many different pairs of neighbors a row has.
class Pairs {
 public:
  std::size_t in(Bytes row) {
    ++row_;
    std::size_t count = 0;
    for (std::size_t k = 1; k < row.size(); ++k) {
      std::uint32_t& last = last_[row[k - 1] * 256U + row[k]];
      count += last != row_ ? 1U : 0U;
      last = row_;
    }
    return count;
  }

 private:
  std::vector<std::uint32_t> last_ = std::vector<std::uint32_t>(65536);  // row with this pair
  std::uint32_t row_ = 0;
};

/// The rows without a filter, with filter 1, and each with the one that leaves the fewest pairs.
std::array<File, 3> candidates_of(const Image& image) {
  const std::size_t size = 3 * static_cast<std::size_t>(image.width);
  const Bytes pixels(reinterpret_cast<const std::uint8_t*>(image.pixels.data()),
                     size * static_cast<std::size_t>(image.height));
  const File zeros(size);
  std::array<File, 3> candidates;
  for (File& candidate : candidates) candidate.reserve(pixels.size() + pixels.size() / size);
  Pairs pairs;
  for (std::size_t at = 0; at < pixels.size(); at += size) {
    std::array<File, 5> rows;
    std::array<std::size_t, 5> counts{};
    for (std::size_t filter = 0; filter < rows.size(); ++filter) {
      rows[filter] = filtered_row(pixels.subspan(at, size),
                                  at == 0 ? Bytes(zeros) : pixels.subspan(at - size, size),
                                  static_cast<int>(filter));
      counts[filter] = pairs.in(rows[filter]);
    }
    const auto fewest = std::min_element(counts.begin(), counts.end()) - counts.begin();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const File& row = rows[i < 2 ? i : static_cast<std::size_t>(fewest)];
      candidates[i].insert(candidates[i].end(), row.begin(), row.end());
    }
  }
  return candidates;
}

File deflated(Bytes rows, Packing packing, std::size_t row_bytes) {
  File stream(most_deflated_bytes(rows.size()));
  stream.resize(deflate(rows, stream, packing, row_bytes));
  return stream;
}

/// The shortest stream of the candidates, without those that are much longer when packed fast.
File closely_deflated(const Image& image, std::size_t row_bytes) {
  const std::array<File, 3> candidates = candidates_of(image);
  std::array<std::size_t, 3> sizes{};
  std::transform(candidates.begin(), candidates.end(), sizes.begin(),
                 [&](const File& rows) { return deflated(rows, Packing::fast, row_bytes).size(); });
  const std::size_t most = *std::min_element(sizes.begin(), sizes.end()) / 32 * 33;
  File best;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (sizes[i] > most) continue;
    File stream = deflated(candidates[i], Packing::close, row_bytes);
    if (best.empty() || stream.size() < best.size()) best = std::move(stream);
  }
  return best;
}

void append_big_endian(std::vector<std::uint8_t>& file, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) file.push_back(static_cast<std::uint8_t>(number >> shift));
}

/// @param name  four letters
void append_chunk(std::vector<std::uint8_t>& file, std::string_view name, Bytes data) {
  append_big_endian(file, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = file.size();
  file.insert(file.end(), name.begin(), name.end());
  file.insert(file.end(), data.begin(), data.end());
  append_big_endian(file, crc32(Bytes(file).subspan(start)));
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, Packing packing) {
  if (image.width < 0 || image.height < 0) throw FileError("its size is negative");
  const ImageSize size{static_cast<std::uint32_t>(image.width),
                       static_cast<std::uint32_t>(image.height)};
  check_image_size(size);
  if (image.pixels.size() != std::size_t{size.width} * size.height)
    throw FileError("the picture does not have as many pixels as its size says");

  std::vector<std::uint8_t> header;
  append_big_endian(header, size.width);
  append_big_endian(header, size.height);
  header.insert(header.end(), {8, 2, 0, 0, 0});  // bits a channel, RGB, and what PNG has one of
  std::vector<std::uint8_t> file(png_signature.begin(), png_signature.end());
  const auto append_all = [&](Bytes stream) {
    file.reserve(stream.size() + 64);
    append_chunk(file, "IHDR", header);
    append_chunk(file, "IDAT", stream);
    append_chunk(file, "IEND", {});
  };

  const std::size_t row_bytes = 3 * std::size_t{size.width} + 1;
  if (packing == Packing::close) {
    append_all(closely_deflated(image, row_bytes));
    return file;
  }
  const std::size_t all_bytes = row_bytes * size.height;
  // Memory as it comes: to clear it would take as long as to filter the rows. libc++ 14 has no
  // make_unique_for_overwrite.
  const std::unique_ptr<std::uint8_t[]> rows(new std::uint8_t[all_bytes]);
  filter_rows(image, rows.get());
  const std::size_t most = most_deflated_bytes(all_bytes);
  const std::unique_ptr<std::uint8_t[]> room(new std::uint8_t[most]);
  append_all(
      {room.get(), deflate({rows.get(), all_bytes}, {room.get(), most}, packing, row_bytes)});
  return file;
}

void check_output(const std::filesystem::path& path) {
  with_name("cannot write", path, [&] { check_writable(path); });
}

SavingTime save_png(const Image& image, const std::filesystem::path& path) {
  SavingTime time;
  with_name("cannot write", path, [&] {
    const Stopwatch encoding;
    const std::vector<std::uint8_t> bytes = encode_png(image);
    time.encode = encoding.milliseconds();
    const Stopwatch writing;
    write_file_atomically(path, bytes);
    time.write = writing.milliseconds();
  });
  return time;
}

}  // namespace texmap
