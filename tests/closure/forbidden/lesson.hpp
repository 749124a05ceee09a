// A lesson with headers that it must not include: the closure check must find them.
#pragma once
#include "engine/kernels/budget.hpp"
#include "scene/stage.hpp"
#include "texture/uv.hpp"
