// What a chapter's main program reads before its lesson; programs for learning read it precompiled.
#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "engine/app/layout_options.hpp"
#include "engine/app/phong_options.hpp"
#include "engine/app/run_chapter.hpp"
#include "engine/app/turntable.hpp"
#include "scene/path.hpp"
#include "scene/stage.hpp"
#include "texture/checkerboard.hpp"
#include "texture/image_texture.hpp"
#include "texture/mapped.hpp"
#include "texture/rotated.hpp"
