// The options of all chapters, and what does not go together.
#include "engine/run/chosen.hpp"

#include <system_error>

#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "engine/run/budget_options.hpp"
#include "engine/run/command_line.hpp"
#include "engine/run/turntable.hpp"

namespace texmap {
namespace {

constexpr int longest_side = 16384;
constexpr long most_pixels = 1L << 26;

}  // namespace

Chosen::Chosen(std::string_view name, const Offer& offer, const About& about)
    : chapter(name), turntable(offer.turntable), one_number_(offer.one_number), line_(offer.line) {
  settings.out = "out/" + chapter + ".png";
  default_out_ = settings.out;
  settings.width = about.size.width;
  settings.height = about.size.height;
  settings.samples = offer.samples;
  if (about.numbers != Numbers::all || one_number_) settings.number = NumberKind::double_;
  CommandLine& line = offer.line;
  line.note = [this](const std::string& text) { say(text); };
  const std::string note = *about.size_note == '\0' ? "" : std::string("; ") + about.size_note;
  line.text("--out", "FILE", settings.out, "where to put the picture, a PNG");
  line.whole("--width", settings.width, 1, longest_side, "columns of pixels" + note);
  line.whole("--height", settings.height, 1, longest_side, "rows of pixels" + note);
  if (offer.camera) {
    line.whole("--samples", settings.samples, 1, offer.most_samples,
               offer.samples == 1
                   ? "rays per pixel: 1 goes through the pixel's center, more make edges smooth"
                   : "rays per pixel, each through a random place in it");
  }
  line.whole("--threads", settings.threads, 0, 1024,
             "number of threads, 0 for one per core; the picture does not depend on it");
  if (offer.camera) {
    const bool lacks_sines = about.numbers == Numbers::no_intervals && offer.no_intervals.empty();
    offer_numbers(about.numbers,
                  lacks_sines ? "they have no sin, cos, pow or ldexp" : offer.no_intervals);
  }
  if (!offer.budget.empty()) {
    line.add("--budget", "BUDGET", offer.budget, to_text(settings.budget),
             [this](const std::string&, std::string_view typed) {
               settings.budget = read_budget(typed);
               return true;
             });
  }
  if (offer.spheres) {
    line.choice(
        "--spheres", settings.spheres, "plain|robust|hybrid",
        "the formula for where a ray meets a sphere. robust draws every scene of the course; from "
        "1e4 radii away in float, 1e7 in double, it changes to hybrid by itself. hybrid takes "
        "about 6 times as long; ask for it in float from 100 radii away, and where the eye is "
        "close above a surface. plain is the textbook's formula, to see where it fails");
  }
  if (offer.surfaces) {
    line.choice(
        "--show", settings.show, "color|normal|uv|object",
        "what to show in each pixel; all but color help to find errors: they are drawn in double, "
        "and have a black sky. normal: the unit normal, x as red, y as green, z as blue, each from "
        "-1 to 1. uv: u as red and v as green, of numbers outside 0 to 1 the part after the "
        "decimal point; gray where there is no (u, v). object: a different color for each object "
        "or triangle");
  }
  if (offer.camera) {
    line.decimal("--zoom", settings.zoom, 0.01, 1e6,
                 "magnification: 2 shows half of the width and half of the height");
    line.text("--at", "COLUMN,ROW", settings.at,
              "the pixel that stays in its place when --zoom enlarges the picture, counted from "
              "0,0 at the upper left; without this option, the middle");
  }
  if (offer.camera && !one_number_) {
    line.flag("--trade", trade,
              "in place of a picture, measure the ways to draw it: the time and the error of every "
              "number, and of what else this program lets you choose");
  }
  if (offer.extremes && !one_number_) {
    line.flag("--extremes", extremes,
              "in place of a picture, find the sizes and distances at which float and double "
              "change it");
  }
  line.flag("--quiet", settings.quiet, "show no progress, and print nothing on success");
}

void Chosen::offer_numbers(Numbers numbers, std::string_view no_intervals) {
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

void Chosen::default_size(int width, int height) {
  if (!was_given("--width")) settings.width = width;
  if (!was_given("--height")) settings.height = height;
  check_size();
}

void Chosen::check_size() const {
  usage_error_if(static_cast<long>(settings.width) * settings.height > most_pixels,
                 "--width " + std::to_string(settings.width) + " times --height " +
                     std::to_string(settings.height) + " must be at most 67108864 (2^26) pixels");
}

bool Chosen::was_given(std::string_view option) const { return line_.was_given(option); }

void Chosen::say(const std::string& text) const {
  if (!settings.quiet && (turntable == nullptr || turntable->frame == 0)) print(text);
}

void Chosen::note(const std::string& text) const { line_.note(text); }

void Chosen::check() {
  const std::filesystem::path out = path_of(settings.out);
  if (is_standard_output(out)) {
    usage_error_if(trade || extremes,
                   "--trade and --extremes print a table there: leave out --out");
    settings.quiet = true;  // else lines would be in the picture
  }
  const bool double_alone = settings.number == NumberKind::double_ && settings.budget.is_exact();
  usage_error_if(
      one_number_ && (!double_alone || was_given("--instructions")),
      "--number, --instructions and --budget need a program with all number types. This one was "
      "built for learning, with double alone. ./course run NN builds the other one if you give "
      "such an option; by hand: cmake --preset release && cmake --build --preset release");
  usage_error_if(
      settings.show != Shown::color && settings.number == NumberKind::interval,
      "--show normal, uv and object do not work with --number interval, which bounds colors");
  usage_error_if(
      settings.show != Shown::color && was_given("--samples") && settings.samples != 1,
      "--show normal, uv and object use 1 ray per pixel, because a mean of normals or objects "
      "has no meaning: leave --samples out");
  for (const char* option : {"--budget", "--time-limit", "--target-error"}) {
    usage_error_if(settings.show != Shown::color && was_given(option),
                   std::string(option) + " is for colors: leave it out, or --show");
  }
  usage_error_if(was_given("--at") && !was_given("--zoom"),
                 "--at is the pixel that stays in its place under --zoom: give --zoom, too");
  for (const char* option : {"--plot", "--show", "--to", "--turntable"}) {
    usage_error_if((trade || extremes) && was_given(option),
                   std::string(trade ? "--trade" : "--extremes") +
                       " measures one picture of the lesson's scene: leave out " + option);
  }
  usage_error_if(
      !machine_has(settings.instructions),
      "--instructions: this machine does not have them; without the option the program uses the "
      "widest that the machine has");
  check_size();
  std::string lower = settings.out;
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const std::string_view ending :
       {".jpg", ".jpeg", ".gif", ".bmp", ".tif", ".tiff", ".webp"}) {
    usage_error_if(
        lower.ends_with(ending),
        "--out " + settings.out + ": pictures are written as PNG; give a name that ends in .png");
  }
  if (settings.out == default_out_) {
    std::error_code error;
    std::filesystem::create_directories("out", error);  // check_output reports an error
  }
  check_output(out);
}

}  // namespace texmap
