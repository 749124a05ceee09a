// What wrong programs draw of chapters that are not on the stage: found by drawing them again, by
// other options, with another texture or under another sky.
#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/compare/known_mistakes.hpp"
#include "engine/draw/develop.hpp"
#include "engine/draw/sample_random.hpp"
#include "engine/fast/prepared_scene.hpp"
#include "engine/run/draw_lesson.hpp"
#include "engine/run/sky_options.hpp"
#include "option_slips.hpp"
#include "stage.hpp"

namespace texmap::slips {

/// Pixels that a view has in a row of so many, or in a column.
constexpr int viewed(int pixels, int every) { return (pixels - 2) / every + 1; }

/// Every n-th pixel of a picture, as view_stage takes them.
inline Image pixels_of(const Image& picture, int every) {
  return image_of(
      viewed(picture.width, every), viewed(picture.height, every),
      [&](int column, int row) { return picture.at(1 + column * every, 1 + row * every); });
}

/// A lesson's picture as its program draws it, at every n-th pixel.
template <class Lesson>
Image drawn_at(Ready<Lesson>& ready, int every) {
  Session session(ready.chosen);
  Image whole;
  session.taken = &whole;
  session.every = every;
  draw_and_save(ready.lesson, session);
  return pixels_of(whole, every);
}
/// Of light that is gathered only the paths of these pixels are followed.
template <std::derived_from<GathersLight> Lesson>
Image drawn_at(Ready<Lesson>& ready, int every) {
  const Lesson& lesson = ready.lesson;
  const Settings& settings = ready.chosen.settings;
  const View<> view = view_of(lesson.stage.camera, settings.width, settings.height);
  const auto scene = prepare_scene<double>(view, lesson.objects, lesson.stage.sky);
  const Sampler sampler(lesson.sampling.sampler, settings.samples,
                        static_cast<std::uint32_t>(lesson.sampling.seed));
  const int half = sampler.samples() / 2;
  Image image(viewed(view.width, every), viewed(view.height, every));
  for_each_row(image.height, 0, {}, [&](int row) {
    std::vector<Rgb> light;
    SampleSums<double> sums(sampler);
    for (int i = 0; i < image.width; ++i) {
      const PixelPlace<double> at{1.0 + i * every, 1.0 + row * every};
      const auto path = [&](auto& random) { return lesson(scene, at, random); };
      const auto pixel = hash_pixels<double>(uint_from_real(at.column), uint_from_real(at.row));
      Rgb first{}, second{};
      sums.add(pixel, 0, half, path, first);
      sums.add(pixel, half, sampler.samples(), path, second);
      light.push_back((first + second) * (1.0 / sampler.samples()));
    }
    develop_row(light.data(), lesson.sampling.transfer, image, row);
  });
  return image;
}

/// What a wrong program makes of the light in a picture of the sky.
struct SkySlip {
  const char *words, *change;
  void (*make)(LightImage& map);
};
template <class Curve>
void through(LightImage& map, const Curve& curve) {
  for (Color<float>& c : map.pixels) c = {curve(c.r), curve(c.g), curve(c.b)};
}
constexpr SkySlip of_skies[] = {
    {"the sky is upside down: v runs the other way", "1 - v",
     [](LightImage& map) {
       for (int top = 0, end = map.height - 1; top < end; ++top, --end)
         std::swap_ranges(&map.at(0, top), &map.at(0, top) + map.width, &map.at(0, end));
     }},
    {"the sky's light is limited to 1: the lamps in it are lost",
     "floats from the file to the last byte",
     [](LightImage& map) { through(map, [](float x) { return std::min(x, 1.0F); }); }},
    {"red and blue are exchanged in the sky", "red is the first float",
     [](LightImage& map) {
       for (Color<float>& c : map.pixels) std::swap(c.r, c.b);
     }},
    {"the sky is too dark: its light was decoded like the bytes of a photograph",
     "a file of light is light already",
     [](LightImage& map) { through(map, [](float x) { return std::pow(x, 2.2F); }); }},
    {"the sky is too pale: its light was encoded before it was added up",
     "the curve of image files comes last",
     [](LightImage& map) { through(map, [](float x) { return std::pow(x, 1 / 2.2F); }); }},
};

/// How a wrong program mirrors.
struct MirrorSlip {
  const char *words, *change;
  Vec3d (*direction)(const Vec3d& ray, const Vec3d& normal);
};
constexpr MirrorSlip of_mirrors[] = {
    {"the mirror shows what is behind it: the sky was read along the ray and not mirrored",
     "`d - n * (2 * dot(d, n))`", [](const Vec3d& d, const Vec3d&) { return d; }},
    {"the mirror shows the sky at its normal, and not at the mirrored ray",
     "`d - n * (2 * dot(d, n))`", [](const Vec3d&, const Vec3d& n) { return n; }},
    {"the mirror shows the other side of the sky: the mirrored ray has the wrong sign",
     "`d - n * (2 * dot(d, n))`",
     [](const Vec3d& d, const Vec3d& n) { return n * (2 * dot(d, n)) - d; }},
    {"the mirror is skewed: the 2 is missing", "`d - n * (2 * dot(d, n))`",
     [](const Vec3d& d, const Vec3d& n) { return d - n * dot(d, n); }},
};
template <class Lesson>
concept HasSky = requires(const Lesson& lesson) {
  lesson.stage.sky.picture.map();
};
template <class Lesson>
struct WithMirror : Lesson {
  Vec3d (*direction)(const Vec3d& ray, const Vec3d& normal) = nullptr;

  Rgb operator()(const auto& scene, const PixelPlace<double>& at, auto& random) const {
    const Ray<double> ray = this->sampling.lens.ray(scene.view, at, random);
    const Nearest<double> met = find_nearest(this->objects, ray);
    Rgb color = light_under_sky(scene.objects, ray, scene.sky, this->sky.matte,
                                this->sampling.bounces, random);
    for_each_hit(this->objects, ray, met, [&](const auto& object, const auto& hit, bool) {
      if (object.paint.mirrors)
        color =
            scene.sky(Ray<double>{hit.outside, normalize(direction(ray.direction, hit.normal))});
    });
    return color;
  }
};

/// A chapter's view of what was drawn at every n-th pixel; no pixel is known to be lit.
inline StageView of_colors(const StageView& stage, const Image& pixels, int every) {
  StageView view{.chapter = stage.chapter,
                 .width = stage.width,
                 .height = stage.height,
                 .tolerance = stage.tolerance};
  view.pixels.reserve(pixels.pixels.size());
  for (int row = 0; row < pixels.height; ++row) {
    for (int column = 0; column < pixels.width; ++column) {
      const Rgb8 is = pixels.at(column, row);
      const auto middle = [](std::uint8_t byte) { return (byte + 0.5) / 255; };
      view.pixels.push_back({.column = 1 + column * every,
                             .row = 1 + row * every,
                             .color = {middle(is.r), middle(is.g), middle(is.b)}});
    }
  }
  return view;
}

template <class Lesson>
void visit_variants(const StageView& stage, const Visit& visit) {
  // Whole pictures are drawn once, for all distances between the viewed pixels.
  constexpr bool is_quick = std::derived_from<Lesson, GathersLight>;
  int number = 0;
  const auto draw = [&]<class Drawn = Lesson>(const Slip& slip,
                                              const std::vector<std::string>& options,
                                              const auto& change, const auto& draw_ready) {
    const int own = number++;
    visit(slip, [&](int every) {
      const int drawn = is_quick ? every : lattice;
      Image& pixels = (*stage.drawn_before)[{own, drawn}];
      if (pixels.pixels.empty()) {
        Ready<Drawn> ready(stage.chapter, options);
        ready.chosen.settings.quiet = true;
        change(ready.lesson);
        ready.build();
        pixels = draw_ready(ready, drawn);
      }
      if (drawn == every) return of_colors(stage, pixels, every);
      StageView view = of_colors(stage, pixels, drawn);
      std::erase_if(view.pixels, [&](const Seen& seen) {
        return (seen.column - 1) % every != 0 || (seen.row - 1) % every != 0;
      });
      return view;
    });
  };
  const auto as_it_is = [](Lesson&) {};
  const auto by_program = [](auto& ready, int every) { return drawn_at(ready, every); };
  for (const OptionSlip* slip : of_chapter(stage.chapter, of_options))
    draw({slip->words, slip->change}, slip->typed(), as_it_is, by_program);
  if constexpr (requires(Lesson lesson) { lesson.texture.kept; }) {
    // A wrong look-up is a right look-up on another map. A sheet takes long: it has the usual ones.
    constexpr std::string_view usual =
        draws_itself<Lesson>
            ? "mirrored upside_down half_turn opposite exchanged bgr decoded encoded black"
            : "";
    for (const WrongPicture& map : mistaken_maps(Lesson().texture.load(), usual)) {
      draw(
          {map.words, ""}, {}, [&](Lesson& lesson) { lesson.texture.kept = map.picture; },
          by_program);
    }
  }
  if constexpr (HasSky<Lesson>) {
    for (const SkySlip& slip : of_skies) {
      draw({slip.words, slip.change}, {}, as_it_is, [&](Ready<Lesson>& ready, int every) {
        LightImage map = ready.lesson.stage.sky.picture.map();
        slip.make(map);
        ready.lesson.stage.sky = SkyLight(Environment(std::move(map)));
        return drawn_at(ready, every);
      });
    }
    for (const MirrorSlip& slip : of_mirrors) {
      draw.template operator()<WithMirror<Lesson>>(
          {slip.words, slip.change}, {}, [&](auto& lesson) { lesson.direction = slip.direction; },
          by_program);
    }
  }
}

/// A chapter that is viewed by its colors alone; with a texture of the reader's there are none.
template <class Lesson>
StageView view_colors(std::string_view chapter, const std::string& texture) {
  StageView stage{.chapter = std::string(chapter)};
  if (!texture.empty()) return stage;
  Ready<Lesson> ready(stage.chapter, {});
  ready.chosen.settings.quiet = true;
  ready.build();
  const Image pixels = drawn_at(ready, lattice);
  stage.width = ready.chosen.settings.width;
  stage.height = ready.chosen.settings.height;
  if constexpr (std::derived_from<Lesson, GathersLight>) stage.tolerance = of_noise;
  stage.pixels = of_colors(stage, pixels, lattice).pixels;
  stage.visit_changed = visit_variants<Lesson>;
  stage.drawn_before = std::make_shared<std::map<std::pair<int, int>, Image>>();
  return stage;
}
template <class Lesson>
constexpr OnStage in_colors(std::string_view name) {
  return {name, view_colors<Lesson>};
}

}  // namespace texmap::slips
