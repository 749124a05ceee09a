# An optional package that does not work stops nothing: a line says so. Where packs are required it does.
# usage: cmake -D ROOT=project -D CXX=compiler -D OUT=folder -P broken_packages.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${OUT}")
file(WRITE "${OUT}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)\nproject(broken CXX)\n"
  "set(CMAKE_CXX_STANDARD 20)\ninclude(\"${ROOT}/common/packages.cmake\")\n")
file(WRITE "${OUT}/xsimd/config/xsimd_config.hpp" "#define XSIMD_VERSION_MAJOR 99\n#define XSIMD_VERSION_MINOR 5\n")
file(WRITE "${OUT}/xsimd/xsimd.hpp" "#include <xsimd/config/xsimd_config.hpp>\n")
file(WRITE "${OUT}/libdeflate.h" "#define LIBDEFLATE_VERSION_MAJOR 0\n#define LIBDEFLATE_VERSION_MINOR 9\n")
set(without "in [^\n]* does not work here [^\n]* goes on without it: ")
foreach(required OFF ON)
  execute_process(COMMAND "${CMAKE_COMMAND}" -S "${OUT}" -B "${OUT}/build" "-DCMAKE_CXX_COMPILER=${CXX}" "-Dxsimd_INCLUDE_DIR=${OUT}"
    "-Dlibdeflate_INCLUDE_DIR=${OUT}" "-Dlibdeflate_LIBRARY=${OUT}/libdeflate.h" -D TEXMAP_REQUIRE_PACKS=${required}
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT said MATCHES "xsimd 99.5 ${without}packs" OR (required AND NOT status) OR NOT required AND
     (status OR NOT said MATCHES "libdeflate 0.9 ${without}pictures"))
    message(FATAL_ERROR "TEXMAP_REQUIRE_PACKS=${required}: status ${status}\n${said}")
  endif()
endforeach()

# The versions that are known to work are those on the page.
file(READ "${ROOT}/docs/packages.md" page)
file(STRINGS "${ROOT}/common/packages.cmake" lines REGEX "_KNOWN \"")
foreach(line IN LISTS lines)
  string(REGEX REPLACE ".*\"(.*)\".*" "\\1" versions "${line}")
  string(FIND "${page}" "${versions}" found)
  if(found LESS 0)
    message(FATAL_ERROR "docs/packages.md does not name the versions ${versions}")
  endif()
endforeach()
