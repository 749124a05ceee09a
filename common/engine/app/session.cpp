// One run of a chapter's program: common options, drawing and saving.
#include "engine/app/session.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include "engine/app/command_line.hpp"
#include "engine/measure/stopwatch.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/render/progress.hpp"
#include "engine/system/system.hpp"

namespace texmap {
namespace {

constexpr int longest_side = 16384;
constexpr long most_pixels = 1L << 26;

}  // namespace

/// Milliseconds since the last picture was saved.
struct Session::Times {
  std::optional<Stopwatch> before_drawing{Stopwatch()};  // until the first ray
  double load = 0;                                       // before the first ray
  double render = 0;
  double rays = 0;
};

Session::Session(std::string_view chapter, CommandLine& line, const About& about,
                 const Offers& offers)
    : one_number_(offers.one_number), line_(line), times_(std::make_unique<Times>()) {
  settings.out = "out/" + std::string(chapter) + ".png";
  default_out_ = settings.out;
  settings.width = about.size.width;
  settings.height = about.size.height;
  settings.samples = offers.samples;
  if (about.numbers != Numbers::all || one_number_) settings.number = NumberKind::double_;
  const auto offered = [&about](std::string_view option) {
    return std::none_of(about.without.begin(), about.without.end(), [option](const char* without) {
      return without != nullptr && option == without;
    });
  };
  const std::string note = *about.size_note == '\0' ? "" : std::string("; ") + about.size_note;
  line.text("--out", "FILE", settings.out, "where to put the picture, a PNG");
  line.whole("--width", settings.width, 1, longest_side, "columns of pixels" + note);
  line.whole("--height", settings.height, 1, longest_side, "rows of pixels" + note);
  if (offered("--samples")) {
    line.whole("--samples", settings.samples, 1, offers.most_samples,
               "rays a pixel: 1 looks through its center, more smooth the edges");
  }
  line.whole("--threads", settings.threads, 0, 1024,
             "threads to draw with, 0 for one per core; the picture is the same");
  if (offered("--number")) offer_numbers(about.numbers, offers.no_intervals);
  if (!offers.budget.empty()) line.text("--budget", "BUDGET", settings.budget, offers.budget);
  if (offers.spheres) {
    line.choice<SphereForm>("--spheres", settings.spheres,
                            {{"plain", SphereForm::plain},
                             {"robust", SphereForm::robust},
                             {"hybrid", SphereForm::hybrid}},
                            "formulas for meeting a sphere: robust draws every scene of the "
                            "course; hybrid, some 6 times slower, is for float beyond 100 radii "
                            "and an eye close above a surface, and taken for robust beyond 1e4 "
                            "radii in float, 1e7 in double; plain shows how the textbook's fails");
  }
  line.flag("--quiet", settings.quiet, "no progress, nothing printed on success");
}

Session::~Session() = default;

void Session::offer_numbers(Numbers numbers, std::string_view no_intervals) {
  if (numbers == Numbers::only_double) return;
  std::vector<std::pair<std::string_view, NumberKind>> words = {{"float", NumberKind::float_},
                                                                {"double", NumberKind::double_},
                                                                {"extended", NumberKind::extended}};
  if (numbers == Numbers::single) {
    line_.choice<NumberKind>("--number", settings.number, words, "the number to calculate with");
    return;
  }
  words.insert(words.end(),
               {{"float-pack", NumberKind::float_pack}, {"double-pack", NumberKind::double_pack}});
  std::string help = "the number to calculate with";
  if (!no_intervals.empty()) {
    help.append("; not interval: ").append(no_intervals);
  } else {
    words.emplace_back("interval", NumberKind::interval);
    help +=
        "; interval draws which pixels rounding could change: gray where none can change its "
        "bytes, yellow to violet for "
        "1 to 255 levels of uncertainty";
  }
  line_.choice<NumberKind>("--number", settings.number, words, help);
  line_.choice<Instructions>("--instructions", settings.instructions,
                             {{"baseline", Instructions::baseline},
                              {"avx2", Instructions::avx2},
                              {"avx512", Instructions::avx512}},
                             "what packs are made of; the machine's widest unless given");
}

bool Session::was_given(std::string_view option) const { return line_.was_given(option); }

void Session::default_size(int width, int height) {
  if (!was_given("--width")) settings.width = width;
  if (!was_given("--height")) settings.height = height;
}

void Session::check_numbers() const {
  const bool double_alone = settings.number == NumberKind::double_ && settings.budget == "exact";
  if (double_alone && !was_given("--instructions")) return;
  throw UsageError(
      "--number, --instructions and --budget need a program with all numbers, and this one was "
      "built "
      "for learning, with double alone: ./course run NN builds the other one when they are given, "
      "or "
      "by hand: cmake --preset release && cmake --build --preset release");
}

void Session::check() const {
  if (one_number_) check_numbers();
  if (!machine_has(settings.instructions)) {
    throw UsageError(
        "--instructions: this machine cannot run them; without the option the program takes the "
        "widest that it can");
  }
  if (static_cast<long>(settings.width) * settings.height > most_pixels) {
    throw UsageError("--width " + std::to_string(settings.width) + " times --height " +
                     std::to_string(settings.height) + " must be at most 67108864 (2^26) pixels");
  }
  for (const std::string_view ending :
       {".jpg", ".jpeg", ".gif", ".bmp", ".tif", ".tiff", ".webp"}) {
    if (settings.out.ends_with(ending)) {
      throw UsageError("--out " + settings.out +
                       ": pictures are written as PNG; give a name that ends in .png");
    }
  }
  if (settings.out == default_out_) {
    std::error_code error;
    std::filesystem::create_directories("out", error);  // check_output reports an error
  }
  check_output(path_of(settings.out));
}

std::filesystem::path Session::file_name(std::string_view suffix) const {
  std::filesystem::path file = path_of(settings.out);
  std::filesystem::path name = file.stem();
  name += path_of(suffix);
  name += file.extension();
  return file.replace_filename(name);
}

Image Session::timed(double rays, const std::function<Image(const RenderSettings&)>& work) {
  Progress progress(!settings.quiet, remark);
  if (times_->before_drawing) times_->load = times_->before_drawing->milliseconds();
  times_->before_drawing.reset();
  const Stopwatch drawing;
  Image image =
      work({.samples = settings.samples,
            .threads = settings.threads,
            .instructions = settings.instructions,
            .progress = [&progress](int done, int total) { progress.report(done, total); }});
  times_->render += drawing.milliseconds();
  times_->rays += rays;
  return image;
}

void Session::count_rays(double rays) { times_->rays += rays; }

void Session::save(const Image& image, std::string_view suffix) {
  const std::filesystem::path file = file_name(suffix);
  const SavingTime saving = save_png(image, file);
  if (!settings.quiet) {
    const double all = times_->load + times_->render + saving.encode + saving.write;
    print(name_of(file) +
          text(": %d x %d pixels, %.1f ms (load %.1f, render %.1f, encode %.1f, write %.1f), "
               "%.1f million rays/s\n",
               image.width, image.height, all, times_->load, times_->render, saving.encode,
               saving.write, times_->rays / times_->render / 1000));
  }
  const Times none{.before_drawing = {}};
  *times_ = none;
}

}  // namespace texmap
