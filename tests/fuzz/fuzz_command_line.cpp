// Any bytes as the words of a command line: a program accepts or refuses them, nothing else.
//
// The first byte chooses the program: 0 to 9 the chapters 02, 03, 05, 06 and 07 to 12, ':' and what
// comes after it a program that takes two files. The lines that follow are the words.
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
#include "texture/projection_facts.hpp"

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

Words words_of(std::string_view text) {
  Words words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

/// What the user typed last for each option, read apart from the parser: only right for words that
/// were accepted.
class Typed {
 public:
  explicit Typed(const Words& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::size_t equals = words[i].find('=');
      const std::string name = words[i].substr(0, equals);
      if (equals != std::string::npos) {
        values_[name] = words[i].substr(equals + 1);
      } else if (name == "--quiet" || name == "--caustics") {
        values_[name] = "";
      } else {
        claim(i + 1 < words.size(), "an option that was accepted has its value");
        values_[name] = words[++i];
      }
    }
  }

  void check_names(const CommandLine& line) const {
    const std::string help = line.help();
    for (const auto& [name, value] : values_) {
      claim(line.was_given(name), "an option that was typed was given");
      claim(help.find("  " + name) != std::string::npos, "the help names each option");
    }
  }

  /// Checks that a number is in its range, and is the one that was typed.
  void number(const char* name, double value, double low, double high) const {
    claim(value >= low && value <= high, name);
    const auto typed = values_.find(name);
    if (typed == values_.end()) return;
    char* end = nullptr;
    const double read = std::strtod(typed->second.c_str(), &end);
    claim(end == typed->second.data() + typed->second.size(), "the whole text is a number");
    // A number that is too small may be read as 0.
    claim(value == read || std::abs(read) < DBL_MIN, name);
  }

  /// Checks that a choice is the one that was typed.
  template <class Value>
  void choice(const char* name, Value value,
              const std::map<std::string, Value, std::less<>>& words) const {
    const auto typed = values_.find(name);
    if (typed == values_.end()) return;
    const auto word = words.find(typed->second);
    claim(word != words.end() && word->second == value, name);
  }

  /// Checks that a flag is on if it was typed.
  void flag(const char* name, bool value) const { claim(value == values_.contains(name), name); }

  /// Checks that a file's name is the one that was typed: empty if none was.
  void file(const char* name, const std::string& value) const {
    const auto typed = values_.find(name);
    claim(typed == values_.end() ? value.empty() : typed->second == value, name);
  }

  /// Checks that a text is the one that was typed.
  void text(const char* name, const std::string& value) const {
    claim(!value.empty(), name);
    const auto typed = values_.find(name);
    claim(typed == values_.end() || typed->second == value, name);
  }

 private:
  std::map<std::string, std::string, std::less<>> values_;
};

void check_budget(const Budget& budget) {
  if (budget.unit == Budget::Unit::exact) return;
  claim(budget.limit > 0 && budget.limit <= 255, "a budget is above 0 and at most 255");
  const Budget again = parse_budget(to_text(budget));
  claim(again.unit == budget.unit && again.limit == budget.limit, "a budget's text is the budget");
  const UvChoice choice = choose_uv_kernel(budget, 8192, 4096);
  const bool texels = budget.unit == Budget::Unit::texels;
  claim((texels ? choice.worst_texels : choice.worst_levels) <= budget.limit,
        "a kernel keeps the budget");
}

void check_rotation(const RotationY& turn) {
  claim(std::abs(std::hypot(turn.sine, turn.cosine) - 1) < 1e-15, "a turn is a rotation");
}

void check(const Typed& typed, const LayoutOptions& layout) {
  typed.choice<Convention>("--convention", layout.convention,
                           {{"daily", Convention::daily},
                            {"rtiow", Convention::rtiow},
                            {"lecture", Convention::lecture}});
  typed.choice<TexelRounding>(
      "--rounding", layout.rounding,
      {{"floor", TexelRounding::floor}, {"lecture", TexelRounding::lecture}});
}

void check(const Typed& typed, const Turntable& turn) {
  typed.number("--degrees", turn.degrees, -1e300, 1e300);
  typed.number("--turntable", turn.frames, 0, 9999);
  check_rotation(turn.rotation());
}

void check(const Typed& typed, const PhongOptions& phong) {
  typed.number("--blend", phong.blend, 0, 1);
  typed.number("--shininess", phong.shininess, 0, 1e30);
  typed.choice<PhongScene>("--scene", phong.scene,
                           {{"stage", PhongScene::stage}, {"lecture", PhongScene::lecture}});
}

void check(const Typed& typed, const SamplingOptions& sampling) {
  typed.choice<SamplerKind>("--sampler", sampling.sampler,
                            {{"random", SamplerKind::random},
                             {"stratified", SamplerKind::stratified},
                             {"multi-jitter", SamplerKind::multi_jitter},
                             {"sobol", SamplerKind::sobol}});
  typed.number("--seed", sampling.seed, 0, 1000000000);
  typed.number("--bounces", sampling.bounces, 1, 1000);
  typed.number("--time-limit", sampling.time_limit, 0, 1e6);
  typed.number("--target-error", sampling.target_error, 0, 255);
  typed.number("--defocus", sampling.lens.defocus_degrees, 0, 90);
  typed.number("--focus", sampling.lens.focus_distance, 0.001, 1e6);
  typed.number("--shift", sampling.lens.shift, -100, 100);
}

void check(const Typed& typed, const MeshOptions& mesh) {
  typed.number("--degrees", mesh.degrees, -1e300, 1e300);
  check_rotation(rotation_y(mesh.degrees));
  typed.choice<Wrap>("--wrap", mesh.wrap,
                     {{"mirror", Wrap::mirror}, {"repeat", Wrap::repeat}, {"clamp", Wrap::clamp}});
  typed.choice<WeightsFormula>(
      "--weights", mesh.weights,
      {{"signed", WeightsFormula::signed_areas}, {"heron", WeightsFormula::heron}});
  typed.file("--mesh", mesh.file);
}

void check(const Typed& typed, const FilterOptions& filtering) {
  typed.choice<Filter>("--filter", filtering.filter,
                       {{"nearest", Filter::nearest},
                        {"bilinear", Filter::bilinear},
                        {"trilinear", Filter::trilinear},
                        {"anisotropic", Filter::anisotropic},
                        {"ewa", Filter::ewa},
                        {"stochastic", Filter::stochastic}});
  typed.choice<Wrap>("--wrap", filtering.wrap,
                     {{"repeat", Wrap::repeat},
                      {"mirror", Wrap::mirror},
                      {"clamp", Wrap::clamp},
                      {"border", Wrap::border}});
  typed.number("--taps", filtering.taps, 1, 64);
  typed.text("--floor", filtering.floor_file);
  typed.file("--plot", filtering.plot);
}

void check(const Typed& typed, const ProjectionOptions& layout) {
  std::map<std::string, std::optional<Projection>, std::less<>> words;
  for (const ProjectionFacts& facts : projections) words[facts.word] = facts.projection;
  typed.choice<std::optional<Projection>>("--projection", layout.projection, words);
  typed.choice<std::optional<Projection>>("--from", layout.from, words);
  typed.choice<std::optional<Projection>>("--to", layout.to, words);
}

void check(const Typed& typed, const BumpOptions& bump) {
  typed.choice<BumpPicture>("--show", bump.picture,
                            {{"globe", BumpPicture::globe},
                             {"sheet", BumpPicture::sheet},
                             {"poles", BumpPicture::poles},
                             {"daily", BumpPicture::daily}});
  typed.choice<BumpForm>(
      "--bump", bump.form,
      {{"exact", BumpForm::exact}, {"blinn", BumpForm::blinn}, {"off", BumpForm::flat}});
  typed.choice<SlopeFrom>("--slopes", bump.slopes,
                          {{"duals", SlopeFrom::duals},
                           {"forward", SlopeFrom::forward},
                           {"central", SlopeFrom::central}});
  typed.choice<HeightKind>(
      "--relief-from", bump.height,
      {{"image", HeightKind::image}, {"uv", HeightKind::uv}, {"space", HeightKind::space}});
  typed.number("--step", bump.step, 1e-300, 1);
  typed.number("--relief", bump.relief, -10, 10);
  typed.text("--relief-image", bump.image);
}

void check(const Typed& typed, const SkyOptions& sky) {
  typed.text("--sky", sky.name);
  typed.choice<std::optional<SkyLighting>>("--light", sky.chosen,
                                           {{"auto", std::nullopt},
                                            {"uniform", SkyLighting::uniform},
                                            {"cosine", SkyLighting::cosine},
                                            {"importance", SkyLighting::importance},
                                            {"mis", SkyLighting::mis},
                                            {"coefficients", SkyLighting::coefficients}});
  typed.choice<TexelFilter>(
      "--filter", sky.filter,
      {{"nearest", TexelFilter::nearest}, {"bilinear", TexelFilter::bilinear}});
  typed.number("--exposure", sky.exposure, -30, 30);
  typed.number("--degrees", sky.degrees, -1e300, 1e300);
  typed.flag("--caustics", sky.matte.caustics);
  check_rotation(rotation_y(sky.degrees));
}

void check(const Typed& typed, const Settings& settings, int most_samples) {
  typed.text("--out", settings.out);
  typed.text("--budget", settings.budget);
  typed.number("--width", settings.width, 1, 16384);
  typed.number("--height", settings.height, 1, 16384);
  typed.number("--samples", settings.samples, 1, most_samples);
  typed.number("--threads", settings.threads, 0, 1024);
  typed.choice<NumberKind>("--number", settings.number,
                           {{"float", NumberKind::float_},
                            {"double", NumberKind::double_},
                            {"extended", NumberKind::extended},
                            {"float-pack", NumberKind::float_pack},
                            {"double-pack", NumberKind::double_pack},
                            {"interval", NumberKind::interval}});
}

/// A chapter's options, as run_chapter reads them; no texture is loaded and nothing is drawn.
template <class Lesson>
void try_chapter(const Words& words) {
  Lesson lesson;
  CommandLine line("chapter", Lesson::about.idea);
  lesson.options(line);
  Session session("chapter", line, Lesson::about, offers_for(lesson));
  if (!line.parse(words)) return;

  // What was accepted.
  const Typed typed(words);
  typed.check_names(line);
  check(typed, session.settings, GathersLight<Lesson> ? most_samples : 65536);
  if constexpr (requires { lesson.texture; }) typed.text("--texture", lesson.texture.name);
  if constexpr (requires { lesson.layout; }) check(typed, lesson.layout);
  if constexpr (requires { lesson.turn; }) check(typed, lesson.turn);
  if constexpr (requires { lesson.phong; }) check(typed, lesson.phong);
  if constexpr (requires { lesson.sampling; }) check(typed, lesson.sampling);
  if constexpr (requires { lesson.choice; }) check(typed, lesson.choice);
  if constexpr (requires { lesson.filtering; }) check(typed, lesson.filtering);
  if constexpr (requires { lesson.bump; }) check(typed, lesson.bump);
  if constexpr (requires { lesson.sky; }) check(typed, lesson.sky);

  // What is refused later; files are not the matter here.
  session.settings.out = "/dev/null";
  session.check();
  claim(static_cast<long long>(session.settings.width) * session.settings.height <= 1LL << 26,
        "a picture has at most 2^26 pixels");
  check_budget(read_budget(session.settings.budget));
}

void try_two_files(const Words& words) {
  std::string first;
  std::string second;
  int levels = 0;
  double share = 0;
  std::vector<std::string> masks;
  bool quiet = false;
  CommandLine line("two_files", "compares two files");
  line.positional("A", first, "a file");
  line.positional("B", second, "another one");
  line.whole("--levels", levels, 0, 255, "of 255");
  line.decimal("--share", share, -1, 1, "of all");
  line.texts("--mask", "FILE", masks, "may be repeated");
  line.flag("--quiet", quiet, "print nothing");
  if (!line.parse(words)) return;
  claim(!first.empty() && !second.empty(), "two files are named");
  claim(levels >= 0 && levels <= 255, "--levels");
  claim(share >= -1 && share <= 1, "--share");
  claim(line.was_given("--mask") == !masks.empty(), "--mask");
  claim(line.was_given("--quiet") == quiet, "--quiet");
  for (const std::string& mask : masks) claim(!mask.empty(), "--mask");
}

constexpr auto programs = std::array{try_chapter<chapter_02::Lesson>,
                                     try_chapter<chapter_03::Lesson>,
                                     try_chapter<chapter_05::Lesson>,
                                     try_chapter<chapter_06::Lesson>,
                                     try_chapter<chapter_07::Lesson>,
                                     try_chapter<chapter_08::Lesson>,
                                     try_chapter<chapter_09::Lesson>,
                                     try_chapter<chapter_10::Lesson>,
                                     try_chapter<chapter_11::Lesson>,
                                     try_chapter<chapter_12::Lesson>,
                                     try_two_files};

}  // namespace
}  // namespace texmap::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(data + 1, data + size);
  // The digits 0 to 9 are the programs 0 to 9; those from ':' on are the last one.
  using texmap::test::programs;
  const std::size_t program = std::min<std::size_t>(data[0] % 16, programs.size() - 1);
  try {
    programs[program](texmap::test::words_of(text));
  } catch (const texmap::UsageError& error) {
    texmap::test::claim(*error.what() != '\0', "a refusal says why");
  }
  return 0;
}
