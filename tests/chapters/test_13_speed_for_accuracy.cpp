// Chapter 13: the figures to rely on hold on inputs that nobody has measured, and a smaller figure
// would not. No clock here.
#include <doctest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "13_speed_for_accuracy/lesson.hpp"
#include "13_speed_for_accuracy/show.hpp"
#include "engine/files/text.hpp"
#include "engine/run/draw_lesson.hpp"
#include "support/shown_values.hpp"

using namespace texmap;
using namespace texmap::chapter_13;

namespace {

const Globe& earth() {
  static const Globe globe(Lesson{}.texture.load());
  return globe;
}

/// A globe of random bytes: every edge between two texels is as sharp as any.
const Globe& noise_globe() {
  static const Globe globe = [] {
    Image image(512, 256);
    std::uint32_t at = 7;
    for (Rgb8& texel : image.pixels) {
      const auto byte = [&at] { return static_cast<std::uint8_t>(hash_bits(at++) >> 24); };
      texel = {byte(), byte(), byte()};
    }
    return Globe(image);
  }();
  return globe;
}

/// Where nobody has stood before: east and up, in degrees; over the poles, before the seam,
/// anywhere.
constexpr std::array<std::pair<double, double>, 6> fresh_angles = {
    {{-90, 0}, {13.7, 88.9}, {201.3, -89}, {77.7, 41.3}, {-151, -23.2}, {0, 7.7}}};

/// The rows of a part with their errors, of packs that every machine has.
std::vector<Row> with_errors(Part part, const Globe& globe, const View<>& view) {
  std::vector<Row> rows = rows_of(part, Instructions::baseline);
  find_errors(rows, globe, view, 0, [](int, int) {});
  return rows;
}

bool holds(const Row& seen, const Row& stated) {
  return seen.worst <= stated.bound && (seen.part != Part::places || seen.mean <= stated.bound) &&
         seen.changed <= stated.may_change && seen.levels <= stated.levels_bound;
}

/// Measurements with made-up times.
Measurements made_up() {
  Measurements all{{}, 64, 48};
  all.machine.instructions = {"baseline"};
  const View<> view = earth().view(all.width, all.height);
  all.of(Part::places) = with_errors(Part::places, earth(), view);
  all.of(Part::curves) = with_errors(Part::curves, earth(), view);
  all.of(Part::samplers) = rows_of(Part::samplers, Instructions::baseline);
  for (const Part part : {Part::places, Part::curves}) {
    for (Row& row : all.of(part)) {
      const Variant& variant = row.variant;
      row.took.processor = 100 - (is_pack(variant.number) ? 50 : 0) -
                           (is_float(variant.number) ? 20 : 0) + variant.degree * 0.1 +
                           (variant.degree == 0 ? 10 : 0) - (variant.curve == Curve::four ? 20 : 0);
      row.time = row.took.processor / all.of(part)[0].took.processor;
    }
  }
  for (Row& row : all.of(Part::samplers)) {
    row.mean = 10 / std::pow(row.samples, row.sampler == SamplerKind::random ? 0.5 : 0.75);
    row.bound = 1.5 * row.mean;
    row.took = {row.samples * (row.sampler == SamplerKind::sobol ? 1.1 : 1.2)};
  }
  return all;
}

/// The chapter's page.
[[maybe_unused]] std::string page() {
  std::ifstream file(TEXMAP_TESTS_DIR "/../chapters/13_speed_for_accuracy/README.md");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE(
    "from any angle, on any texture, no place is farther off than stated, and no more pixels "
    "change, by no more levels") {
  const auto changed_in = [](const Globe& globe, double east, double up, int width, int height) {
    long changed = 0;
    for (const Row& seen : with_errors(Part::places, globe, globe.view(width, height, east, up))) {
      CAPTURE(globe.nearest.image.width);
      CAPTURE(east);
      CAPTURE(names_text(seen));
      CAPTURE(seen.worst);
      CAPTURE(seen.changed);
      CAPTURE(seen.may_change);
      CHECK(holds(seen, seen));
      if (globe.nearest.image.pixels.size() == 1) CHECK(seen.may_change == 0);
      changed += seen.changed;
    }
    return changed;
  };
  for (const auto& [east, up] : fresh_angles) changed_in(earth(), east, up, 211, 157);
  CHECK(changed_in(noise_globe(), 33.3, 3, 320, 240) +
            changed_in(noise_globe(), -60, 80, 320, 240) >
        1000);  // there was something to bound
  for (const auto& [width, height] :
       {std::pair{1, 1}, std::pair{2, 1}, std::pair{1, 3}, std::pair{3, 2}}) {
    Image image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] = {static_cast<std::uint8_t>(40 * i), 200, 9};
    changed_in(Globe(image), 33.3, 3, 64, 48);
  }
}

TEST_CASE("by shorter curves no level is farther off than stated, and no more pixels change") {
  for (const Globe* globe : {&earth(), &noise_globe()}) {
    for (const auto& [east, up] : fresh_angles) {
      for (const Row& row : with_errors(Part::curves, *globe, globe->view(160, 120, east, up))) {
        CAPTURE(names_text(row));
        CAPTURE(row.worst);
        CAPTURE(row.changed);
        CHECK(holds(row, row));
        CHECK(row.mean <= row.worst);
        if (row.variant.curve == Curve::exact) CHECK(row.may_change == 0);
      }
    }
  }
}

TEST_CASE(
    "the noise of other seeds, seen from other angles, is within its bound; half the bound, or "
    "fewer samples, are not") {
  const Variant variant{.number = NumberKind::double_pack};
  std::vector<Row> stated = rows_of(Part::samplers, Instructions::baseline);
  std::erase_if(stated, [](const Row& row) { return row.samples > 64; });  // 256 takes long
  for (Row& row : stated) row.variant = variant;
  find_errors(stated, earth(), {}, 0, [](int, int) {});
  std::map<SamplerKind, double> bound_of_64;
  for (const Row& row : stated) bound_of_64[row.sampler] = row.bound;  // the last of each
  std::uint32_t seed = 555;
  for (const auto& [east, up] : fresh_angles) {
    const View<> view = earth().view(noise_width, noise_height, east, up);
    const auto reference =
        levels_of(sampled(earth(), view, variant, Sampler(SamplerKind::sobol, 2048, seed++), 0));
    for (const Row& row : stated) {
      const auto levels =
          levels_of(sampled(earth(), view, variant, Sampler(row.sampler, row.samples, seed++), 0));
      CAPTURE(name_of(row.sampler));
      CAPTURE(row.samples);
      CHECK(rms_difference(levels, reference) <= row.bound);
      if (up > 60 || up < -60) continue;  // the poles are plain, and their noise is small
      CHECK(rms_difference(levels, reference) > row.bound / 3);
      if (row.samples == 4) CHECK(rms_difference(levels, reference) > bound_of_64[row.sampler]);
    }
  }
}

TEST_CASE("a bound of noise is the mean and six standard deviations") {
  CHECK(noise_bound({1, 1, 1, 1}) == 1);
  CHECK(noise_bound({1, 3}) == doctest::Approx(2 + 6 * std::sqrt(2.0)));
}

TEST_CASE("the front is what nothing else beats, from the fastest to the most exact") {
  std::vector<Row> rows;
  for (const auto& [time, error] :
       {std::pair{3, 1}, {1, 5}, {2, 5}, {2, 3}, {4, 2}, {2, 4}, {1, 6}, {9, 1}})
    rows.push_back({.part = Part::places, .bound = 1.0 * error, .took = {1.0 * time}});
  Rows all;
  for (const Row& row : rows) all.push_back(&row);
  CHECK(pareto_front(all) == Rows{&rows[1], &rows[3], &rows[0]});
  CHECK(pareto_front({}).empty());
}

TEST_CASE(
    "the recommendation is the fastest that keeps to the budget by its bound, and its command "
    "takes that very kernel") {
  const Measurements all = made_up();
  for (const char* text : {"exact", "texels=0.01", "texels=0.1", "texels=1e-8", "texels=1e-10",
                           "levels=1", "levels=9"}) {
    const Budget budget = parse_budget(text);
    for (const Filter filter : {Filter::nearest, Filter::bilinear}) {
      const Row* best = fastest(all, filter, budget);
      CAPTURE(text);
      REQUIRE(best != nullptr);
      CHECK(keeps_to(budget, *best));
      for (const Row& row : all.of(Part::places)) {
        if (row.variant.filter != filter || !keeps_to(budget, row)) continue;
        CHECK(best->took.processor <= same_time * row.took.processor);
        if (row.took.processor <= best->took.processor) CHECK(row.bound >= best->bound);
      }
    }
  }
  CHECK(fastest(all, Filter::nearest, parse_budget("texels=1e-16")) == nullptr);
  CHECK(fastest(all, Filter::nearest, {})->variant.number == NumberKind::double_pack);
}

TEST_CASE("a recommendation says what to take, how far off it is, and its command") {
  // Where the machine has wider packs, the command has to name the instructions.
  const bool has_wider = usable_instructions(Instructions::avx512).size() > 1;
  const char* packs = has_wider ? "--number float-pack --instructions baseline --budget texels="
                                : "--number float-pack --budget texels=";
  struct Case {
    const char* budget;
    const char* words;
    bool said = true;
  };
  const Measurements all = made_up();
  for (const auto& [budget, words, said] :
       {Case{"exact", "./course run 07 --scene book --number double-pack"},
        {"texels=1e-16", "nothing that was tried"},
        {"texels=0.01", packs},
        {"texels=0.01", "share alone; rounding adds the rest of the bound"},
        {"exact", "share alone", false},  // the command's budget is the one that was typed
        {"levels=1", "double-pack of baseline, 4 terms: "},
        {"levels=1", "at most 0.49 levels off"},
        {"levels=1", " --budget levels=1\n"},
        {"levels=1", "  samples   sobol, 64 a pixel: noise of at most 0.66 levels"},
        {"levels=1", " ./course run 07 --scene book --sampler sobol --samples 64\n"},
        {"levels=0.01", "  samples   nothing that was tried keeps to it\n"},
        {"texels=0.01", "  light", false},
        {"texels=0.01", "  samples", false}}) {
    const std::string lines = recommendation(all, parse_budget(budget), earth().nearest.image);
    CHECK((lines.find(words) != std::string::npos) == said);
  }
}

TEST_CASE(
    "light is recommended by its bound in whole levels, and from numbers alone that find every "
    "texel") {
  Measurements all = made_up();
  const Row* best = fastest_light(all, parse_budget("levels=1"));
  REQUIRE(best != nullptr);
  CHECK(best->variant.curve == Curve::four);
  CHECK(best->variant.number == NumberKind::double_pack);  // float's places may be off
  CHECK(fastest_light(all, parse_budget("levels=0.9"))->variant.curve == Curve::exact);

  // What is as fast and more exact is taken.
  for (Row& row : all.of(Part::curves)) row.took.processor = 100;
  CHECK(fastest_light(all, parse_budget("levels=1"))->variant.curve == Curve::exact);
}

TEST_CASE(
    "where a pixel looks at the very edge of a texel only plain double is exact, whatever was "
    "measured") {
  // The middle column looks along x = 0, where u is 3/4.
  for (const Row& row : with_errors(Part::places, earth(), earth().view(33, 25, 0, 0))) {
    if (row.variant.filter != Filter::nearest) continue;
    CHECK(row.may_change >= 20);
    CHECK(keeps_to({}, row) ==
          (row.variant.number == NumberKind::double_ && row.variant.degree == 0));
  }
}

TEST_CASE("the budget of a command takes the kernel it is for, on textures of all sizes") {
  for (const int width : {2, 64, 1000, 2048, 8192, 16384}) {
    const Image texture(width, width / 2);
    for (const int degree : {0, 5, 9, 17, 23, 35}) {
      const std::string text = budget_for(degree, texture);
      CAPTURE(text);
      CHECK(text.size() <= 20);
      CHECK(choose_uv_kernel(parse_budget(text), texture.width, texture.height).terms == degree);
    }
  }
}

TEST_CASE("the plots are whole, name everything in them, and have no number that is none") {
  const Measurements all = made_up();
  for (const Plot& plot : plots_of(all)) {
    const std::string svg = svg_of(plot);
    CHECK(svg.starts_with("<svg "));
    CHECK(svg.ends_with("</svg>\n"));
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
    CHECK(svg.find(">" + plot.title + "<") != std::string::npos);
    for (const PlotSeries& series : plot.series)
      CHECK(svg.find(">" + series.name + "<") != std::string::npos);
    for (const PlotPoint& point : plot.front) {
      if (!point.label.empty()) CHECK(svg.find(">" + point.label + "<") != std::string::npos);
    }
  }
}

TEST_CASE("the table fits a page of 110 columns, and the JSON has a row for everything tried") {
  const Measurements all = made_up();
  std::string table = table_of(all);
  for (const char* budget : {"exact", "texels=0.01", "levels=1"}) {
    table += recommendation(all, parse_budget(budget), earth().nearest.image);
  }
  std::stringstream lines(table);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 110);
  const std::string json = json_of(all, earth().nearest.image);
  const auto count = [&json](const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = json.find(word); at != std::string::npos; at = json.find(word, at + 1))
      ++found;
    return found;
  };
  std::size_t tried = 0;
  for (const Part part : all_parts) tried += all.of(part).size();
  CHECK(count("\"sampler\"") == all.of(Part::samplers).size());
  CHECK(count("\"spread\"") == tried);
  CHECK(count("{") == count("}"));
  CHECK(count("[") == 4);
  // The book shows the commands: each is one that the run recommends, for a budget of its own.
  CHECK(count("--number double --budget texels=") ==
        all.some_of(Part::places,
                    [](const Row& row) {
                      return row.variant.number == NumberKind::double_ && row.variant.degree > 0 &&
                             row.variant.filter == Filter::nearest;
                    })
            .size());
}

TEST_CASE("the errors on the chapter's page are those of its program") {
  const View<> view = view_of_sheet(earth(), 1312, 1090);
  std::vector<Row> rows = with_errors(Part::places, earth(), view);
  const std::vector<Row> curves = with_errors(Part::curves, earth(), view);
  rows.insert(rows.end(), curves.begin(), curves.end());
  int found = 0;
  std::stringstream lines(page());
  for (std::string line; std::getline(lines, line);) {
    for (const Row& row : rows) {
      if (!line.starts_with(names_text(row) + " ")) continue;
      CAPTURE(line);
      ++found;
      if (judge_is_pair && row.variant.number == NumberKind::extended) {
        // The page's judge is long double, which finds no error in itself; pairs do.
        CHECK(row.worst > 0);
        CHECK(row.worst < row.bound);
      } else {
        CHECK(line == names_text(row) + errors_text(row));
      }
    }
  }
  CHECK(found == 13);
}

TEST_CASE("when the time limit is reached, rounds beyond the fifth are skipped, and that is told") {
  std::vector<Row> rows = rows_of(Part::curves, Instructions::baseline);
  // The first row takes one more turn among each ten.
  const double turns = static_cast<double>(rows.size() + rows.size() / 10);
  for (const auto& [limit, skipped] : {std::pair{0.0, 3}, std::pair{1e9, 0}}) {
    std::pair<int, int> last;
    Timing timing{8, limit, [&last](int done, int total) { last = {done, total}; }};
    time_rows(rows, earth(), earth().view(8, 6), timing);
    CHECK(timing.skipped == skipped);
    CHECK(timing.rays == 48.0 * turns * (9 - skipped));
    CHECK(last.first == last.second);
    for (const Row& row : rows) CHECK(row.time < 1e9);
  }
  Measurements all = made_up();
  CHECK(busy_text(all).empty());
  all.skipped = 3;
  CHECK(busy_text(all).find("3 rounds were left out") != std::string::npos);
  CHECK(table_of(all).find(busy_text(all)) != std::string::npos);
}

TEST_CASE("plain double must take as long among packs as it took before any, within a quarter") {
  CHECK(disagreement({4, 4}, {5, 5}).empty());
  CHECK(disagreement({5, 5}, {4, 4}).empty());
  CHECK_FALSE(disagreement({4, 4}, {5.01, 9}).empty());
  CHECK_FALSE(disagreement({5.01, 9}, {4, 4}).empty());
  CHECK(disagreement({0.1, 0.1}, {0.9, 0.9}).empty());  // caches, not the processor
  CHECK(disagreement({4, 4}, {17.9, 18})
            .starts_with("plain double took 4.0 ms for a picture before packs were timed, and "
                         "17.9 ms among them. Every ratio would be wrong, so none is shown"));
}

TEST_CASE("on a busy machine what the spread of times could overturn is not recommended") {
  Measurements all = made_up();
  const Budget budget = parse_budget("texels=0.01");
  const Image& texture = earth().nearest.image;
  const Row* fast = fastest(all, Filter::nearest, budget);
  REQUIRE(is_pack(fast->variant.number));
  CHECK(recommendation(all, budget, texture).find(" to ") == std::string::npos);

  // Packs could be as slow as single numbers in truth: of these one is more exact.
  long packs = 0;
  for (Row& row : all.of(Part::places)) {
    if (!is_pack(row.variant.number)) continue;
    row.took.spread = 4;
    ++packs;
  }
  const Row* sure = fastest(all, Filter::nearest, budget);
  CHECK(sure != fast);
  CHECK(sure->bound < fast->bound);
  CHECK(busy_text(all).find(text("busy: %ld of ", packs)) != std::string::npos);

  // What is surely fast but spreads says how fast it is at least and at most.
  for (Row& row : all.of(Part::places)) row.took.spread = 1.2;
  CHECK(recommendation(all, budget, texture).find(" to ") != std::string::npos);
}

TEST_CASE("a picture that goes to a device has no report, and others have four files") {
  CHECK(names_of_report("/dev/null").empty());
  CHECK(names_of_report("out/13.png") ==
        std::vector<std::filesystem::path>{"out/13_speed_error.svg", "out/13_speed_levels.svg",
                                           "out/13_error_seconds.svg", "out/13.json"});
}

TEST_CASE("a number and samples cannot be chosen, and budgets that are none are refused") {
  const auto show = [](const std::vector<std::string>& words) {
    Ready<Lesson> ready("test", words);
    Session session(ready.chosen);
    ready.lesson.draw_all(session);
  };
  CHECK_THROWS_AS(show({"--number", "float"}), UsageError);
  CHECK_THROWS_AS(show({"--samples", "4"}), UsageError);
  CHECK_THROWS_AS(show({"--budget", "levels"}), UsageError);
}
