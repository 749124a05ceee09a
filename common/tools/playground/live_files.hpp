// Files that a page hands over.
#pragma once
#include <string>

namespace texmap::live {

/// Decodes this picture again when it is asked for next.
void forget_picture(const std::string& name);

}  // namespace texmap::live
