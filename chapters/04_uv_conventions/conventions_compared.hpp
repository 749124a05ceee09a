// The source documents' conventions with their own formulas, and the figures that relate them.
#pragma once
#include <array>
#include <string>

#include "texture/conventions.hpp"

namespace texmap::chapter_04 {

/// How a source document lays (u, v) on a sphere.
struct PublishedMapping {
  const char* title;  ///< as it is drawn on the sheet
  Uv<double> (*formula)(const Vec3<double>&);
  Convention convention;
};

/// The daily exercise, One Weekend 2020, Next Week and the lecture.
extern const std::array<PublishedMapping, 4> published_mappings;

/// The direction at a place of the flat map as seen from outside: north up, east right from -x.
///
/// @param east, north  0 to 1 from the left and from the lower edge
[[nodiscard]] Vec3<double> direction_at(double east, double north);

/// The sign of the Jacobian of (u, up) in (east, north): +1 reads as printed, -1 is mirrored.
/// `up` is v, or -v where v runs down the picture.
[[nodiscard]] int handedness(const PublishedMapping& mapping);

/// A relation between two conventions, and the largest error with which it holds.
struct Relation {
  std::string text;
  double residual = 0;  ///< in turns for u, in half turns for v
};

/// The exact relations, measured with the published formulas in double on 100,000 directions that
/// are spread evenly over the sphere.
[[nodiscard]] std::array<Relation, 6> measure_relations();

/// The table that the chapter prints.
[[nodiscard]] std::string table_of_relations();

}  // namespace texmap::chapter_04
