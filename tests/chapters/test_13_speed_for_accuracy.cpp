// Chapter 13: the figures to rely on hold on inputs that nobody has measured, and a smaller figure
// would not. No clock here.
#include <doctest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <tuple>

#include "13_speed_for_accuracy/lesson.hpp"
#include "engine/measure/text.hpp"
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
  find_errors(rows, globe, view, 0, [] {});
  return rows;
}

bool holds(const Row& seen, const Row& stated) {
  return seen.worst <= stated.bound && (seen.part != Part::places || seen.mean <= stated.bound) &&
         seen.changed <= stated.may_change && seen.levels <= stated.levels_bound;
}

/// Measurements with made-up times.
Measurements made_up() {
  Measurements all{{}, 64, 48};
  const View<> view = earth().view(all.width, all.height);
  all.add(with_errors(Part::places, earth(), view));
  all.add(with_errors(Part::curves, earth(), view));
  all.add(rows_of(Part::formats, Instructions::baseline));
  all.add(rows_of(Part::samplers, Instructions::baseline));
  for (Row& row : all.of(Part::places)) {
    row.took.processor = 100 - (is_pack(row.variant.number) ? 50 : 0) -
                         (is_float(row.variant.number) ? 20 : 0) + row.variant.degree * 0.1 +
                         (row.variant.degree == 0 ? 10 : 0);
    row.time = row.took.processor / all.rows[0].took.processor;
  }
  for (Row& row : all.of(Part::curves)) {
    row.time = (is_pack(row.variant.number) ? 0.5 : 1) - (is_float(row.variant.number) ? 0.1 : 0) -
               (row.variant.curve == Curve::four ? 0.2 : 0) -
               (row.variant.format == TexelFormat::roots ? 0.1 : 0);
    row.took.processor = 100 * row.time;
  }
  for (Row& row : all.of(Part::samplers)) {
    row.mean = 10 / std::pow(row.samples, row.sampler == SamplerKind::random ? 0.5 : 0.75);
    row.bound = 1.5 * row.mean;
    row.took = {row.samples * (row.sampler == SamplerKind::sobol ? 1.1 : 1.2)};
  }
  for (const auto& [name, error, reads, nanoseconds] :
       {std::tuple{"nearest", 0.4, 1, 10}, std::tuple{"trilinear", 0.1, 8, 100},
        std::tuple{"anisotropic 4", 0.02, 30, 200}, std::tuple{"anisotropic", 0.0196, 50, 209},
        std::tuple{"ewa", 0.0195, 35, 300}}) {
    all.rows.push_back({.part = Part::filters,
                        .name = name,
                        .bound = 255 * error,
                        .mean = error,
                        .reads = 1.0 * reads,
                        .took = {1.0 * nanoseconds}});
  }
  for (const auto& [sky, way, samples, error, microseconds, chosen] :
       {std::tuple{"uniform", "cosine", 4, 5.0, 1.0, true},
        std::tuple{"uniform", "cosine", 16, 2.0, 4.0, true},
        std::tuple{"uniform", "mis", 4, 6.0, 1.04, false},
        std::tuple{"uniform", "mis", 16, 1.9, 4.1, false},
        std::tuple{"sun", "cosine", 4, 40.0, 1.0, false},
        std::tuple{"sun", "cosine", 16, 39.0, 4.0, false},
        std::tuple{"sun", "mis", 4, 20.0, 2.0, true},
        std::tuple{"sun", "mis", 16, 8.0, 8.0, true}}) {
    all.rows.push_back({.part = Part::skies,
                        .samples = samples,
                        .name = way,
                        .sky = sky,
                        .chosen = chosen,
                        .bound = error,
                        .mean = error,
                        .took = {microseconds}});
  }
  all.rounds = {{20, 20}, {20, 20}, {6, 6}, {6, 6}, {20, 20}, {6, 6}};
  return all;
}

/// Filters and skies as a run measures them; adds the parts of a run that they were.
Measurements measured_fronts(int threads, std::size_t& ticks) {
  Measurements all;
  Timing timing{1, TimeLimit(0, 1), [&ticks] { ++ticks; }};
  measure_other_chapters(all, threads, timing);
  all.rounds = timing.done;
  return all;
}

/// The row of some rows that `is` is true of.
template <class Is>
Row the(const std::vector<Row>& rows, const Is& is) {
  const auto found = std::find_if(rows.begin(), rows.end(), is);
  if (found == rows.end()) throw std::runtime_error("not tried");
  return *found;
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
      CAPTURE(described_number(seen.variant) + ", " + name_of_kernel(seen.variant.degree));
      CAPTURE(name_of(seen.variant.filter));
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

TEST_CASE(
    "by shorter curves and roots of light no level is farther off than stated, and no more pixels "
    "change") {
  for (const Globe* globe : {&earth(), &noise_globe()}) {
    for (const auto& [east, up] : fresh_angles) {
      for (const Row& row : with_errors(Part::curves, *globe, globe->view(160, 120, east, up))) {
        CAPTURE(name_of(row.variant.number));
        CAPTURE(described_light(row.variant));
        CAPTURE(row.worst);
        CAPTURE(row.changed);
        CHECK(holds(row, row));
        CHECK(row.mean <= row.worst);
        if (row.variant.curve == Curve::exact && row.variant.format == TexelFormat::bytes)
          CHECK(row.may_change == 0);
      }
    }
  }
}

TEST_CASE(
    "the mean of many rays to roots of light is no farther off than stated, by other seeds, from "
    "any angle") {
  double worst = 0;
  std::uint32_t seed = 77;
  for (const auto& [east, up] : fresh_angles) {
    const View<> view = earth().view(noise_width, noise_height, east, up);
    std::vector<Row> formats = rows_of(Part::formats, Instructions::baseline);
    for (Row& row : formats) {
      row.sampler = SamplerKind::random;
      row.samples = 4;
      find_errors(
          {&row, 1}, earth(), view, 0, [] {}, seed++);
      CAPTURE(name_of(row.variant.number));
      CAPTURE(row.worst);
      CHECK(holds(row, row));
      if (row.variant.format == TexelFormat::bytes) CHECK(row.worst == 0);
      if (row.variant.format == TexelFormat::roots) CHECK(row.changed > 0);
      worst = std::max(worst, row.worst);
    }
  }
  CHECK(worst > RootTexture::worst_levels / 3);  // rays of a pixel are off to both sides
}

TEST_CASE(
    "the noise of other seeds, seen from other angles, is within its bound; half the bound, or "
    "fewer samples, are not") {
  const Variant variant{.number = NumberKind::double_pack};
  std::vector<Row> stated = rows_of(Part::samplers, Instructions::baseline);
  std::erase_if(stated, [](const Row& row) { return row.samples > 64; });  // 256 takes long
  for (Row& row : stated) row.variant = variant;
  find_errors(stated, earth(), {}, 0, [] {});
  const auto bound = [&stated](SamplerKind kind, int samples) {
    return the(stated,
               [&](const Row& row) { return row.sampler == kind && row.samples == samples; })
        .bound;
  };
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
      if (row.samples == 4) CHECK(rms_difference(levels, reference) > bound(row.sampler, 64));
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
  // On a plot, what is as fast as something more exact has no label.
  const Measurements made = made_up();
  const std::vector<PlotPoint> filters = plots_of(made)[4].front;
  REQUIRE(filters.size() == 5);
  CHECK(filters[2].label.empty());
  CHECK(filters[3].label == "anisotropic");
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
  CHECK(fastest(all, Part::samplers, 1)->sampler == SamplerKind::sobol);
  CHECK(fastest(all, Part::samplers, 1)->samples == 64);
  CHECK(fastest(all, Part::samplers, 0.01) == nullptr);
}

TEST_CASE("the cheapest filter and way that keep to a budget in levels") {
  const Measurements all = made_up();
  struct Case {
    Part part;
    const char* sky;
    double levels;
    const char* best;
  };
  for (const auto& [part, sky, levels, best] :
       {Case{Part::filters, "", 255, "nearest"},
        {Part::filters, "", 255 * 0.4, "nearest"},  // light 0 to 1: times 255 it is levels
        {Part::filters, "", 255 * 0.4 - 0.01, "trilinear"},
        {Part::filters, "", 25.4, "anisotropic"},  // as fast as "anisotropic 4", and more exact
        {Part::filters, "", 4.99, "ewa"},
        {Part::filters, "", 4.9, "none"},
        {Part::skies, "uniform", 6, "cosine 4"},  // "mis 4" is as fast, and farther off
        {Part::skies, "uniform", 4, "mis 16"},    // "cosine 16" is as fast, and farther off
        {Part::skies, "uniform", 1, "none"},
        {Part::skies, "sun", 39.5, "mis 4"},
        {Part::skies, "sun", 40, "cosine 4"},
        {Part::skies, "sun", 8, "mis 16"},
        {Part::skies, "sun", 7, "none"}}) {
    const Row* row = fastest(all, part, levels, sky);
    const std::string samples =
        part == Part::skies && row != nullptr ? text(" %d", row->samples) : "";
    CHECK((row == nullptr ? "none" : row->name + samples) == best);
  }
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
       {Case{"exact", "./course run 07 --number double-pack"},
        {"texels=1e-16", "nothing that was tried"},
        {"texels=0.01", packs},
        {"texels=0.01", "share alone; rounding adds the rest of the bound"},
        {"exact", "share alone", false},  // the command's budget is the one that was typed
        {"levels=25.4", "  filter    anisotropic: 5.00 levels of light off"},
        {"levels=25.4", " ./course run 09 --filter anisotropic\n"},
        {"levels=25.4", "  sky       uniform: cosine, 4 samples per pixel: 5.00 levels off"},
        {"levels=25.4", " ./course run 12 --sky FILE --light cosine --samples 4\n"},
        {"levels=25.4", "            sun: mis, 4 samples per pixel: 20.00 levels off"},
        {"levels=25.4", " ./course run 12 --light mis --samples 4\n"},
        {"levels=1", "  filter    nothing that was tried keeps to it\n"},
        {"levels=1", "  sky       uniform: nothing that was tried keeps to it\n"},
        {"levels=1", "            sun: nothing that was tried keeps to it\n"},
        {"levels=1", "texels as roots, 4 terms: "},
        {"levels=1", "at most 0.68 levels off"},
        {"levels=1", " --budget levels=1\n"},
        {"texels=0.01", "  light", false},
        {"texels=0.01", "./course run 09", false}}) {
    const std::string lines = recommendation(all, parse_budget(budget), earth().nearest.image);
    CHECK((lines.find(words) != std::string::npos) == said);
  }
}

TEST_CASE(
    "filters and skies: a row for everything, the same errors for any number of threads, and as "
    "many parts as the progress counts") {
  std::size_t ticks = 0, others = 0;
  const Measurements one = measured_fronts(1, ticks), three = measured_fronts(3, others);
  REQUIRE(one.of(Part::filters).size() == 9);
  REQUIRE(one.of(Part::skies).size() == 45);
  for (std::size_t i = 0; i < one.rows.size(); ++i) {
    CHECK(one.rows[i].bound == three.rows[i].bound);
    CHECK(one.rows[i].reads == three.rows[i].reads);
    CHECK(one.rows[i].bound > 0);
    CHECK(one.rows[i].took.processor > 0);
  }
  CHECK(skies_of(one) == std::vector<std::string>{"uniform", "gradient", "sun"});
  CHECK(fastest(one, Part::filters, 4) != nullptr);
  const std::string json = json_of(one);
  CHECK(json.find("\"--filter anisotropic --taps 2\"") != std::string::npos);
  CHECK(json.find("\"--filter anisotropic\"") != std::string::npos);

  std::size_t counted = 0;
  for (const Phase& phase : phases_of(1, Instructions::baseline)) {
    const std::string name = phase.name;
    if (name.ends_with(" filters") || name.ends_with(" skies")) counted += phase.parts;
  }
  CHECK(ticks == counted);
  CHECK(one.rounds.size() == 2);
  CHECK(one.other_rays > 1e6);
}

TEST_CASE(
    "light is recommended by its bound in whole levels, and from numbers alone that find every "
    "texel") {
  Measurements all = made_up();
  const Row* best = fastest_light(all, parse_budget("levels=1"));
  REQUIRE(best != nullptr);
  CHECK(described_light(best->variant) == "roots, 4 terms");
  CHECK((best->variant.number == NumberKind::double_ ||
         best->variant.number == NumberKind::double_pack));  // float's places may be off
  CHECK(described_light(fastest_light(all, parse_budget("levels=0.9"))->variant) == "bytes, exact");

  // What is as fast and more exact is taken.
  for (Row& row : all.of(Part::curves)) row.took.processor = 100;
  CHECK(described_light(fastest_light(all, parse_budget("levels=1"))->variant) == "bytes, exact");
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
    for (const int degree : {0, 5, 7, 9, 11, 13, 15, 17, 23, 29, 35}) {
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
  const std::string json = json_of(all);
  const auto count = [&json](const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = json.find(word); at != std::string::npos; at = json.find(word, at + 1))
      ++found;
    return found;
  };
  CHECK(count("\"number\"") ==
        all.of(Part::places).size() + all.of(Part::curves).size() + all.of(Part::formats).size());
  for (const auto& [word, part] :
       {std::pair{"\"sampler\"", Part::samplers}, std::pair{"\"reads\"", Part::filters},
        std::pair{"\"sky\"", Part::skies}})
    CHECK(count(word) == all.of(part).size());
  CHECK(count("\"spread\"") == all.rows.size());
  CHECK(count("{") == count("}"));
  CHECK(count("[") == 7);
  for (const Part part : {Part::filters, Part::skies}) {
    for (const Row& row : all.of(part))
      CHECK(table.find("\n" + errors_text(all, row) + " ") != std::string::npos);
  }
}

#ifdef TEXMAP_REFERENCE_PLATFORM
TEST_CASE("the errors of filters and skies on the pages of 12 and 13 are those of the program") {
  std::size_t ticks = 0;
  const Measurements all = measured_fronts(0, ticks);
  for (const Row& row : all.rows) {
    CAPTURE(row.name);
    CHECK(page().find("\n" + errors_text(all, row) + " ") != std::string::npos);
  }
  CHECK(page().find(all.choice) != std::string::npos);
}

TEST_CASE("the errors on the chapter's page are those of its program") {
  const View<> view = view_of_sheet(earth(), 1312, 1090);
  std::vector<Row> rows = with_errors(Part::places, earth(), view);
  std::erase_if(rows, [](const Row& row) { return row.variant.filter != Filter::nearest; });
  for (const Part part : {Part::curves, Part::formats}) {
    const std::vector<Row> light =
        with_errors(part, earth(), part == Part::curves ? view : noise_view(earth(), 0));
    rows.insert(rows.end(), light.begin(), light.end());
  }
  std::map<bool, int> found;  // lines of places, and lines of light
  std::stringstream lines(page());
  for (std::string line; std::getline(lines, line);) {
    const auto is_of = [&line](const Row& row) {  // packs of light may be of other instructions
      const bool is_place = row.part == Part::places;
      const std::string second = is_place
                                     ? text("%-10s ", name_of_kernel(row.variant.degree).c_str())
                                     : columns_of_light(row.variant) + " ";
      const std::size_t at = line.find(" " + second);
      return line.starts_with(text("%-12s ", name_of(row.variant.number))) &&
             (is_place ? at == 12 : at != std::string::npos);
    };
    std::vector<Row> possible;  // light: with one ray, and with many
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(possible), is_of);
    if (possible.empty()) continue;
    CAPTURE(line);
    const Row& first = possible[0];
    ++found[first.part == Part::places];
    if (judge_is_pair && first.variant.number == NumberKind::extended) {
      // The page's judge is long double, which finds no error in itself; pairs do.
      CHECK(first.worst > 0);
      CHECK(first.worst < first.bound);
    } else {
      CHECK(std::any_of(possible.begin(), possible.end(),
                        [&](const Row& row) { return line.ends_with(errors_text({}, row)); }));
    }
  }
  CHECK(found[true] == 9);
  CHECK(found[false] == 12);
}
#endif

TEST_CASE(
    "when the time limit is reached, rounds are skipped, counted and told, and the progress is as "
    "far as it "
    "would have been") {
  const View<> view = earth().view(8, 6);
  std::vector<Row> rows = rows_of(Part::curves, Instructions::baseline);
  long ticks = 0;
  double now = 0;
  const auto timing_for = [&](double limit) {
    return Timing{8, TimeLimit(limit, 3, [&now] { return now += 10; }),
                  [&ticks] { ++ticks; }};  // each look takes 10 ms
  };
  for (const auto& [limit, rounds] : {std::pair{35.0, 6}, std::pair{1e9, 8}, std::pair{0.0, 3}}) {
    ticks = 0;
    now = 0;
    Timing timing = timing_for(limit);
    time_rows(rows, earth(), view, timing);
    REQUIRE(timing.done.size() == 1);
    CHECK(timing.done[0].timed == rounds);
    CHECK(timing.done[0].wanted == 8);
    CHECK(ticks == 9 * static_cast<long>(rows.size()));
    for (const Row& row : rows) CHECK(row.time < 1e9);
  }

  Measurements all = made_up();
  CHECK(skipped_text(all).empty());
  all.rounds[1].timed = 5;
  CHECK(skipped_text(all).find("20 of 20, 5 of 20, 6 of 6, 6 of 6, 20 of 20, 6 of 6") !=
        std::string::npos);
  CHECK(table_of(all).find(skipped_text(all)) != std::string::npos);
  const double rays = rays_of(all);
  all.rounds[1].timed = 4;
  CHECK(rays - rays_of(all) == doctest::Approx(1.0 * all.width * all.height *
                                               static_cast<double>(all.of(Part::curves).size())));
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
  CHECK(busy_text(all).empty());
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
  CHECK(table_of(all).find(busy_text(all)) != std::string::npos);

  // What is surely fast but spreads says how fast it is at least and at most.
  for (Row& row : all.of(Part::places)) row.took.spread = 1.2;
  CHECK(recommendation(all, budget, texture).find(" to ") != std::string::npos);
}

TEST_CASE("the progress names what comes next, and ends with the run") {
  Ticks ticks{{{"first", 2}, {"second", 1}}};
  std::vector<std::pair<int, int>> told;
  const RenderSettings settings{
      .progress = [&](int done, int total) { told.emplace_back(done, total); }};
  CHECK(ticks.remark() == ", first");
  ticks(settings);
  CHECK(ticks.remark() == ", first");
  ticks(settings);
  CHECK(ticks.remark() == ", second");
  ticks(settings);
  CHECK(ticks.remark().empty());
  CHECK(told == std::vector<std::pair<int, int>>{{1, 3}, {2, 3}, {3, 3}});
}

TEST_CASE("a picture that goes to a device has no report, and others have seven files") {
  CHECK(names_of_report("/dev/null").empty());
  CHECK(names_of_report("out/13.png") ==
        std::vector<std::filesystem::path>{"out/13_speed_error.svg", "out/13_speed_levels.svg",
                                           "out/13_error_samples.svg", "out/13_error_seconds.svg",
                                           "out/13_filter_error.svg", "out/13_sky_error.svg",
                                           "out/13.json"});
}

TEST_CASE("a number and samples cannot be chosen, and budgets that are none are refused") {
  const auto show = [](const std::vector<std::string>& words) {
    Lesson lesson;
    CommandLine line("test", "");
    lesson.options(line);
    Session session("test", line, Lesson::about);
    if (line.parse(words)) lesson.draw_all(session);
  };
  CHECK_THROWS_AS(show({"--number", "float"}), UsageError);
  CHECK_THROWS_AS(show({"--samples", "4"}), UsageError);
  CHECK_THROWS_AS(show({"--budget", "levels"}), UsageError);
}
