// Pictures of students who made known mistakes: each gets its name; what is not sure gets none.
#include <doctest.h>

#include <cmath>
#include <functional>

#include "03_image_texture/lesson.hpp"
#include "engine/compare/known_mistakes.hpp"
#include "engine/picture/find_texture.hpp"
#include "engine/picture/load_image.hpp"
#include "engine/system/system.hpp"
#include "support/image_errors.hpp"
#include "support/made_pictures.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

using namespace texmap;
using namespace texmap::test;

namespace {

const chapter_03::Lesson& lesson() {
  static const auto prepared_once = prepared<chapter_03::Lesson>();
  return prepared_once;
}

const Image& earth() {
  static const Image loaded = load_image(find_texture("earth.png"));
  return loaded;
}

/// What a student's program computes: a color from (u, v).
using LookUp = std::function<Rgb(double u, double v)>;

struct Student {
  const LookUp& look_up;

  [[nodiscard]] Rgb operator()(const Ray<double>& ray) const {
    const auto& objects = lesson().objects;
    return color_along(objects, ray, lesson().stage.sky,
                       [&](const chapter_03::Object& object, const Hit<double>& hit) {
                         const Uv<double> uv = uv_rtiow(hit.normal);
                         const bool is_globe = &object == &objects[chapter_03::middle];
                         return (is_globe ? look_up(uv.u, uv.v) : object.paint(hit)) *
                                lambert(lesson().surface,
                                        sample_light(lesson().stage.light, objects, hit));
                       });
  }
};

Image drawn_by(const LookUp& look_up, int width, int height) {
  return render<double>(Student{look_up}, view_of(lesson().stage.camera, width, height));
}

/// The texel at a column and a row of the map, without limits.
Rgb texel(int column, int row) {
  const int n = earth().width, m = earth().height;
  const Rgb8 t = earth().at(((column % n) + n) % n, std::clamp(row, 0, m - 1));
  return {t.r / 255.0, t.g / 255.0, t.b / 255.0};
}
int column_of(double u) { return static_cast<int>(std::floor(u * earth().width)); }
int row_of(double v) {
  return earth().height - 1 - static_cast<int>(std::floor(v * earth().height));
}
Rgb right_look_up(double u, double v) { return texel(column_of(u), row_of(v)); }

struct Mistake {
  const char* word;
  LookUp look_up;
};

/// Written as students write them: nothing here comes from mistaken_maps.
std::vector<Mistake> mistakes_in_the_look_up() {
  return {
      {"mirrored: u runs the other way",
       [](double u, double v) { return right_look_up(1 - u, v); }},
      {"upside down: v runs the other way",
       [](double u, double v) { return right_look_up(u, 1 - v); }},
      {"turned by half", [](double u, double v) { return right_look_up(1 - u, 1 - v); }},
      {"half a texel to the left",
       [](double u, double v) {
         return texel(static_cast<int>(std::lround(u * earth().width)), row_of(v));
       }},
      {"one texel to the left",
       [](double u, double v) { return texel(column_of(u) + 1, row_of(v)); }},
      {"one texel up: rows were counted from 1",
       [](double u, double v) { return texel(column_of(u), row_of(v) + 1); }},
      {"a quarter turn off", [](double u, double v) { return right_look_up(u + 0.25, v); }},
      {"a quarter turn off", [](double u, double v) { return right_look_up(u - 0.25, v); }},
      {"half a turn off", [](double u, double v) { return right_look_up(u + 0.5, v); }},
      {"striped",
       [](double u, double v) { return texel(std::max(column_of(u - 0.5), 0), row_of(v)); }},
      {"u and v are exchanged", [](double u, double v) { return right_look_up(v, u); }},
      {"squeezed at the poles",
       [](double u, double v) {
         return right_look_up(u, (1 - std::cos(std::numbers::pi * v)) / 2);
       }},
      {"red and blue are exchanged in the texture",
       [](double u, double v) {
         const Rgb c = right_look_up(u, v);
         return Rgb{c.b, c.g, c.r};
       }},
      {"gray: the texture's colors are lost",
       [](double u, double v) {
         const Rgb c = right_look_up(u, v);
         return gray(0.299 * c.r + 0.587 * c.g + 0.114 * c.b);
       }},
      {"black texture", [](double, double) { return gray(0.0); }},
  };
}

/// What an instructor draws once: the right picture, and all wrong ones.
struct Key {
  Image right;
  std::vector<WrongPicture> wrong;

  explicit Key(const Size& size)
      : right(drawn_by(right_look_up, size.width, size.height)),
        wrong(mistakes_of_the_whole(right)) {
    for (const WrongPicture& map : mistaken_maps(earth())) {
      auto changed = lesson();
      std::get<chapter_03::Textured>(changed.objects[chapter_03::middle].paint).texture.image =
          map.picture;
      wrong.push_back({map.name, map.words, picture(changed, size.width, size.height)});
    }
  }
  [[nodiscard]] std::string name_of(const Image& drawn) const {
    return name_mistake(drawn, right, wrong);
  }
};

/// With every channel up to `levels` off, at random.
Image with_noise(Image image, int levels, std::uint32_t seed) {
  const Image random = noise(image.width, image.height, seed);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    for (const auto channel : {&Rgb8::r, &Rgb8::g, &Rgb8::b}) {
      const int off = random.pixels[i].*channel % (2 * levels + 1) - levels;
      image.pixels[i].*channel =
          static_cast<std::uint8_t>(std::clamp(image.pixels[i].*channel + off, 0, 255));
    }
  }
  return image;
}

const Key& usual_key() {
  static const Key key({400, 300});
  return key;
}

}  // namespace

TEST_CASE("each known mistake of a student is named, by a machine that rounds another way too") {
  const Key& key = usual_key();
  CHECK(count_different(key.right, picture(lesson(), 400, 300)) == 0);
  for (const Mistake& mistake : mistakes_in_the_look_up()) {
    const Image drawn = drawn_by(mistake.look_up, 400, 300);
    CAPTURE(mistake.word);
    CHECK(key.name_of(drawn).starts_with(mistake.word));
    CHECK(key.name_of(with_noise(drawn, 1, 7)).starts_with(mistake.word));
  }
  CHECK(key.name_of(mirrored(key.right)).starts_with("the whole picture is mirrored"));
  CHECK(key.name_of(upside_down(key.right)).starts_with("the whole picture is upside down"));
  // Of another size nothing is said.
  CHECK(key.name_of(mirrored(picture(lesson(), 401, 300))).empty());
  CHECK(name_mistake(Image(), Image(), {}).empty());
}

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
  CHECK(key.name_of(Image(400, 300, {255, 255, 255})).starts_with("white"));
  CHECK(key.name_of(Image(400, 300)).starts_with("black"));
  // Two channels exchanged that no library exchanges, and a gray page, are nothing of these.
  CHECK(key.name_of(each(key.right, [](Byte& r, Byte& g, Byte&) { std::swap(r, g); })).empty());
  CHECK(key.name_of(Image(400, 300, {200, 200, 200})).empty());
}

TEST_CASE("a picture one pixel off is named, whatever fills its edge") {
  const Key& key = usual_key();
  for (const bool around : {true, false}) {
    const auto moved = [&](int right, int down) {
      Image image(400, 300);
      for (int row = 0; row < 300; ++row) {
        for (int column = 0; column < 400; ++column) {
          const int x = column - right, y = row - down;
          const bool inside = x >= 0 && x < 400 && y >= 0 && y < 300;
          if (inside || around)
            image.at(column, row) = key.right.at((x + 400) % 400, (y + 300) % 300);
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
  stray.at(200, 150) = {255, 0, 255};
  CHECK(key.name_of(stray).empty());
  CHECK(key.name_of(noise(400, 300, 5)).empty());
  CHECK(key.name_of(ramps(400, 300)).empty());
  CHECK(key.name_of(Image(400, 300, {120, 160, 220})).empty());
  const Image third =
      drawn_by([](double u, double v) { return right_look_up(u + 0.15, v); }, 400, 300);
  CHECK(key.name_of(third).empty());
  const Image half_way = drawn_by(
      [](double u, double v) { return (right_look_up(1 - u, v) + right_look_up(u, 1 - v)) * 0.5; },
      400, 300);
  CHECK(key.name_of(half_way).empty());
  const Image two_mistakes = drawn_by(
      [](double u, double v) { return texel(column_of(1 - u), row_of(v) + 80); }, 400, 300);
  CHECK(key.name_of(two_mistakes).empty());
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
