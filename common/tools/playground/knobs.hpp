// What a page offers in chapters 01 to 06, and their programs do not.
#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "live.hpp"
#include "tools/diagnose/wrong_program.hpp"

namespace texmap::live {

/// A lesson on the stage, as a program with a slip draws it.
template <class Lesson>
struct Mistaken {
  const Lesson& lesson;
  const slips::Way& way;

  Rgb operator()(const Ray<double>& ray) const {
    slips::StageView stage;
    stage.sky = lesson.stage.sky;
    const slips::Seen seen = slips::see(lesson, ray, stage);
    return slips::WrongProgram(stage).light_of(way, seen);
  }
};

/// The choices that a page offers and a chapter's program does not.
template <class Lesson>
struct Knobs {
  double squares = 10;
  double eye = 1;         ///< how many times as far away the eye is
  bool errors = false;    ///< shows texel errors
  std::string mistake{};  ///< what its words begin with; empty: none
  slips::Way way{};       ///< of the mistake

  static constexpr bool may_slip = slips::OfTheStage<Lesson>;
  static constexpr bool may_err = HasSpheres<Lesson>;
  static constexpr bool has_squares = requires(Lesson & lesson) {
    lesson.checkered.texture.squares;
  };

  /// What is drawn in place of the lesson's picture; nothing: that.
  std::optional<Image> draw(const Lesson& lesson, const View<>& view,
                            const RenderSettings& how) const {
    if constexpr (may_err) {
      if (errors) return draw_errors(lesson, view);
    }
    if constexpr (may_slip) {
      if (!mistake.empty()) return render<double>(Mistaken<Lesson>{lesson, way}, view, how);
    }
    return std::nullopt;
  }

  void declare(CommandLine& line) {
    if constexpr (has_squares)
      line.decimal("--squares", squares, 1, 1000, "squares of the checkerboard, in u and in v");
    if constexpr (HasSpheres<Lesson>) {
      line.decimal("--eye", eye, 1, 1e9,
                   "moves the eye away by this factor, and enlarges the picture by the same");
      line.flag("--errors", errors,
                "shows how far float and double are apart on the texture, in texels");
    }
    if constexpr (may_slip)
      line.text("--mistake", "WORDS", mistake, "draws with a mistake that students make");
  }

  void apply(Lesson& lesson) {
    if constexpr (may_slip) {
      const auto found = slips::row_named(mistake);
      if (!found && !mistake.empty()) throw UsageError("no mistake: " + mistake);
      if (found) way.row.at(static_cast<std::size_t>(found->first)) = found->second;
    }
    if constexpr (has_squares) {
      for (auto& object : lesson.objects) {
        with_paint(object.paint, [this](auto& paint) {
          if constexpr (requires { paint.texture.squares; }) paint.texture.squares = squares;
        });
      }
    }
    Camera& camera = lesson.stage.camera;
    camera.eye = camera.target + (camera.eye - camera.target) * eye;
  }
};

}  // namespace texmap::live
