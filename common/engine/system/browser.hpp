// Files in a browser: those that the page handed over.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace texmap {

/// Keeps a file under its name, without folders; one of the same name is replaced.
void keep_file(const std::string& name, std::vector<std::uint8_t> bytes);

}  // namespace texmap
