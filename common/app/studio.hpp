// What every chapter's user can choose, and the way from a lesson to a picture on disk.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "command_line.hpp"
#include "draw.hpp"
#include "sphere_forms.hpp"
#include "stopwatch.hpp"

namespace texmap {

/// The numbers that a user may choose for a lesson.
enum class Offered {
  all,     ///< every Number
  single,  ///< float, double and extended: one number at a time, so no instructions for packs either
};

/// What every chapter lets the user choose, and the way from a lesson to a file.
class Studio {
 public:
  /// Adds the options that all chapters have to `line`, which must live as long as the studio.
  ///
  /// @param chapter  its folder's name, such as 02_checkerboard_uv; the picture's default name comes from it
  /// @param numbers  what the lesson can be drawn with
  Studio(std::string_view chapter, CommandLine& line, Offered numbers = Offered::all);

  std::string out;   ///< where the picture goes
  int width = 800;   ///< pixels
  int height = 600;  ///< pixels
  int samples = 1;   ///< rays a pixel
  int threads = 0;   ///< 0: all cores
  Number number = default_number;
  Instructions instructions = widest_instructions();  ///< what packs are made of
  SphereForm spheres = SphereForm::robust;            ///< for all spheres of the lesson
  bool quiet = false;                                 ///< no progress and no line on success

  /// Adds the option --spheres, for lessons that have a list of objects.
  void offer_forms();
  /// True when the user gave this option.
  [[nodiscard]] bool typed(std::string_view option) const { return line_.typed(option); }
  /// Another size for users who did not choose one; for pictures that have a shape of their own.
  void prefer_size(int columns, int rows);
  /// Another number of samples for users who did not choose one.
  void prefer_samples(int count);
  /// After parsing: refuses pictures that are too large, makes the default folder out/, and checks that the picture can be
  /// written, before anything long begins.
  void check() const;

  /// The lesson's picture.
  template <class Lesson>
  [[nodiscard]] Image draw(const Lesson& lesson) {
    return draw(lesson, width, height);
  }
  /// The lesson's picture in another size.
  template <class Lesson>
  [[nodiscard]] Image draw(const Lesson& lesson, int columns, int rows) {
    return timed(static_cast<double>(columns) * rows * samples, [&](const RenderSettings& settings) {
      return texmap::draw(lesson, view_of(lesson.stage.camera, columns, rows), number, settings);
    });
  }

  /// Writes a picture and prints one line about it: file, size, milliseconds, what they went into, rays a second.
  ///
  /// The milliseconds are the sum of the four in brackets: load is all that comes before the first ray, textures above all, and
  /// counts for the first picture only; render is drawing, to which the rays a second refer; encode makes a PNG file of the
  /// pixels; write lasts until the disk has it.
  /// @param suffix  stands before the file's ending, for chapters that write several pictures
  /// Errors: ImageError; the old file is then untouched.
  void save(const Image& image, std::string_view suffix = "");

  /// The name save() would give.
  [[nodiscard]] std::string file_name(std::string_view suffix) const;

  /// What the progress line says besides how much is done; may be empty. Asked from any thread.
  std::function<std::string()> remark;

  /// What `work` draws with the settings that the user chose; its time and rays are told when the picture is saved.
  [[nodiscard]] Image timed(double rays, const std::function<Image(const RenderSettings&)>& work);

 private:
  void offer_all_numbers();

  std::string default_out_;
  CommandLine& line_;
  std::optional<Stopwatch> before_drawing_{Stopwatch()};  // until the first ray
  double load_ = 0;                                       // milliseconds before the first ray, until they are told
  double render_ = 0;                                     // milliseconds spent drawing since the last save
  double rays_ = 0;                                       // drawn since the last save
};

}  // namespace texmap
