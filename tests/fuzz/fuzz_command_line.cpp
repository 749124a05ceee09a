// Any bytes as the words of a command line: a program accepts or refuses them, nothing else.
//
// The first byte chooses the chapter: '0' to '9' are 02, 03, 05, 06 and 07 to 12. The lines that
// follow are the words.
#include <cmath>
#include <sstream>

#include "02_checkerboard_uv/lesson.hpp"
#include "03_image_texture/lesson.hpp"
#include "05_y_rotation/lesson.hpp"
#include "06_phong_texture_blend/lesson.hpp"
#include "07_earth_by_sampling/lesson.hpp"
#include "08_triangle_uv/lesson.hpp"
#include "09_texture_filtering/lesson.hpp"
#include "10_projections/lesson.hpp"
#include "11_bump_and_normal_maps/lesson.hpp"
#include "12_environment_map/lesson.hpp"
#include "engine/app/budget_options.hpp"
#include "engine/app/command_line.hpp"
#include "engine/app/run_chapter.hpp"
#include "fuzz/target.hpp"

namespace texmap {

// Nothing is drawn here: the compiler need not know how.
template <>
Image Session::draw(const chapter_09::Lesson&, int, int) {
  return {};
}
template <>
Image Session::draw(const chapter_10::Lesson&, int, int) {
  return {};
}
template <>
Image Session::draw(const chapter_11::Lesson&, int, int) {
  return {};
}

}  // namespace texmap

namespace texmap::test {
namespace {

using Words = std::vector<std::string>;

Words words_of(const std::string& text) {
  Words words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) words.push_back(line);
  return words;
}

/// The options that the user typed, read apart from the parser: only right for words that were
/// accepted.
Words options_of(const Words& words) {
  Words options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    options.push_back(words[i].substr(0, equals));
    if (equals != std::string::npos || options.back() == "--quiet" ||
        options.back() == "--caustics")
      continue;
    claim(++i < words.size(), "an option that was accepted has its value");
  }
  return options;
}

void check_budget(const Budget& budget) {
  if (budget.unit == Budget::Unit::exact) return;
  claim(budget.limit > 0 && budget.limit <= 255, "a budget is above 0 and at most 255");
  const Budget again = parse_budget(to_text(budget));
  claim(again.unit == budget.unit && again.limit == budget.limit, "a budget's text is the budget");
  const Polynomial choice = choose_uv_kernel(budget, 8192, 4096);
  const bool texels = budget.unit == Budget::Unit::texels;
  claim((texels ? choice.worst_texels : choice.worst_levels) <= budget.limit,
        "a kernel keeps the budget");
}

void check_rotation(const RotationY& turn) {
  claim(std::abs(std::hypot(turn.sine, turn.cosine) - 1) < 1e-15, "a turn is a rotation");
}

void check(const Settings& settings, int most_samples) {
  claim(!settings.out.empty() && !settings.budget.empty(), "a text is not empty");
  claim(settings.width >= 1 && settings.height >= 1, "a picture has pixels");
  claim(settings.width * 1LL * settings.height <= 1LL << 26, "it has at most 2^26 of them");
  claim(settings.samples >= 1 && settings.samples <= most_samples, "--samples is in its range");
  claim(settings.threads >= 0 && settings.threads <= 1024, "--threads is in its range");
}

/// A chapter's options, as run_chapter reads them; no texture is loaded and nothing is drawn.
template <class Lesson>
void try_chapter(const Words& words) {
  Lesson lesson;
  CommandLine line("chapter", Lesson::about.idea);
  lesson.options(line);
  Session session("chapter", line, Lesson::about, offers_for(lesson));
  if (!line.parse(words)) return;

  const std::string help = line.help();
  for (const std::string& name : options_of(words)) {
    claim(line.was_given(name), "an option that was typed was given");
    claim(help.find("  " + name) != std::string::npos, "the help names each option");
  }
  session.settings.out = "/dev/null";  // files are not the matter here
  session.check();
  check(session.settings, line.wishes.samples_limit);
  if (line.wishes.turntable != nullptr) check_rotation(line.wishes.turntable->rotation());
  if constexpr (requires { lesson.choice.degrees; })
    check_rotation(rotation_y(lesson.choice.degrees));
  if constexpr (requires { lesson.sky.degrees; }) check_rotation(rotation_y(lesson.sky.degrees));
  check_budget(read_budget(session.settings.budget));
}

constexpr auto programs =
    std::array{try_chapter<chapter_02::Lesson>, try_chapter<chapter_03::Lesson>,
               try_chapter<chapter_05::Lesson>, try_chapter<chapter_06::Lesson>,
               try_chapter<chapter_07::Lesson>, try_chapter<chapter_08::Lesson>,
               try_chapter<chapter_09::Lesson>, try_chapter<chapter_10::Lesson>,
               try_chapter<chapter_11::Lesson>, try_chapter<chapter_12::Lesson>};

}  // namespace
}  // namespace texmap::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(data + 1, data + size);
  using texmap::test::programs;
  try {
    programs[data[0] % 16U % programs.size()](texmap::test::words_of(text));
  } catch (const texmap::UsageError& error) {
    texmap::test::claim(*error.what() != '\0', "a refusal says why");
  }
  return 0;
}
