// A walk through the blocks of a JPEG scan.
#include "jpeg_scan.hpp"

#include <array>
#include <cstddef>
#include <cstdlib>

#include "image_error.hpp"

namespace texmap {
namespace {

constexpr int largest_constant = 32767;

[[noreturn]] void damaged() { throw Refusal("the JPEG file is damaged: its pixels have a code that makes no sense"); }

class Walk {
 public:
  Walk(const JpegScan& scan, Bytes data) : scan_(scan), bits_(data) {}

  Bytes run() {
    for (std::uint64_t unit = 0; unit < scan_.units; ++unit) {
      if (scan_.restart_interval != 0 && unit != 0 && unit % scan_.restart_interval == 0) {
        bits_.take_restart(unit / scan_.restart_interval - 1);
        constant_ = {};
        empty_blocks_ = 0;
      }
      const std::uint64_t column = unit % scan_.units_in_a_row;
      const std::uint64_t row = unit / scan_.units_in_a_row;
      if (scan_.channels.size() == 1) {
        block(0, column, row);
        continue;
      }
      for (std::size_t channel = 0; channel < scan_.channels.size(); ++channel) {
        const JpegPlane& plane = *scan_.channels[channel].plane;
        for (std::uint32_t y = 0; y < plane.down; ++y) {
          for (std::uint32_t x = 0; x < plane.across; ++x) block(channel, column * plane.across + x, row * plane.down + y);
        }
      }
    }
    return bits_.after();
  }

 private:
  void block(std::size_t channel, std::uint64_t column, std::uint64_t row) {
    const JpegScanChannel& part = scan_.channels[channel];
    if (!scan_.progressive) {
      constant(channel);
      varying(part);
    } else if (scan_.first == 0) {
      if (scan_.refines) {
        bits_.number(1);
      } else {
        constant(channel);
      }
    } else {
      std::uint64_t& not_zero = part.plane->known_not_zero[row * part.plane->stride + column];
      if (scan_.refines) {
        refine(part, not_zero);
      } else {
        spectrum(part, not_zero);
      }
    }
  }

  // The constant coefficient, sent as the difference to the block before.
  void constant(std::size_t channel) {
    const std::uint32_t size = bits_.symbol(*scan_.channels[channel].dc);
    if (size == 0) return;
    const int bits = static_cast<int>(bits_.number(size));
    const int half = 1 << (size - 1);
    constant_[channel] += bits >= half ? bits : bits - 2 * half + 1;
    if (std::abs(constant_[channel]) > largest_constant) damaged();
  }

  // The other 63 coefficients of a block that is sent all at once.
  void varying(const JpegScanChannel& part) {
    for (std::uint32_t k = 1; k < 64; ++k) {
      const std::uint32_t code = bits_.symbol(*part.ac);
      const std::uint32_t run = code >> 4;
      const std::uint32_t size = code & 15;
      if (size == 0 && run != 15) return;
      k += run;
      if (k > 63) damaged();
      bits_.number(size);
    }
  }

  // The first bits of some coefficients; a code can say that many blocks have no more of them.
  void spectrum(const JpegScanChannel& part, std::uint64_t& not_zero) {
    if (empty_blocks_ > 0) {
      --empty_blocks_;
      return;
    }
    for (std::uint32_t k = scan_.first; k <= scan_.last; ++k) {
      const std::uint32_t code = bits_.symbol(*part.ac);
      const std::uint32_t run = code >> 4;
      const std::uint32_t size = code & 15;
      if (size == 0 && run != 15) {
        empty_blocks_ = (1U << run) - 1 + bits_.number(run);
        return;
      }
      k += run;
      if (k > scan_.last || size + scan_.bit > 15) damaged();
      if (size == 0) continue;
      bits_.number(size);
      not_zero |= std::uint64_t{1} << k;
    }
  }

  // One more bit of each coefficient that is not zero, and some that have just become so.
  void refine(const JpegScanChannel& part, std::uint64_t& not_zero) {
    std::uint32_t k = scan_.first;
    while (k <= scan_.last && empty_blocks_ == 0) {
      const std::uint32_t code = bits_.symbol(*part.ac);
      std::uint32_t run = code >> 4;
      const std::uint32_t size = code & 15;
      if (size > 1) damaged();
      if (size == 0 && run != 15) {
        empty_blocks_ = (1U << run) + bits_.number(run);  // this block included
        break;
      }
      if (size == 1) bits_.number(1);
      for (bool placed = false; k <= scan_.last && !placed; ++k) {
        const std::uint64_t here = std::uint64_t{1} << k;
        if ((not_zero & here) != 0) {
          bits_.number(1);
        } else if (run > 0) {
          --run;
        } else {
          placed = true;
          if (size == 1) not_zero |= here;
        }
      }
    }
    if (empty_blocks_ == 0) return;
    --empty_blocks_;
    for (; k <= scan_.last; ++k) {
      if ((not_zero >> k & 1) != 0) bits_.number(1);
    }
  }

  const JpegScan& scan_;
  JpegBits bits_;
  std::array<int, 4> constant_{};
  std::uint32_t empty_blocks_ = 0;
};

}  // namespace

Bytes check_scan(const JpegScan& scan, Bytes data) { return Walk(scan, data).run(); }

}  // namespace texmap
