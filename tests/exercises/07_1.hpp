// Exercise 07.1: average light, not bytes
//
// `bytes` are one channel of a pixel's samples, each 0 to 255 as in a file. Return the byte of the
// pixel: the mean of their light, rounded to the nearest byte.
// srgb_decode(x) is the light of an encoded number, and srgb_encode(x) encodes light. For both 0
// means nothing and 1 means all. byte / 255.0 is an encoded number.
#include "exercise.hpp"

int mean_byte(const std::vector<int>& bytes) {
  // solution
  double light = 0;
  for (const int byte : bytes) light += srgb_decode(byte / 255.0);
  const double mean = light / static_cast<double>(bytes.size());
  return static_cast<int>(std::lround(255 * srgb_encode(mean)));
  // start: // Your lines here. bytes.size() says how many there are.
  // start: return bytes.front();
}
// hint: `for (const int byte : bytes)` goes through all of them.
// hint: Decode each byte, add the light, divide by how many, encode the mean.
// hint: byte / 255 with two whole numbers cuts off: 0 for all but 255. And std::lround rounds.
