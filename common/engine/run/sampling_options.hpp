// The options of chapters that gather light over many samples.
#pragma once
#include "engine/draw/kinds.hpp"
#include "engine/draw/lesson.hpp"
#include "engine/draw/transfer.hpp"
#include "sampling/sampler_kind.hpp"
#include "scene/lens.hpp"

namespace texmap {

struct Offer;

/// The user's choices of how light is gathered: samples, limits, lens.
struct SamplingOptions {
  SamplerKind sampler = SamplerKind::sobol;
  int samples = 64;  ///< rays per pixel, unless --samples is given
  int seed = 0;
  int bounces = 50;
  double time_limit = 0;    ///< seconds; 0: no limit
  double target_error = 0;  ///< in levels of 255; 0: no limit
  Transfer transfer = Transfer::srgb;
  Lens lens{};

  [[nodiscard]] bool has_limit() const { return time_limit > 0 || target_error > 0; }
  void declare(Offer& offer);
};

/// The base of a lesson that gathers light: its operator() follows one sample's path (gather.hpp).
struct PathLesson : LessonHooks, GathersLight {
  SamplingOptions sampling;
};

}  // namespace texmap
