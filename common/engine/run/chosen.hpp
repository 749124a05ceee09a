// What the user chose: the options of all chapters, and those of a lesson's groups.
#pragma once
#include <string>
#include <string_view>

#include "engine/draw/lesson.hpp"
#include "engine/draw/settings.hpp"
#include "engine/fast/budget.hpp"
#include "engine/files/stopwatch.hpp"
#include "scene/sphere_forms.hpp"

namespace texmap {

class CommandLine;
struct Turntable;

/// The user's choices; a chapter may offer fewer.
struct Settings {
  std::string out;                                    ///< the picture's file
  int width = 800;                                    ///< pixels
  int height = 600;                                   ///< pixels
  int samples = 1;                                    ///< rays per pixel
  int threads = 0;                                    ///< 0: all cores
  NumberKind number = NumberKind::double_pack;        ///< draws what double draws (tests/packs)
  Instructions instructions = widest_instructions();  ///< of packs
  SphereForm spheres = SphereForm::robust;            ///< for all spheres of the lesson
  Budget budget{};                                    ///< how far off the picture may be
  bool quiet = false;                                 ///< no progress, no line on success
  Shown show = Shown::color;                          ///< of the surfaces that the camera sees
  double zoom = 1;                                    ///< 1: the lesson's view
  std::string at;  ///< COLUMN,ROW of the pixel that stays in its place; empty: the middle
};

/// What a program offers its user. A lesson's groups add options to `line`, and say what else the
/// program then offers.
struct Offer {
  CommandLine& line;
  std::string_view budget{};        ///< the help of --budget; empty: not offered
  std::string_view no_intervals{};  ///< why --number interval is refused; empty: offered
  int samples = 1;                  ///< rays per pixel
  int most_samples = 65536;         ///< the most that --samples takes
  Turntable* turntable = nullptr;   ///< the pictures of a turn; null: one picture
  bool camera = true;               ///< --number, --samples, --zoom: of pictures that a camera sees
  bool spheres = false;             ///< --spheres
  bool surfaces = false;            ///< --show
  bool extremes = false;            ///< --extremes
  bool one_number = false;          ///< the program was built for learning, with double alone
};

class Chosen {
 public:
  /// Adds the options of all chapters to the offer's line, which must live as long.
  ///
  /// @param name  of the chapter's folder, such as 02_checkerboard_uv: the picture's default name
  Chosen(std::string_view name, const Offer& offer, const About& about);
  Chosen(const Chosen&) = delete;  // the options keep the places of its settings
  Chosen& operator=(const Chosen&) = delete;

  const std::string chapter;  ///< its folder's name
  Settings settings;
  bool trade = false, extremes = false;  ///< to be measured, in place of a picture
  Turntable* const turntable;
  const Stopwatch since_start{};

  [[nodiscard]] bool was_given(std::string_view option) const;
  /// The picture's size where the user gave none. Errors: UsageError for too many pixels.
  void default_size(int width, int height);
  /// Prints a text, unless the user wants none: once, not for each picture of a turn.
  void say(const std::string& text) const;
  /// The same about a file of the user's: a page shows it, too.
  void note(const std::string& text) const;
  /// Refuses what does not go together, pictures that are too large, and files that cannot be
  /// written. A picture on the standard output is quiet. Errors: UsageError, FileError.
  void check();

 private:
  void check_size() const;
  void offer_numbers(Numbers numbers, std::string_view no_intervals);

  std::string default_out_;
  bool one_number_;
  CommandLine& line_;
};

}  // namespace texmap
