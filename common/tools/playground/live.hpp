// A chapter's lesson that draws again whenever its options change: the words of the chapter's
// command line go in, rows of pixels come out.
#pragma once
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/run_chapter.hpp"
#include "engine/measure/json.hpp"
#include "texel_error.hpp"
#include "what_a_ray_meets.hpp"

namespace texmap::live {

/// A lesson without its type, for a page.
class LiveLesson {
 public:
  LiveLesson() = default;
  LiveLesson(const LiveLesson&) = delete;
  LiveLesson& operator=(const LiveLesson&) = delete;
  virtual ~LiveLesson() = default;

  /// The options as JSON: name, words, preset, help.
  [[nodiscard]] virtual std::string options() const = 0;
  /// Makes the lesson ready to draw with these words of its command line.
  ///
  /// @param widest  columns of pixels; a wider picture is drawn smaller, in the same shape
  /// Errors: UsageError, FileError; the lesson then is as it was.
  virtual void set(const std::vector<std::string>& words, int widest) = 0;
  /// Columns and rows of the picture.
  [[nodiscard]] virtual Size size() const = 0;
  /// Rows of the picture, the same pixels as if the whole were drawn at once.
  [[nodiscard]] virtual Image rows(int first, int count) const = 0;
  /// What the ray through the center of a pixel meets, with every number on the way, as JSON.
  [[nodiscard]] virtual std::string look(int column, int row) const = 0;
};

/// The choices that a page offers and a chapter's program does not.
template <class Lesson>
struct Knobs {
  double squares = 10;
  double eye = 1;       ///< how many times as far away the eye is
  bool errors = false;  ///< shows texel errors

  static constexpr bool has_squares = requires(Lesson & lesson) {
    lesson.checkered.texture.squares;
  };

  void declare(CommandLine& line) {
    if constexpr (has_squares)
      line.decimal("--squares", squares, 1, 1000, "squares of the checkerboard, in u and in v");
    if constexpr (HasSpheres<Lesson>) {
      line.decimal("--eye", eye, 1, 1e9,
                   "moves the eye away by this factor, and enlarges the picture by the same");
      line.flag("--errors", errors,
                "shows how far float and double are apart on the texture, in texels");
    }
  }

  void apply(Lesson& lesson) const {
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

template <class Lesson>
class Live final : public LiveLesson {
 public:
  [[nodiscard]] std::string options() const override {
    return Json::list_of(state_->line.options(),
                         [](const CommandLine::Option& option) {
                           return Json::object({{"name", option.name},
                                                {"words", option.placeholder},
                                                {"preset", option.preset},
                                                {"help", option.help}});
                         })
        .text;
  }

  void set(const std::vector<std::string>& words, int widest) override {
    auto next = std::make_unique<State>();
    if (!next->line.parse(words)) throw UsageError("a page draws pictures, and prints no help");
    next->get_ready(widest);
    state_ = std::move(next);
  }

  [[nodiscard]] Size size() const override { return {state_->whole.width, state_->whole.height}; }

  [[nodiscard]] Image rows(int first, int count) const override {
    View<> strip = state_->whole;
    strip.height = count;
    strip.center_row -= first;  // a half or a whole number: exact
    const Lesson& lesson = state_->lesson;
    const Settings& settings = state_->session.settings;
    const RenderSettings how{.samples = settings.samples, .threads = 1};
    if constexpr (HasSpheres<Lesson>) {
      if (state_->knobs.errors) return draw_errors(lesson, strip);
    }
    if constexpr (HasSurfaces<Lesson>) {
      if (settings.show != Shown::color) {
        return render<double>(SurfaceColors<Lesson>{lesson, settings.show}, strip,
                              {.samples = 1, .threads = 1});
      }
    }
    if (settings.number == NumberKind::float_) return render<float>(lesson, strip, how);
    return render<double>(lesson, strip, how);
  }

  [[nodiscard]] std::string look(int column, int row) const override {
    const Lesson& lesson = state_->lesson;
    const View<>& view = state_->whole;
    Members members = what_a_ray_meets(lesson, ray_through(view, double(column), double(row)));
    if constexpr (HasSpheres<Lesson>) {
      if (state_->knobs.errors || state_->session.settings.number == NumberKind::float_) {
        const TexelError error = texel_error(lesson, view, column, row);
        Members found{{"object", error.object}};
        if (error.has_uv) {
          found.emplace_back("uv", Json::list({error.uv.u, error.uv.v}));
          found.emplace_back("apart", error.apart);
        }
        members.emplace_back("float", Json::object(found));
      }
    }
    return Json::object(members).text;
  }

 private:
  /// A page shows one picture: the sheets that some lessons save stay out of the module.
  struct OnePicture : Lesson {
    void draw_all(Session&) override {}
  };
  struct State {
    OnePicture lesson;
    CommandLine line{"live", Lesson::about.idea};
    Session session = make_session();
    Knobs<Lesson> knobs;
    View<> whole;

    Session make_session() {
      lesson.options(line);
      return {"live", line, Lesson::about, offers_for(lesson)};
    }

    State() { knobs.declare(line); }

    void get_ready(int widest) {
      Settings& settings = session.settings;
      settings.quiet = true;
      settings.threads = 1;
      lesson.prepare(session);
      knobs.apply(lesson);
      choose_spheres(session, lesson);
      session.plan();
      if (settings.width > widest) {
        settings.height =
            std::max(1, (settings.height * widest + settings.width / 2) / settings.width);
        settings.width = widest;
      }
      settings.zoom *= knobs.eye;
      whole = session.view(lesson.stage.camera, settings.width, settings.height);
    }
  };
  std::unique_ptr<State> state_ = std::make_unique<State>();
};

}  // namespace texmap::live
