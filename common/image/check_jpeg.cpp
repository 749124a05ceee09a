// Whether a JPEG file is built as it should be.
#include "check_jpeg.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "image_error.hpp"
#include "image_limits.hpp"
#include "jpeg_scan.hpp"

namespace texmap {
namespace {

constexpr int max_scans = 256;
constexpr int max_tables = 4 * max_scans;
constexpr std::uint64_t max_block_visits = std::uint64_t{1} << 26;  // bounds the time that many small scans can take

[[noreturn]] void damaged(const std::string& how) { throw Refusal("the JPEG file is damaged: " + how); }

struct Component {
  std::uint32_t id = 0;
  std::uint32_t across = 1, down = 1;  // sampling factors, 1 to 4
  std::uint32_t quantization = 0;      // table, 0 to 3
  JpegPlane plane;
  std::array<int, 64> lowest_bit{};  // of each coefficient the lowest bit sent so far; not_sent before its first scan
};
constexpr int not_sent = 99;

// The file, read from the front, and what was found so far.
class Reader {
 public:
  explicit Reader(Bytes file) : rest_(file.subspan(2)) {}

  ImageSize read() {
    while (true) {
      const std::uint32_t marker = take_marker();
      if (marker == 0xD9) break;
      const Bytes data = take_segment();
      const bool comment = (marker >= 0xE0 && marker <= 0xEF) || marker == 0xFE;
      if (marker == 0xDB) {
        quantization_tables(data);
      } else if (marker == 0xC4) {
        huffman_tables(data);
      } else if (marker == 0xDD) {
        restart_interval(data);
      } else if (marker >= 0xC0 && marker <= 0xCF) {
        frame(marker, data);
      } else if (marker == 0xDA) {
        scan(data);
      } else if (!comment) {
        damaged("it has a segment of an unknown kind");
      }
    }
    if (components_ == 0) damaged("it has no picture in it");
    for (std::size_t c = 0; c < components_; ++c) {
      if (component_[c].lowest_bit[0] == not_sent) damaged("a color channel is missing");
    }
    return size_;
  }

 private:
  // The file as a row of segments.

  std::uint32_t take_marker() {
    if (rest_.empty()) throw Refusal("the JPEG file is cut short: its end marker is missing");
    if (rest_[0] != 0xFF) damaged("a segment does not begin where the one before it ends");
    while (!rest_.empty() && rest_[0] == 0xFF) rest_ = rest_.subspan(1);
    if (rest_.empty()) throw Refusal("the JPEG file is cut short: its end marker is missing");
    return take_byte(rest_);
  }

  Bytes take_segment() {
    if (rest_.size() < 2) throw Refusal("the JPEG file is cut short inside a segment");
    const std::size_t length = big_endian_16(rest_, 0);
    if (length < 2) damaged("a segment is shorter than its own length");
    if (length > rest_.size()) throw Refusal("the JPEG file is cut short inside a segment");
    const Bytes data = rest_.subspan(2, length - 2);
    rest_ = rest_.subspan(length);
    return data;
  }

  static std::uint32_t take_byte(Bytes& data) {
    if (data.empty()) damaged("a table or header ends too early");
    const std::uint32_t byte = data[0];
    data = data.subspan(1);
    return byte;
  }

  static void skip(Bytes& data, std::size_t bytes) {
    if (data.size() < bytes) damaged("a table or header ends too early");
    data = data.subspan(bytes);
  }

  // Tables.

  void quantization_tables(Bytes data) {
    while (!data.empty()) {
      const std::uint32_t kind = take_byte(data);
      if (kind >> 4 > 1 || (kind & 15) > 3) damaged("a quantisation table has a number that does not exist");
      skip(data, kind >> 4 == 1 ? 128 : 64);
      has_quantization_[kind & 15] = true;
    }
  }

  void huffman_tables(Bytes data) {
    while (!data.empty()) {
      const std::uint32_t kind = take_byte(data);
      if (kind >> 4 > 1 || (kind & 15) > 3) damaged("a Huffman table has a number that does not exist");
      if (++tables_ > max_tables)
        throw Refusal("the JPEG file has more than " + std::to_string(max_tables) + " Huffman tables");
      if (kind >> 4 == 0) {
        dc_[kind & 15].read(data, 15);
      } else {
        ac_[kind & 15].read(data, 255);
      }
    }
  }

  void restart_interval(Bytes data) {
    if (data.size() != 2) damaged("its restart interval has not 2 bytes");
    restart_interval_ = big_endian_16(data, 0);
  }

  // The picture.

  void frame(std::uint32_t marker, Bytes data) {
    if (marker > 0xC2) {
      throw Refusal(
          "the JPEG file is of a rare kind (lossless, hierarchical or arithmetic); save it as a usual JPEG or as PNG");
    }
    if (components_ != 0) damaged("it has two pictures in it");
    progressive_ = marker == 0xC2;
    if (data.size() < 6) damaged("a table or header ends too early");
    if (data[0] != 8) throw Refusal("the JPEG file has " + std::to_string(data[0]) + " bits a channel, and only 8 can be read");
    size_ = {big_endian_16(data, 3), big_endian_16(data, 1)};
    check_image_size(size_.width, size_.height);
    const std::size_t channels = data[5];
    if (channels != 1 && channels != 3 && channels != 4) {
      damaged("it has " + std::to_string(channels) + " color channels instead of 1, 3 or 4");
    }
    if (data.size() != 6 + 3 * channels) damaged("a header has the wrong length");
    for (std::size_t c = 0; c < channels; ++c) component(component_[c], data.subspan(6 + 3 * c, 3));
    components_ = channels;
    for (std::size_t c = 1; c < components_; ++c) {
      for (std::size_t d = 0; d < c; ++d) {
        if (component_[c].id == component_[d].id) damaged("two color channels have the same number");
      }
    }
    lay_out_blocks();
  }

  static void component(Component& component, Bytes data) {
    component.id = data[0];
    component.plane.across = data[1] >> 4;
    component.plane.down = data[1] & 15;
    component.quantization = data[2];
    component.lowest_bit.fill(not_sent);
    if (component.plane.across < 1 || component.plane.across > 4 || component.plane.down < 1 || component.plane.down > 4) {
      damaged("a color channel has a sampling factor outside 1 to 4");
    }
    if (component.quantization > 3) damaged("a color channel names a quantisation table that does not exist");
  }

  void lay_out_blocks() {
    std::uint32_t across = 1;
    std::uint32_t down = 1;
    for (std::size_t c = 0; c < components_; ++c) {
      across = std::max(across, component_[c].plane.across);
      down = std::max(down, component_[c].plane.down);
    }
    units_in_a_row_ = divide_up(size_.width, 8 * across);
    units_ = std::uint64_t{units_in_a_row_} * divide_up(size_.height, 8 * down);
    std::uint64_t samples = 0;
    for (std::size_t c = 0; c < components_; ++c) {
      Component& component = component_[c];
      if (across % component.plane.across != 0 || down % component.plane.down != 0) {
        damaged("the sampling factors of its color channels do not divide each other");
      }
      component.plane.columns = divide_up(divide_up(size_.width * component.plane.across, across), 8);
      component.plane.rows = divide_up(divide_up(size_.height * component.plane.down, down), 8);
      samples += 64 * units_ * component.plane.across * component.plane.down;
    }
    // The decoder holds a byte for each sample, two more if progressive, and three bytes for each pixel.
    check_decoding_bytes(samples * (progressive_ ? 3 : 1) + std::uint64_t{3} * size_.width * size_.height);
    if (!progressive_) return;
    for (std::size_t c = 0; c < components_; ++c) {
      JpegPlane& plane = component_[c].plane;
      plane.stride = units_in_a_row_ * plane.across;
      plane.known_not_zero.resize(units_ * plane.across * plane.down);
    }
  }

  static std::uint32_t divide_up(std::uint32_t a, std::uint32_t b) { return (a + b - 1) / b; }

  // Scans.

  void scan(Bytes data) {
    if (components_ == 0) damaged("its pixels come before its header");
    if (++scans_ > max_scans) throw Refusal("the JPEG file has more than " + std::to_string(max_scans) + " scans");
    const std::size_t channels = take_byte(data);
    if (channels < 1 || channels > components_ || data.size() != 2 * channels + 3)
      damaged("a scan's header has the wrong length");
    const Bytes parameters = data.subspan(2 * channels);
    const std::uint32_t first = parameters[0];
    const std::uint32_t last = parameters[1];
    const int bit_before = parameters[2] >> 4;
    const int bit = parameters[2] & 15;
    check_spectrum(channels, first, last, bit_before, bit);

    JpegScan scan;
    scan.progressive = progressive_;
    scan.first = first;
    scan.last = progressive_ ? last : 63;
    scan.refines = bit_before != 0;
    scan.bit = static_cast<std::uint32_t>(bit);
    scan.restart_interval = restart_interval_;
    std::uint64_t blocks_of_a_unit = 0;
    for (std::size_t i = 0; i < channels; ++i) {
      Component& component = named(data[2 * i]);
      const std::uint32_t dc = data[2 * i + 1] >> 4;
      const std::uint32_t ac = data[2 * i + 1] & 15;
      check_tables(component, first, last, bit_before, dc, ac);
      for (std::uint32_t k = first; k <= scan.last; ++k) send(component, k, bit_before, bit);
      scan.channels.push_back({&component.plane, &dc_[dc], &ac_[ac]});
      blocks_of_a_unit += std::uint64_t{component.plane.across} * component.plane.down;
    }

    // One channel alone is sent block by block, several in units that hold blocks of each.
    const JpegPlane& alone = *scan.channels[0].plane;
    scan.units_in_a_row = channels == 1 ? alone.columns : units_in_a_row_;
    scan.units = channels == 1 ? std::uint64_t{alone.columns} * alone.rows : units_;
    block_visits_ += channels == 1 ? scan.units : scan.units * blocks_of_a_unit;
    if (block_visits_ > max_block_visits) throw Refusal("the JPEG file has too many scans for its size in pixels");
    rest_ = check_scan(scan, rest_);
  }

  void check_spectrum(std::size_t channels, std::uint32_t first, std::uint32_t last, int bit_before, int bit) const {
    if (!progressive_) {
      if (first != 0 || bit_before != 0 || bit != 0) damaged("a scan asks for something that only progressive files have");
      return;
    }
    const bool constant_part = first == 0 && last == 0;
    const bool varying_part = first >= 1 && first <= last && last <= 63 && channels == 1;
    if (!constant_part && !varying_part) damaged("a scan covers frequencies that do not exist or do not go together");
    if (bit > 13 || (bit_before != 0 && bit_before != bit + 1)) damaged("a scan covers bits that do not follow each other");
  }

  Component& named(std::uint32_t id) {
    for (std::size_t c = 0; c < components_; ++c) {
      if (component_[c].id == id) return component_[c];
    }
    damaged("a scan names a color channel that does not exist");
  }

  void check_tables(const Component& component, std::uint32_t first, std::uint32_t last, int bit_before, std::uint32_t dc,
                    std::uint32_t ac) const {
    if (dc > 3 || ac > 3) damaged("a scan names a Huffman table that does not exist");
    const bool needs_dc = first == 0 && bit_before == 0;
    const bool needs_ac = !progressive_ || last > 0;
    if ((needs_dc && !dc_[dc].is_there()) || (needs_ac && !ac_[ac].is_there())) damaged("a Huffman table is missing");
    if (!has_quantization_[component.quantization]) damaged("a quantisation table is missing");
  }

  // Each coefficient is sent once, and then made finer bit by bit; the constant one comes first.
  static void send(Component& component, std::uint32_t k, int bit_before, int bit) {
    int& lowest = component.lowest_bit[k];
    const bool constant_is_there = k == 0 || component.lowest_bit[0] != not_sent;
    const bool in_order = bit_before == 0 ? lowest == not_sent : lowest == bit_before;
    if (!constant_is_there || !in_order) damaged("its scans repeat each other or are out of order");
    lowest = bit;
  }

  Bytes rest_;
  ImageSize size_;
  std::array<Component, 4> component_;
  std::size_t components_ = 0;
  bool progressive_ = false;
  std::array<bool, 4> has_quantization_{};
  std::array<JpegCodes, 4> dc_{};
  std::array<JpegCodes, 4> ac_{};
  int tables_ = 0;
  std::uint64_t restart_interval_ = 0;  // units between two restart markers, 0 for none
  std::uint64_t units_ = 0;             // of a scan with several channels
  std::uint32_t units_in_a_row_ = 0;
  std::uint64_t block_visits_ = 0;
  int scans_ = 0;
};

}  // namespace

bool looks_like_jpeg(Bytes file) { return file.size() >= 3 && file[0] == 0xFF && file[1] == 0xD8 && file[2] == 0xFF; }

ImageSize check_jpeg(Bytes file) { return Reader(file).read(); }

}  // namespace texmap
