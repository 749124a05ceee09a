// A chapter's lesson that draws again whenever its options change: the words of the chapter's
// command line go in, rows of pixels come out.
#pragma once
#include <algorithm>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/files/json.hpp"
#include "engine/run/draw_lesson.hpp"
#include "gathered.hpp"
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
  /// What there is to say about the files in it, a line each.
  [[nodiscard]] virtual std::string notes() const = 0;
  /// Columns and rows of the picture.
  [[nodiscard]] virtual Size size() const = 0;
  /// How often the picture is drawn, better each time.
  [[nodiscard]] virtual int passes() const = 0;
  /// The size of a second picture beside the first; 0 x 0: there is none.
  [[nodiscard]] virtual Size size_beside() const = 0;
  /// Rows of the picture; after the last pass the same pixels as if the whole were drawn at once.
  ///
  /// @param pass  0 and on; passes(): of the picture beside it
  [[nodiscard]] virtual Image rows(int first, int count, int pass) = 0;
  /// The pixel that shows a place on the picture beside, 0 to 1 from the left and from the top, as
  /// JSON; null if there is none.
  [[nodiscard]] virtual std::string find(double x, double y) const = 0;
  /// What the ray through the center of a pixel meets, with every number on the way, as JSON.
  [[nodiscard]] virtual std::string look(int column, int row) const = 0;
  /// A part of an object's texture, laid flat.
  [[nodiscard]] virtual Image flat(int object, const FlatPart& part) const = 0;
};

/// The option --mistake of a chapter's page: a row by its name; without the option none.
template <class Row, std::size_t n>
void declare_mistakes(CommandLine& line, const Row*& chosen, const Row (&all)[n]) {
  std::vector<std::pair<std::string_view, const Row*>> names;
  for (const Row& row : all) names.emplace_back(row.name, &row);
  line.choice("--mistake", chosen, names, "draws with a mistake that students make");
}

/// The choices of chapters 01 to 06: knobs.hpp.
template <class Lesson>
struct Knobs;

/// The light of a lesson that gathers it; nothing of another.
template <class Lesson>
using GatheredOf = typename std::conditional_t<std::derived_from<Lesson, GathersLight>,
                                               std::type_identity<std::optional<Gathered<Lesson>>>,
                                               std::type_identity<std::nullptr_t>>::type;

/// A lesson for a page.
///
/// @tparam Choices  may have `declare` and `apply` as Knobs does, `look` for a pixel's facts,
///                  `draw` for what the lesson does not draw, `size_beside`, `draw_beside` and
///                  `find` for another picture, `take_over` for what need not be loaded again
template <class Lesson, class Choices = Knobs<Lesson>>
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
    if (state_->words == words) return state_->fit(widest);  // its textures stay
    auto next = std::make_unique<State>();
    if (!next->line.parse(words)) throw UsageError("a page draws pictures, and prints no help");
    next->get_ready(*state_);
    next->fit(widest);
    next->words = words;
    state_ = std::move(next);
  }

  [[nodiscard]] std::string notes() const override { return state_->notes; }
  [[nodiscard]] Size size() const override { return {state_->whole.width, state_->whole.height}; }

  [[nodiscard]] int passes() const override {
    if constexpr (std::derived_from<Lesson, GathersLight>) {
      if (state_->gathered) return state_->gathered->passes();
    }
    return 1;
  }

  [[nodiscard]] Size size_beside() const override {
    if constexpr (has_beside) return state_->knobs.size_beside(state_->lesson, size());
    return {0, 0};
  }

  [[nodiscard]] Image rows(int first, int count, int pass) override {
    View<> strip = state_->whole;
    strip.height = count;
    strip.center_row -= first;  // a half or a whole number: exact
    Lesson& lesson = state_->lesson;
    const Settings& settings = state_->chosen.settings;
    const RenderSettings how{.samples = settings.samples, .threads = 1};
    if constexpr (has_beside) {
      if (pass == passes()) return state_->knobs.draw_beside(lesson, strip, first, how);
    }
    if constexpr (requires { &Choices::draw; }) {
      if (std::optional<Image> drawn = state_->knobs.draw(lesson, strip, how))
        return *std::move(drawn);
    }
    if constexpr (HasSurfaces<Lesson>) {
      if (settings.show != Shown::color) {
        return render<double>(SurfaceColors<Lesson>{lesson, settings.show}, strip,
                              {.samples = 1, .threads = 1});
      }
    }
    if constexpr (std::derived_from<Lesson, GathersLight>) {
      return state_->gathered->rows(first, count, pass);
    } else {
      if (settings.number == NumberKind::float_) return render<float>(lesson, strip, how);
      return render<double>(lesson, strip, how);
    }
  }

  [[nodiscard]] std::string look(int column, int row) const override {
    const Lesson& lesson = state_->lesson;
    const View<>& view = state_->whole;
    if constexpr (requires { state_->knobs.look(*state_, column, row); }) {
      return Json::object(state_->knobs.look(*state_, column, row)).text;
    } else {
      Members members = what_a_ray_meets(lesson, ray_through(view, double(column), double(row)));
      if constexpr (std::is_same_v<Choices, Knobs<Lesson>>)
        add_map(lesson, view, column, row, members);
      if constexpr (may_err) {
        if (state_->knobs.errors || state_->chosen.settings.number == NumberKind::float_) {
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
  }

  [[nodiscard]] std::string find(double x, double y) const override {
    if constexpr (requires { state_->knobs.find(*state_, x, y); }) {
      if (const auto at = state_->knobs.find(*state_, x, y))
        return Json::list({at->column, at->row}).text;
    }
    return "null";
  }

  [[nodiscard]] Image flat(int object, const FlatPart& part) const override {
    if constexpr (std::is_same_v<Choices, Knobs<Lesson>>) {
      return with_paint(state_->lesson.objects[static_cast<std::size_t>(object)].paint,
                        [&](const auto& paint) { return flat_texture(paint, part); });
    } else {
      return {};  // these chapters' pages show no map of their textures
    }
  }

 private:
  static constexpr bool may_err = requires { requires Choices::may_err; };
  static constexpr bool has_beside = requires { &Choices::draw_beside; };

  /// A page shows one picture: the sheets that some lessons save stay out of the module.
  struct OnePicture : Lesson {
    void draw_all(Session&) override {}
  };
  struct State {
    OnePicture lesson;
    CommandLine line{"live", Lesson::about.idea};
    Chosen chosen{"live", offer_of(static_cast<Lesson&>(lesson), line), Lesson::about};
    Session session{chosen};
    Choices knobs;
    View<> whole;
    std::optional<std::vector<std::string>> words{};  ///< that it is ready for
    GatheredOf<Lesson> gathered{};
    std::string notes;

    State() {
      line.note = [this](const std::string& text) { notes += text; };
      if constexpr (requires { knobs.declare(line); }) knobs.declare(line);
    }

    void get_ready(State& before) {
      chosen.settings.quiet = true;
      chosen.settings.threads = 1;
      bool is_ready = false;
      if constexpr (requires { knobs.take_over(lesson, before.lesson); })
        is_ready = before.words && knobs.take_over(lesson, before.lesson);
      if (is_ready) notes = before.notes;
      if (!is_ready) lesson.build(chosen);
      if constexpr (requires { knobs.apply(lesson); }) knobs.apply(lesson);
      choose_spheres(chosen, lesson);
      if constexpr (requires { knobs.eye; }) chosen.settings.zoom *= knobs.eye;
    }
    void fit(int widest) {
      const Settings& settings = chosen.settings;
      Size size{settings.width, settings.height};
      if (size.width > widest) {
        size = {widest, std::max(1, (size.height * widest + size.width / 2) / size.width)};
      }
      whole = session.view(lesson.stage.camera, size.width, size.height);
      if constexpr (std::derived_from<Lesson, GathersLight>) {
        if (settings.show == Shown::color) gathered.emplace(lesson, whole, settings);
      }
    }
  };
  std::unique_ptr<State> state_ = std::make_unique<State>();
};

/// The chapter's lesson, begun anew: each module has its own chapters.
[[nodiscard]] std::unique_ptr<LiveLesson> make_lesson(int chapter);

}  // namespace texmap::live
