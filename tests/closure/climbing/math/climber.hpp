#pragma once
#include "scene/ray.hpp"
