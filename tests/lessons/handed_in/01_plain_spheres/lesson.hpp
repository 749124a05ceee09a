// Chapter 01 in plain `if` and double: the example of docs/how_to_change_things.md, handed in.
#pragma once
#include "changes/plain.hpp"

namespace texmap {
namespace chapter_01 = change_plain;
}
