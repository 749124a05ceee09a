// What each way to draw one picture costs in time and in accuracy, measured on this machine.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "engine/compare/interleaved.hpp"
#include "texture/image.hpp"

namespace texmap {

/// A way to draw a picture.
struct Way {
  std::string words;            ///< that the user types for it, such as "--number float-pack"
  std::function<Image()> draw;  ///< on one thread
  WorkTime took = {0, 0, 1};
  std::size_t changed = 0;  ///< pixels that are not those of the right picture
  int levels = 0;           ///< the largest difference of a channel, of 255
  double error = 0;         ///< root mean square, in levels
};

/// Ways that are compared with one picture. The first is the one that all times are a part of.
struct TradePart {
  std::string title;  ///< with what is right
  std::function<Image()> right;
  std::vector<Way> ways;
};

/// Fills in what was measured: each picture's difference from the right one, and its time, all ways
/// of a part timed alternately.
///
/// @param seconds  of timing, about, for each part
/// @param report   called with how many parts of the work are done, and how many there are
/// Errors: std::runtime_error if the first way took longer among the others than alone.
void measure_trade(std::vector<TradePart>& parts, double seconds,
                   const std::function<void(int, int)>& report);

/// The table of a part, for a command such as "./course run 03".
[[nodiscard]] std::string table_of(const TradePart& part, const std::string& command);
/// Which command to take: the fastest that changes no pixel, and the fastest for an error.
[[nodiscard]] std::string recommendation(const TradePart& part, const std::string& command);
/// Time across and error up, as SVG.
[[nodiscard]] std::string plot_of(const std::vector<TradePart>& parts, const std::string& command);

}  // namespace texmap
