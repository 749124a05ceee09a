// Draws a chapter's picture with the mistakes that students make, for naming them:
//   draw_mistakes NN --out FOLDER [OPTION ...]
// The options are the chapter's own, such as --width 400 --texture uv_map.png. FOLDER gets a PNG
// file for each mistake, mistakes.txt with `FILE, a tab, the words`, and right.png.
#include <algorithm>
#include <array>
#include <sstream>
#include <variant>

#include "01_plain_spheres/lesson.hpp"
#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "04_uv_conventions/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "07_earth_by_sampling/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "10_projections/lesson.hpp"
#include "11_bump_and_normal_maps/lesson.hpp"
#include "12_environment_map/lesson.hpp"
#include "diagnose/wrong_light.hpp"
#include "engine/compare/known_mistakes.hpp"
#include "engine/draw/render.hpp"
#include "engine/files/load_image.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/prepared.hpp"
#include "engine/run/run_chapter.hpp"

namespace {

using namespace texmap;
using Words = std::vector<std::string>;

struct Request {
  std::string chapter;  ///< two digits
  std::filesystem::path folder;
  Words options;  ///< the chapter's own
};

/// Draws what the chapter's program draws with these options into `file`.
template <class Lesson>
Image drawn(const Request& request, const Words& more, const std::filesystem::path& file) {
  Lesson lesson;
  CommandLine line(request.chapter, "");
  Chosen chosen(request.chapter, offer_of(lesson, line), Lesson::about);
  Words words = request.options;
  words.insert(words.end(), more.begin(), more.end());
  static_cast<void>(line.parse(words));
  chosen.settings.quiet = true;
  chosen.settings.out = name_of(file);
  chosen.check();
  build(lesson, chosen);
  Session session(chosen);
  draw_and_save(lesson, session);
  return load_image(file);
}

/// The mistakes that a chapter's own options draw: the rows of by_option.tsv, cell by cell.
std::vector<std::array<std::string, 5>> mistakes_by_option() {
  const std::vector<std::uint8_t> table = read_file(path_of(TEXMAP_BY_OPTION), 1U << 20);
  std::istringstream lines(std::string(table.begin(), table.end()));
  std::vector<std::array<std::string, 5>> rows;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream row(line);
    for (std::string& cell : rows.emplace_back()) std::getline(row, cell, '\t');
  }
  return rows;
}

/// Lessons whose light is that of the stage, on spheres.
template <class Lesson>
concept DrawsStage = !draws_itself<Lesson> && requires(const Lesson& lesson) {
  lesson.objects.front().shape.center;
  requires mistakes::HasHighlight<Lesson> || requires { lesson.surface; };
};

/// Draws a chapter with every mistake that it can show.
template <class Lesson>
std::vector<WrongPicture> draw_all(const Request& request) {
  std::filesystem::create_directories(request.folder);
  const Image right = drawn<Lesson>(request, {}, request.folder / "right.png");
  std::vector<WrongPicture> wrong = mistakes_of_the_whole(right);
  const auto add = [&](const std::string& name, const std::string& words, Image picture) {
    wrong.push_back({name, words, std::move(picture)});
  };
  // Where two mistakes draw the same picture, the chapter's own is named first.
  const auto add_own = [&](const std::string& name, const std::string& words, Image picture) {
    wrong.insert(wrong.begin(), {name, words, std::move(picture)});
  };
  const std::filesystem::path draft = request.folder / "draft.png";

  // A wrong look-up is a right look-up on another map.
  if constexpr (requires { Lesson{}.texture.load(); }) {
    const std::filesystem::path map_file = request.folder / "map.png";
    const Image map = prepared<Lesson>(request.options).texture.load();
    for (const WrongPicture& mistaken : mistaken_maps(map)) {
      save_png(mistaken.picture, map_file);
      add(mistaken.name, mistaken.words,
          drawn<Lesson>(request, {"--texture", name_of(map_file)}, draft));
    }
    std::filesystem::remove(map_file);
  }
  for (const auto& [chapters, option, value, name, words] : mistakes_by_option()) {
    if (chapters.find(request.chapter) == std::string::npos) continue;
    const bool chosen =  // by the user, who took another value
        std::any_of(request.options.begin(), request.options.end(),
                    [&option = option](const auto& word) { return word.starts_with(option); });
    const Words typed = value.empty() ? Words{option} : Words{option, value};
    if (!chosen) add_own(name, words, drawn<Lesson>(request, typed, draft));
  }
  std::filesystem::remove(draft);
  if constexpr (DrawsStage<Lesson>) {
    Lesson lesson;
    const Settings settings = make_ready(lesson, request.options);
    if constexpr (mistakes::HasHighlight<Lesson>) {
      if (lesson.objects.front().material.blends) return wrong;
    }
    const View<> view = view_of(lesson.stage.camera, settings.width, settings.height);
    using Object = typename decltype(lesson.objects)::value_type;
    // The picture with another color at each hit: shade(object, hit, ray).
    const auto add_shaded = [&](const std::string& name, const std::string& words,
                                const auto& shade) {
      add_own(name, words,
              render<double>(
                  [&](const Ray<double>& ray) {
                    return color_along(lesson.objects, ray, lesson.stage.sky,
                                       [&](const Object& object, const Hit<double>& hit) {
                                         return shade(object, hit, ray);
                                       });
                  },
                  view));
    };
    const auto add_all = [&](const auto& light_mistakes) {
      for (const mistakes::LightMistake& one : light_mistakes) {
        add_shaded(one.name, one.words, [&](const auto& object, const auto& hit, const auto& ray) {
          return one.shade(mistakes::Lit(lesson, object, object.paint(hit), hit, ray));
        });
      }
    };
    // The picture by the lesson's light, with another color of the paint or another normal.
    const auto add_lit = [&](const std::string& name, const std::string& words,
                             const auto& change) {
      add_shaded(name, words, [&](const Object& object, Hit<double> hit, const auto& ray) {
        Rgb color = object.paint(hit);
        change(object, hit, color);
        return mistakes::Lit(lesson, object, color, hit, ray).right();
      });
    };
    add_all(mistakes::of_light);
    add_lit("normal_inward", "dark where the lamp shines: the normal points inward",
            [](const Object&, Hit<double>& hit, Rgb&) { hit.normal = -hit.normal; });
    if constexpr (mistakes::HasHighlight<Lesson>) add_all(mistakes::of_highlight);
    if constexpr (requires { lesson.turn; }) {
      // The globe turned by a function of its normal, and its light by another.
      Words not_turned = request.options;
      not_turned.insert(not_turned.end(), {"--degrees", "0"});
      const auto map = prepared<Lesson>(not_turned).objects.front().paint;
      const auto add_turned = [&](const std::string& name, const std::string& words,
                                  const auto& of_texture, const auto& of_light) {
        add_lit(name, words, [&](const Object& object, Hit<double>& hit, Rgb& color) {
          if (&object != &lesson.objects.front()) return;
          Hit<double> from = hit;
          from.normal = of_texture(hit.normal);
          color = map(from);
          hit.normal = of_light(hit.normal);
        });
      };
      const RotationY turn = lesson.turn.rotation();
      const auto alone = [](const Vec3d& normal) { return normal; };
      add_turned("light_turned",
                 "light and shade turned with the globe: the normal was rotated for the light, too",
                 turn, turn);
      const std::string about = "turned about a horizontal axis: y must stay as it is";
      // With the coordinates exchanged in a ring, y is another axis; three exchanges are none.
      const auto next = [](const Vec3d& p) { return Vec3d{p.y, p.z, p.x}; };
      for (const auto& [way, rotation] :
           {std::pair{"", turn}, {"_back", RotationY{turn.cosine, -turn.sine}}}) {
        const auto about_x = [next, rotation = rotation](const Vec3d& p) {
          return next(rotation(next(next(p))));
        };
        const auto about_z = [next, rotation = rotation](const Vec3d& p) {
          return next(next(rotation(next(p))));
        };
        add_turned(std::string("about_x") + way, about, about_x, alone);
        add_turned(std::string("about_z") + way, about, about_z, alone);
      }
    }
    const auto add_other = [&](const std::string& name, const std::string& words,
                               const Lesson& other) {
      add_own(name, words,
              render<double>(other, view_of(other.stage.camera, view.width, view.height)));
    };
    mistakes::of_the_scene(lesson, add_other);
    if constexpr (std::is_same_v<Lesson, chapter_02::Lesson>) {
      using Checkered = chapter_02::Checkered;
      for (const mistakes::UvMistake& one : mistakes::of_uv) {
        add_lit(one.name, one.words, [&](const Object& object, Hit<double>& hit, Rgb& color) {
          const auto* paint = std::get_if<Checkered>(&object.paint);
          if (paint != nullptr) color = paint->texture(one.uv(uv_rtiow(hit.normal), hit.normal.y));
        });
      }
      Lesson other = lesson;
      std::swap(other.checkered.texture.even, other.checkered.texture.odd);
      for (auto& object : other.objects) {
        if (std::holds_alternative<chapter_02::Checkered>(object.paint))
          object.paint = other.checkered;
      }
      add_other("other_squares",
                "every square has the other color: a sign of u or v, a missing 1/2, or the two "
                "colors",
                other);
    }
    Lesson at_corners = lesson;
    at_corners.stage.camera.anchor = PixelAnchor::corner;
    add_other("pixel_corner", "half a pixel off: rays go through the corners of pixels",
              at_corners);
    if constexpr (std::is_same_v<Lesson, chapter_03::Lesson>) {
      auto& paint = lesson.objects[chapter_03::middle].paint;
      std::get<chapter_03::Textured>(paint).texture.rounding = TexelRounding::lecture;
      add_other("last_column", "squeezed: (int)((n - 1) u) in place of floor(n u)", lesson);
    }
  }
  return wrong;
}

/// From chapter 01 on.
constexpr std::array draw_chapter = {
    draw_all<chapter_01::Lesson>, draw_all<chapter_02::Lesson>, draw_all<chapter_03::Lesson>,
    draw_all<chapter_04::Lesson>, draw_all<chapter_05::Lesson>, draw_all<chapter_06::Lesson>,
    draw_all<chapter_07::Lesson>, draw_all<chapter_08::Lesson>, draw_all<chapter_09::Lesson>,
    draw_all<chapter_10::Lesson>, draw_all<chapter_11::Lesson>, draw_all<chapter_12::Lesson>,
};

}  // namespace

int main(int argc, char** argv) {
  // The chapter's options are read by its lesson: this line is for the help and the usage.
  CommandLine line("draw_mistakes", "a chapter's picture with the mistakes that students make");
  std::string number, folder;
  line.positional("NN", number, "the chapter; its own options may follow");
  line.text("--out", "FOLDER", folder, "where the pictures and mistakes.txt go");
  return run_guarded(line, [&] {
    const Words words = typed_words(argc, argv);
    if (words.empty() || words[0] == "--help" || words[0] == "-h") return print(line.help());
    Request request{words[0].substr(0, 2), {}, {}};
    for (std::size_t i = 1; i < words.size(); ++i) {
      if (words[i] == "--out" && i + 1 < words.size()) {
        request.folder = path_of(words[++i]);
      } else {
        request.options.push_back(words[i]);
      }
    }
    if (request.folder.empty()) throw UsageError("name a chapter and a folder: 03 --out FOLDER");
    std::size_t chapter = 1;
    while (chapter <= draw_chapter.size() && request.chapter != text("%02zu", chapter)) ++chapter;
    if (chapter > draw_chapter.size())
      throw UsageError("there are mistakes for chapters 01 to 12, not '" + request.chapter + "'");
    const std::vector<WrongPicture> wrong = draw_chapter[chapter - 1](request);
    save_wrong_pictures(wrong, request.folder);
    print(text("%s: %zu wrong pictures and mistakes.txt\n", name_of(request.folder).c_str(),
               wrong.size()));
  });
}
