// Whole pictures with known mistakes: each gets its name; what is not sure gets none. Mistakes of
// look-ups stand in pages/test_symptoms.
#include <doctest.h>

#include "engine/compare/known_mistakes.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/system/system.hpp"
#include "support/image_errors.hpp"
#include "support/made_pictures.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

/// What an instructor draws once: the right picture, and all wrong ones.
struct Key {
  Image right = load_image(TEXMAP_TESTS_DIR "/golden/08_repeat.png");
  std::vector<WrongPicture> wrong = mistakes_of_the_whole(right);

  [[nodiscard]] std::string name_of(const Image& drawn) const {
    return name_mistake(drawn, right, wrong);
  }
};
const Key& usual_key() {
  static const Key key;
  return key;
}
constexpr int width = 240, height = 180;

}  // namespace

TEST_CASE("a whole picture with its channels, its colors or its place wrong is named") {
  const Key& key = usual_key();
  const auto each = [](Image image, const auto& change) {
    for (Rgb8& p : image.pixels) change(p.r, p.g, p.b);
    return image;
  };
  using Byte = std::uint8_t;
  const auto exchange = [](Byte& r, Byte&, Byte& b) { std::swap(r, b); };
  const auto order = [](Byte& r, Byte& g, Byte& b) {
    std::swap(r, g);
    std::swap(g, b);
  };
  const std::string wrong_order = "the channels of the whole picture are in the wrong order";
  CHECK(key.name_of(each(key.right, order)) == wrong_order + ": green, blue, red");
  CHECK(key.name_of(each(each(key.right, order), order)) == wrong_order + ": blue, red, green");
  CHECK(key.name_of(mirrored(key.right)).starts_with("the whole picture is mirrored"));
  CHECK(key.name_of(upside_down(key.right)).starts_with("the whole picture is upside down"));
  CHECK(key.name_of(each(mirrored(key.right), exchange)) ==
        "the whole picture is mirrored, and red and blue are exchanged");
  CHECK(key.name_of(each(upside_down(key.right), exchange)) ==
        "the whole picture is upside down, and red and blue are exchanged");
  CHECK(key.name_of(each(key.right,
                         [](Byte& r, Byte& g, Byte& b) {
                           r = static_cast<Byte>(~r);
                           g = static_cast<Byte>(~g);
                           b = static_cast<Byte>(~b);
                         }))
            .starts_with("inverted"));
  CHECK(key.name_of(Image(width, height, {255, 255, 255})).starts_with("white"));
  CHECK(key.name_of(Image(width, height)).starts_with("black"));
  // Two channels exchanged that no library exchanges, and a gray page, are nothing of these.
  CHECK(key.name_of(each(key.right, [](Byte& r, Byte& g, Byte&) { std::swap(r, g); })).empty());
  CHECK(key.name_of(Image(width, height, {200, 200, 200})).empty());
}

TEST_CASE("a picture one pixel off is named, whatever fills its edge") {
  const Key& key = usual_key();
  for (const bool around : {true, false}) {
    const auto moved = [&](int right, int down) {
      Image image(width, height);
      for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
          const int x = column - right, y = row - down;
          const bool inside = x >= 0 && x < width && y >= 0 && y < height;
          if (inside || around)
            image.at(column, row) = key.right.at((x + width) % width, (y + height) % height);
        }
      }
      return image;
    };
    CHECK(key.name_of(moved(1, 0)).ends_with("too far to the right"));
    CHECK(key.name_of(moved(-1, 0)).ends_with("too far to the left"));
    CHECK(key.name_of(moved(0, 1)).ends_with("one pixel too low"));
    CHECK(key.name_of(moved(0, -1)).ends_with("one pixel too high"));
    CHECK(key.name_of(moved(1, -1)).ends_with("in columns and in rows"));
    CHECK(key.name_of(moved(2, 0)).empty());
    CHECK(key.name_of(moved(0, 3)).empty());
  }
}

TEST_CASE("a right picture, a noisy one and an unrelated one get no name") {
  const Key& key = usual_key();
  CHECK(key.name_of(key.right).empty());
  for (const int levels : {1, 8, 60}) CHECK(key.name_of(with_noise(key.right, levels, 3)).empty());
  Image stray = key.right;
  stray.at(100, 90) = {255, 0, 255};
  CHECK(key.name_of(stray).empty());
  CHECK(key.name_of(noise(width, height, 5)).empty());
  CHECK(key.name_of(ramps(width, height)).empty());
  CHECK(key.name_of(Image(width, height, {120, 160, 220})).empty());
  // Of another size nothing is said.
  CHECK(key.name_of(Image(width + 1, height)).empty());
  CHECK(name_mistake(Image(), Image(), {}).empty());
}

TEST_CASE("two mistakes that draw the same picture, with other words, are not told apart") {
  const Image right = ramps(64, 48);
  const Image wrong = mirrored(right);
  const std::vector<WrongPicture> one{{"a", "a mistake", wrong}};
  const std::vector<WrongPicture> two{{"a", "a mistake", wrong}, {"b", "another", wrong}};
  const std::vector<WrongPicture> alike{{"a", "a mistake", wrong}, {"b", "a mistake", wrong}};
  CHECK(name_mistake(wrong, right, one) == "a mistake");
  CHECK(name_mistake(wrong, right, two).empty());
  CHECK(name_mistake(wrong, right, alike) == "a mistake");
  // A mistake that does not show in this picture is no rival.
  CHECK(name_mistake(right, wrong, {{{"c", "another", wrong}, {"a", "a mistake", right}}}) ==
        "a mistake");
}

TEST_CASE("wrong pictures survive in a folder; a broken table is an error that names it") {
  const TemporaryFolder folder;
  const std::vector<WrongPicture> wrong = mistakes_of_the_whole(ramps(40, 30));
  save_wrong_pictures(wrong, folder / "made");
  const std::vector<WrongPicture> loaded = load_wrong_pictures(folder / "made");
  REQUIRE(loaded.size() == wrong.size());
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    CHECK(loaded[i].name == wrong[i].name);
    CHECK(loaded[i].words == wrong[i].words);
    CHECK(count_different(loaded[i].picture, wrong[i].picture) == 0);
  }
  CHECK(image_error_of([&] {
          (void)load_wrong_pictures(folder / "nowhere");
        }).find("mistakes.txt") != std::string::npos);
  const std::string words = "no tab\n";
  write_text_atomically(path_of(folder / "mistakes.txt"), words);
  CHECK(image_error_of([&] {
          (void)load_wrong_pictures(path_of(folder.path()));
        }).find("without a tab") != std::string::npos);
}
