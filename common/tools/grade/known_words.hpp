// The word for a wrong picture, by the pictures that known mistakes draw.
#pragma once
#include <filesystem>
#include <functional>
#include <list>
#include <string>
#include <utility>
#include <vector>

#include "engine/compare/known_mistakes.hpp"
#include "grades.hpp"

namespace texmap::grade {

/// Names mistakes. The wrong pictures of a chapter are drawn the first time that one is looked for,
/// and kept for the next run.
class KnownWords {
 public:
  /// @param program  draw_mistakes; where it is not there, fewer mistakes get a name
  /// @param folder   for its pictures
  /// @param stopped  whether to end drawing before it is done
  KnownWords(std::filesystem::path program, std::filesystem::path folder,
             std::function<bool()> stopped)
      : program_(std::move(program)), folder_(std::move(folder)), stopped_(std::move(stopped)) {}

  /// Such as "mirrored: u runs the other way"; empty if no known mistake is sure.
  [[nodiscard]] std::string words_for(const Item& item, const Image& is, const Image& should);

 private:
  struct Known {
    std::string item;
    std::vector<WrongPicture> of_the_whole, drawn;
  };
  [[nodiscard]] const Known& known_for(const Item& item, const Image& should);
  [[nodiscard]] std::vector<WrongPicture> drawn_for(const Item& item) const;
  void draw(const Item& item, const std::filesystem::path& folder) const;

  std::filesystem::path program_, folder_;
  std::function<bool()> stopped_;
  std::list<Known> loaded_;  // the last few chapters asked for: each has 120 MB
};

}  // namespace texmap::grade
