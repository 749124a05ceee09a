// SHA-256, to compare pictures with sums that were made elsewhere.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace texmap::test {

/// The constants of SHA-256: the first 32 fractional bits of the square roots of the first 8 primes
/// and of the cube roots of the first 64. A double holds 18 bits more than that.
struct Sha256Constants {
  std::array<std::uint32_t, 8> start{};
  std::array<std::uint32_t, 64> round{};

  Sha256Constants() {
    const auto fraction = [](double root) {
      return static_cast<std::uint32_t>(static_cast<std::uint64_t>(std::ldexp(root, 32)));
    };
    std::size_t found = 0;
    for (int number = 2; found < round.size(); ++number) {
      bool prime = true;
      for (int divisor = 2; divisor * divisor <= number; ++divisor)
        prime = prime && number % divisor != 0;
      if (!prime) continue;
      if (found < start.size()) start[found] = fraction(std::sqrt(number));
      round[found++] = fraction(std::cbrt(number));
    }
  }
};

/// The SHA-256 of some bytes as 64 lower-case hexadecimal digits.
///
/// Source: FIPS 180-4, sections 4 to 6.
[[nodiscard]] inline std::string sha256(std::span<const std::uint8_t> bytes) {
  static const Sha256Constants constants;
  std::array<std::uint32_t, 8> sum = constants.start;

  // The message, a one bit, zeros, and its length in bits in the last eight bytes of a block of 64.
  std::vector<std::uint8_t> message(bytes.begin(), bytes.end());
  message.push_back(0x80);
  while (message.size() % 64 != 56) message.push_back(0);
  for (int shift = 56; shift >= 0; shift -= 8)
    message.push_back(static_cast<std::uint8_t>((8 * bytes.size()) >> shift & 0xFFU));

  for (std::size_t block = 0; block < message.size(); block += 64) {
    std::array<std::uint32_t, 64> word{};
    for (std::size_t i = 0; i < 64; ++i) {
      if (i < 16) {
        for (std::size_t byte = 0; byte < 4; ++byte)
          word[i] = (word[i] << 8) | message[block + 4 * i + byte];
      } else {
        const std::uint32_t near = word[i - 2];
        const std::uint32_t far = word[i - 15];
        word[i] = word[i - 16] + (std::rotr(far, 7) ^ std::rotr(far, 18) ^ (far >> 3)) +
                  word[i - 7] + (std::rotr(near, 17) ^ std::rotr(near, 19) ^ (near >> 10));
      }
    }
    std::array<std::uint32_t, 8> s = sum;
    for (std::size_t i = 0; i < 64; ++i) {
      const std::uint32_t choice = (s[4] & s[5]) ^ (~s[4] & s[6]);
      const std::uint32_t majority = (s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]);
      const std::uint32_t one = s[7] +
                                (std::rotr(s[4], 6) ^ std::rotr(s[4], 11) ^ std::rotr(s[4], 25)) +
                                choice + constants.round[i] + word[i];
      const std::uint32_t two =
          (std::rotr(s[0], 2) ^ std::rotr(s[0], 13) ^ std::rotr(s[0], 22)) + majority;
      std::rotate(s.begin(), s.end() - 1, s.end());
      s[4] += one;
      s[0] = one + two;
    }
    for (std::size_t i = 0; i < 8; ++i) sum[i] += s[i];
  }

  std::string text;
  for (const std::uint32_t part : sum) {
    for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[(part >> shift) & 15U];
  }
  return text;
}

}  // namespace texmap::test
