// One run of a chapter's program: common options, drawing and saving.
#include "engine/app/session.hpp"

#include <algorithm>
#include <system_error>

#include "engine/app/command_line.hpp"
#include "engine/app/turntable.hpp"
#include "engine/measure/text.hpp"
#include "engine/picture/save_png.hpp"
#include "engine/render/progress.hpp"
#include "engine/system/system.hpp"

namespace texmap {
namespace {

constexpr int longest_side = 16384;
constexpr long most_pixels = 1L << 26;

/// The pixel that --at names in a picture of this size. Errors: UsageError.
PixelPlace<double> pixel_at(std::string_view typed, int width, int height) {
  const std::size_t comma = typed.find(',');
  if (comma == std::string_view::npos) {
    throw UsageError("--at takes COLUMN,ROW such as 400,300, not '" + std::string(typed) + "'");
  }
  return {double{1} * parse_whole("the column of --at", typed.substr(0, comma), 0, width - 1),
          double{1} * parse_whole("the row of --at", typed.substr(comma + 1), 0, height - 1)};
}

}  // namespace

Session::Session(std::string_view chapter, CommandLine& line, const About& about,
                 const Offers& offers)
    : one_number_(offers.one_number), line_(line), times_{.before_drawing = Stopwatch()} {
  settings.out = "out/" + std::string(chapter) + ".png";
  default_out_ = settings.out;
  settings.width = about.size.width;
  settings.height = about.size.height;
  settings.samples = line.wishes.samples;
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
    line.whole("--samples", settings.samples, 1, line.wishes.samples_limit,
               "rays per pixel: 1 goes through the pixel's center, more make edges smooth");
  }
  line.whole("--threads", settings.threads, 0, 1024,
             "number of threads, 0 for one per core; the picture does not depend on it");
  if (offered("--number")) {
    const bool lacks_sines =
        about.numbers == Numbers::no_intervals && line.wishes.no_intervals.empty();
    offer_numbers(about.numbers,
                  lacks_sines ? "they have no sin, cos, pow or ldexp" : line.wishes.no_intervals);
  }
  if (!line.wishes.budget.empty())
    line.text("--budget", "BUDGET", settings.budget, line.wishes.budget);
  if (offers.spheres) {
    line.choice(
        "--spheres", settings.spheres, "plain|robust|hybrid",
        "the formula for where a ray meets a sphere. robust draws every scene of the course; from "
        "1e4 radii away in float, 1e7 in double, it changes to hybrid by itself. hybrid takes "
        "about 6 times as long; ask for it in float from 100 radii away, and where the eye is "
        "close above a surface. plain is the textbook's formula, to see where it fails");
  }
  if (offers.surfaces) {
    line.choice(
        "--show", settings.show, "color|normal|uv|object",
        "what to show in each pixel; all but color help to find errors, and have a black sky. "
        "normal: the unit normal, x as red, y as green, z as blue, each from -1 to 1. uv: u as red "
        "and v as green, of numbers outside 0 to 1 the part after the decimal point; gray where "
        "there is no (u, v). object: a different color for each object or triangle");
  }
  if (offered("--zoom")) {
    line.decimal("--zoom", settings.zoom, 0.01, 1e6,
                 "magnification: 2 shows half of the width and half of the height");
    line.text("--at", "COLUMN,ROW", settings.at,
              "the pixel that stays in its place when --zoom enlarges the picture, counted from "
              "0,0 at the upper left; without this option, the middle");
  }
  line.flag("--quiet", settings.quiet, "show no progress, and print nothing on success");
}

void Session::offer_numbers(Numbers numbers, std::string_view no_intervals) {
  if (numbers == Numbers::only_double) return;
  std::string help = "the number type to calculate with";
  if (numbers == Numbers::single)
    return line_.choice("--number", settings.number, "float|double|extended", help);
  const char* words = "float|double|extended|float-pack|double-pack";
  if (!no_intervals.empty()) {
    help.append("; not interval: ").append(no_intervals);
  } else {
    words = "float|double|extended|float-pack|double-pack|interval";
    help +=
        "; interval shows which pixels rounding could change, and prints how many: certain pixels "
        "are gray, and uncertain ones are drawn three pixels wide, yellow for 1 level to violet "
        "for 255";
  }
  line_.choice("--number", settings.number, words, help);
  line_.choice("--instructions", settings.instructions, "baseline|avx2|avx512",
               "the vector instructions that packs use; without this option, the "
               "widest that the machine has");
}

bool Session::was_given(std::string_view option) const { return line_.was_given(option); }

void Session::default_size(int width, int height) {
  if (!was_given("--width")) settings.width = width;
  if (!was_given("--height")) settings.height = height;
}

void Session::check() const {
  const bool double_alone = settings.number == NumberKind::double_ && settings.budget == "exact";
  if (one_number_ && (!double_alone || was_given("--instructions"))) {
    throw UsageError(
        "--number, --instructions and --budget need a program with all number types. This one was "
        "built for learning, with double alone. ./course run NN builds the other one if you give "
        "such an option; by hand: cmake --preset release && cmake --build --preset release");
  }
  if (settings.show != Shown::color && settings.number == NumberKind::interval) {
    throw UsageError(
        "--show normal, uv and object do not work with --number interval, which bounds colors");
  }
  if (settings.show != Shown::color && was_given("--samples") && settings.samples != 1) {
    throw UsageError(
        "--show normal, uv and object use 1 ray per pixel, because a mean of normals or objects "
        "has no meaning: leave --samples out");
  }
  if (was_given("--at") && !was_given("--zoom")) {
    throw UsageError("--at is the pixel that stays in its place under --zoom: give --zoom, too");
  }
  if (!machine_has(settings.instructions)) {
    throw UsageError(
        "--instructions: this machine does not have them; without the option the program uses the "
        "widest that the machine has");
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

void Session::plan() const {
  for (const auto& plan : line_.wishes.plans) plan(*this);
}

void Session::check_uses() const {
  for (const auto& use : line_.wishes.uses) use();
}

View<> Session::view(const Camera& camera, int width, int height) {
  seen_by_camera_ = true;
  View<> view = view_of(camera, width, height);
  const PixelPlace<double> fixed = settings.at.empty()
                                       ? PixelPlace<double>{view.center_column, view.center_row}
                                       : pixel_at(settings.at, width, height);
  // The ray through `fixed` + d is then that of the whole picture through `fixed` + d / zoom.
  view.pixel = view.pixel / settings.zoom;
  view.center_column = fixed.column + settings.zoom * (view.center_column - fixed.column);
  view.center_row = fixed.row + settings.zoom * (view.center_row - fixed.row);
  return view;
}

std::filesystem::path Session::file_name(std::string_view suffix) const {
  std::filesystem::path file = path_of(settings.out);
  std::filesystem::path name = file.stem();
  name += path_of(suffix);
  name += file.extension();
  return file.replace_filename(name);
}

// Not with the turntable's options: a program without them would read files.
std::string frame_suffix(int frame) { return text("_%03d", frame); }

Image Session::timed(double rays, const std::function<Image(const RenderSettings&)>& work) {
  Progress progress(!settings.quiet, remark);
  if (times_.before_drawing) times_.load = times_.before_drawing->milliseconds();
  times_.before_drawing.reset();
  const Stopwatch drawing;
  Image image =
      work({.samples = settings.samples,
            .threads = settings.threads,
            .instructions = settings.instructions,
            .progress = [&progress](int done, int total) { progress.report(done, total); },
            .certainty =
                [this](long uncertain, long pixels) {
                  times_.uncertain += uncertain;
                  times_.judged += pixels;
                }});
  times_.render += drawing.milliseconds();
  times_.rays += rays;
  return image;
}

void Session::count_rays(double rays) { times_.rays += rays; }

void Session::save(const Image& image, std::string_view suffix) {
  if ((settings.show != Shown::color || settings.zoom != 1) && !seen_by_camera_) {
    throw UsageError(
        "--zoom and --show normal, uv and object work only for pictures that a camera sees; this "
        "picture has no camera");
  }
  seen_by_camera_ = false;
  const std::filesystem::path file = file_name(suffix);
  const SavingTime saving = save_png(image, file);
  if (!settings.quiet && times_.judged > 0) {
    print(text("rounding could change %ld of %ld pixels, each drawn three wide\n", times_.uncertain,
               times_.judged));
  }
  if (!settings.quiet) {
    const double all = times_.load + times_.render + saving.encode + saving.write;
    print(name_of(file) +
          text(": %d x %d pixels, %.1f ms (load %.1f, render %.1f, encode %.1f, write %.1f)",
               image.width, image.height, all, times_.load, times_.render, saving.encode,
               saving.write) +
          (times_.rays > 0 ? text(", %.1f million rays/s\n", times_.rays / times_.render / 1000)
                           : "\n"));
  }
  times_ = {};
}

}  // namespace texmap
