// Pictures that a page hands over.
#pragma once
#include <string>

#include "texture/image.hpp"

namespace texmap::live {

/// Keeps a texture under its name, without folders; one of the same name is replaced.
void keep_picture(const std::string& name, Image picture);

}  // namespace texmap::live
