// The options --trade and --extremes: what ways to draw a picture cost, and how far its scene goes.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "engine/draw/settings.hpp"
#include "texture/image.hpp"

namespace texmap {

class Chosen;
class CommandLine;

/// Makes ready what draws a lesson's picture as its program does after these words.
/// Errors: UsageError where they do not go together, from it or from what it returns.
using DrawingBy = std::function<std::function<Image()>(const std::vector<std::string>& words)>;

/// Measures each way to draw a picture that the program's options offer. Numbers and fast formulas
/// are compared with plain double, samples and filters with many samples. Prints a table, and
/// writes a plot into the picture's folder. Errors: UsageError, FileError, std::runtime_error.
///
/// @param words  that the user typed
/// @param packs  the instructions that the program has packs of
void show_trade(const Chosen& chosen, const CommandLine& line,
                const std::vector<std::string>& words, const std::vector<Instructions>& packs,
                const DrawingBy& drawing);

/// Draws a lesson's scene, in single floats or doubles: all of it `scale` times as large, and moved
/// by so much along each axis.
using DrawScene = std::function<Image(bool in_float, double scale, double moved)>;

/// Prints at which size and at which distance from the origin the picture changes by a pixel, by
/// 1 %, and by a quarter of its pixels.
void show_extremes(const Chosen& chosen, bool has_float, const DrawScene& draw);

}  // namespace texmap
