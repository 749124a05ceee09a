// What changed between two steps, and whether only that changed which the chapters declare.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "drawn_step.hpp"
#include "engine/compare/difference.hpp"
#include "tools/page/page.hpp"

namespace texmap::steps {

/// Two steps compared.
struct Comparison {
  DrawnStep before, after;
  std::vector<int> may_change;  ///< indices of the objects that the steps in between declare
  Figures figures;
  std::size_t changed_inside =
      0;  ///< changed pixels that show, before or after, an object that may change
  std::size_t changed_elsewhere = 0;
  int stray_column = -1;  ///< the first pixel that changed elsewhere, -1 if there is none
  int stray_row = -1;
  std::size_t pixels_with_uv = 0;  ///< where both steps have texture coordinates
  double largest_du = 0;           ///< turns, the short way round, 0 to 1/2
  double largest_dv = 0;           ///< 0 to 1
  Box uv_box;                      ///< around the pixels of these that have other coordinates
};

/// Names of the stage's objects by index; the sky is -1.
[[nodiscard]] std::string object_name(int index);

/// Errors: DifferenceError if the sizes differ.
[[nodiscard]] Comparison compare(DrawnStep before, DrawnStep after, std::vector<int> may_change);

/// |du| and |dv| next to each other, as difference maps with 255 for half a turn and for the whole
/// height; gray where a step has no texture coordinates.
[[nodiscard]] Image uv_difference_map(const Comparison& comparison);

/// A part of a picture with a few pixels around it.
[[nodiscard]] Image crop(const Image& picture, const Box& box);

/// The pixels around a place, each enlarged to a square, with a frame round the one in the middle.
[[nodiscard]] Image zoom(const Image& picture, int column, int row);

/// All figures as JSON.
[[nodiscard]] std::string report_json(const Comparison& comparison);

/// Where the pictures of a page go.
struct Pictures {
  std::filesystem::path folder;  ///< the page's; empty: they go into the page, which is one file
  std::filesystem::path drawn;   ///< has the chapters' own pictures, which pages then share

  /// @param file  its name in the folder of the page
  [[nodiscard]] page::Picture show(const Image& image, const std::string& file) const;
  /// A step's picture: that of its chapter, or of one before, where it has the same pixels.
  [[nodiscard]] page::Picture show(const DrawnStep& step, const std::string& file) const;
  /// The picture in a file of the drawn ones.
  [[nodiscard]] page::Picture show(const std::filesystem::path& file) const;
};

/// A chapter on a page: its lesson and its picture.
struct Code {
  std::string chapter;            ///< its folder
  std::string text;               ///< of its lesson
  std::filesystem::path picture;  ///< that it drew; empty if there is none
};

/// The page of two steps on the same stage.
[[nodiscard]] std::string report_page(const Comparison& comparison, const std::string& before_code,
                                      const std::string& after_code, const Pictures& pictures = {});

/// The page of two chapters with no pixels to compare.
/// @param why  there are none; the page says so
[[nodiscard]] std::string code_page(const Code& before, const Code& after, const std::string& why,
                                    const Pictures& pictures = {});

/// The page of two pictures of one size.
/// @param a_name, b_name  as the user typed them
[[nodiscard]] std::string picture_page(const std::string& a_name, const Image& a,
                                       const std::string& b_name, const Image& b,
                                       const Figures& figures, const Pictures& pictures = {});

/// Lines for the terminal.
[[nodiscard]] std::string summary(const Comparison& comparison, const std::string& page);

}  // namespace texmap::steps
