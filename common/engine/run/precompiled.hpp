// What a chapter's main program reads before its lesson; programs for learning read it precompiled.
#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "engine/run/layout_options.hpp"
#include "engine/run/phong_options.hpp"
#include "engine/run/run_chapter.hpp"
#include "engine/run/sky_options.hpp"
#include "engine/run/turntable.hpp"
#include "scene/path.hpp"
#include "scene/stage.hpp"
#include "texture/checkerboard.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"
#include "texture/rotated.hpp"

namespace texmap {

// Compiled once: chapter 12's paths (sky_options.cpp) and random numbers (sample_random.cpp).
extern template Color<double> light_under_sky(const std::vector<PreparedObject<double, Coat>>&,
                                              Ray<double>, const SkyLight&, const MatteLight&, int,
                                              SampleRandom<double>&);
extern template const Point2<double>& RandomBlock<double>::make(int, int);

}  // namespace texmap
