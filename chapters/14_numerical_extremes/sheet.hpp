// The sheet: each exhibit in float and double, with the published formulas and with the course's,
// and the table of what went wrong.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "exhibit.hpp"

namespace texmap {
class CommandLine;
class Session;
}  // namespace texmap

namespace texmap::chapter_14 {

/// The options that choose one exhibit and how it is drawn; the sheet shows all of them.
struct ExhibitOptions {
  std::string name;  ///< empty: the sheet
  Formulas formulas = Formulas::robust;
  NumberKind number = NumberKind::double_;
  int samples = 1;

  void declare(CommandLine& line);
  /// Hands number, samples and size on to the session.
  /// Errors: UsageError for options that mean nothing on the sheet.
  void apply_to(Session& session) const;
};

/// How far one picture is from the reference.
struct Mistakes {
  int wrong = 0;            ///< pixels of another color, by more than one level of 255
  int missed = 0;           ///< pixels where only one of the two sees a surface
  Judge texels = Judge(0);  ///< the largest distance between the places on a texture of 8192 x 4096
};

/// The sheet and its figures.
struct Sheet {
  Image picture;
  std::string table;
  std::vector<std::array<Mistakes, reference>> mistakes;  ///< of each exhibit, in their order
};

/// Draws every exhibit in all variants, on a sheet as large as the session's picture.
[[nodiscard]] Sheet draw_sheet(const std::vector<Exhibit>& exhibits, Session& session);

/// The picture of the exhibit of that name.
/// Errors: UsageError that lists all names if there is none.
[[nodiscard]] Image draw_exhibit(const std::vector<Exhibit>& exhibits, const std::string& name,
                                 Formulas formulas, Session& session);

/// Draws and saves what the user asked for: one exhibit, or the sheet with its table.
void show_exhibits(const std::vector<Exhibit>& exhibits, const ExhibitOptions& options,
                   Session& session);

}  // namespace texmap::chapter_14
