// Which known mistake drew a picture: its name in words, or nothing where that is not sure.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "texture/image.hpp"

namespace texmap {

/// What a known mistake draws.
struct WrongPicture {
  std::string name;   ///< for a file: letters and underscores
  std::string words;  ///< such as "mirrored: u runs the other way"
  Image picture;
};

/// The picture in fewer columns and rows: each pixel is the mean of those it covers.
[[nodiscard]] Image shrunk(const Image& image, int columns, int rows);

/// True by the course's rule for golden pictures: of the pixels at most 0.02 % differ by more than
/// one level. Pictures of different sizes are not the same.
[[nodiscard]] bool is_same_picture(const Image& a, const Image& b);

/// The share of pixels that differ by more than 6 levels when both pictures have been softened:
/// below `nearly_the_same` the same shapes are at the same places. 1 for different sizes.
[[nodiscard]] double apart_when_soft(const Image& a, const Image& b);
inline constexpr double nearly_the_same = 0.004;

/// The words of the mistake that drew a picture; empty if it is right, or if no mistake is sure.
/// Sure: 16 times nearer to the wrong picture than to the right one, and twice as near as to each
/// other wrong one; those that are the same picture are joined, "A; or B". Nearness is the sum of
/// the channels' differences above one level. Without any: how levels or edges differ, if sure.
///
/// @param drawn, right, wrong  a picture of another size than `drawn` counts as far away
[[nodiscard]] std::string name_mistake(const Image& drawn, const Image& right,
                                       std::span<const WrongPicture> wrong);

/// What the words of mistakes begin with: of "mirrored: u runs the other way; or A: B" it is
/// "mirrored or A", of "C: D; and E: F" it is "C and E".
[[nodiscard]] std::string short_words(const std::string& words);

/// What mistakes in the camera and in the file make of a whole picture: mirrored, upside down,
/// channels exchanged, gray, inverted, one color, one pixel off, the curve of image files missing.
[[nodiscard]] std::vector<WrongPicture> mistakes_of_the_whole(const Image& right);

/// Maps on which a right program draws what a wrong look-up of (u, v) or of the texel draws on
/// `map`: mirrored, upside down, moved by half a texel or one, and so on.
///
/// @param map    in any layout in which u runs to the right; what "left" is, is said of the map
/// @param names  of those wanted, with blanks between them; empty: all
[[nodiscard]] std::vector<WrongPicture> mistaken_maps(const Image& map,
                                                      std::string_view names = {});

/// The right pictures in a folder by their names, with words such as "a picture of chapter 02".
/// What is no picture, or cannot be read, is left out.
[[nodiscard]] std::vector<WrongPicture> right_pictures(const std::filesystem::path& folder);

}  // namespace texmap
