#pragma once
#include "table.hpp"
#include "standard_streams.hpp"
