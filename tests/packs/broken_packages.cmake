# An optional package does not work: a line says so, and CMake stops only where packs are required.
# usage: cmake -D ROOT=project -D CXX=compiler -D OUT=folder -P broken_packages.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${OUT}")
file(WRITE "${OUT}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)\nproject(broken CXX)\n"
  "set(CMAKE_CXX_STANDARD 20)\ninclude(\"${ROOT}/common/packages.cmake\")\n")
file(WRITE "${OUT}/xsimd/xsimd.hpp" "#define XSIMD_VERSION_MAJOR 99\n")
file(WRITE "${OUT}/libdeflate.h" "#define LIBDEFLATE_VERSION_MAJOR 5\n")
set(line "in [^\n]* does not work here [^\n]* goes on without it: ")
foreach(required OFF ON)
  execute_process(COMMAND "${CMAKE_COMMAND}" -S "${OUT}" -B "${OUT}/build" "-DCMAKE_CXX_COMPILER=${CXX}"
    "-Dxsimd_INCLUDE_DIR=${OUT}" "-Dlibdeflate_INCLUDE_DIR=${OUT}" "-Dlibdeflate_LIBRARY=${OUT}/none"
    -D TEXMAP_REQUIRE_PACKS=${required} RESULT_VARIABLE stopped OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT said MATCHES "xsimd 99 ${line}packs" OR (required AND NOT stopped) OR
     (NOT required AND (stopped OR NOT said MATCHES "libdeflate 5 ${line}pictures")))
    message(FATAL_ERROR "TEXMAP_REQUIRE_PACKS=${required}: status ${stopped}\n${said}")
  endif()
endforeach()

# The versions that are known to work are those on the page.
file(READ "${ROOT}/docs/packages.md" page)
file(STRINGS "${ROOT}/common/packages.cmake" known REGEX "_KNOWN \"")
list(TRANSFORM known REPLACE ".*\"(.*)\".*" "\\1")
foreach(versions IN LISTS known)
  if(NOT page MATCHES " ${versions} ")
    message(FATAL_ERROR "docs/packages.md does not name the versions ${versions}")
  endif()
endforeach()
