// The options --degrees and --turntable.
#include "engine/app/turntable.hpp"

#include "engine/app/command_line.hpp"
#include "engine/measure/text.hpp"

namespace texmap {

void Turntable::declare(CommandLine& line) {
  line.decimal("--degrees", degrees, -1e300, 1e300,
               "rotates the globe about its axis by this angle");
  line.whole("--turntable", frames, 0, 9999,
             "draw N pictures of a full turn instead of one, named _000, _001, ...");
  line.wishes.turntable = this;
}

RotationY Turntable::rotation() const {
  return rotation_y(frame == 0 ? degrees : degrees + 360.0 * frame / frames);
}

std::string frame_suffix(int frame) { return text("_%03d", frame); }

}  // namespace texmap
