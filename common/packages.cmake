# What the project borrows from the system's packages. Every missing header is noted, so that all can be named at once before
# anything compiles.

# borrow(NAME HEADER [folder]): the target NAME for a header.
function(borrow name header)
  find_path(${name}_INCLUDE_DIR ${header} PATH_SUFFIXES ${ARGN})
  mark_as_advanced(${name}_INCLUDE_DIR)
  add_library(${name} INTERFACE)
  if(${name}_INCLUDE_DIR)
    target_include_directories(${name} SYSTEM INTERFACE "${${name}_INCLUDE_DIR}")
  else()
    set_property(GLOBAL APPEND PROPERTY MISSING_HEADERS ${header})
  endif()
endfunction()

borrow(stb_image stb_image.h stb)
if(NOT EMSCRIPTEN)
  borrow(stb_image_write stb_image_write.h stb)
  borrow(doctest doctest.h doctest)
endif()

get_property(missing GLOBAL PROPERTY MISSING_HEADERS)
if(missing)
  list(JOIN missing ", " missing)
  message(FATAL_ERROR "Missing: ${missing}. Install them and configure again:\n"
    "  Debian, Ubuntu   apt-get install libstb-dev doctest-dev\n"
    "  Fedora           dnf install stb_image-devel stb_image_write-devel doctest-devel\n"
    "  Arch             pacman -S stb doctest\n"
    "  vcpkg            set VCPKG_ROOT to its folder; then cmake --preset vcpkg installs them for this project\n"
    "  Homebrew         brew install doctest          (it has no stb: git clone https://github.com/nothings/stb ../stb\n"
    "                   and set the environment variable CMAKE_INCLUDE_PATH to that folder)")
endif()

# Packs of numbers: with xsimd they are fast, without it a fallback compiles everywhere (number/kinds/batch.hpp).
# Its file being there is not enough: it has to know the machine, and to round as single numbers do, which 32-bit ARM's vectors do not.
find_path(xsimd_INCLUDE_DIR xsimd/xsimd.hpp)
mark_as_advanced(xsimd_INCLUDE_DIR)
if(xsimd_INCLUDE_DIR)
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_INCLUDES "${xsimd_INCLUDE_DIR}")
  check_cxx_source_compiles("
    #include <xsimd/config/xsimd_config.hpp>  // all of it takes half a second
    #if XSIMD_VERSION_MAJOR < 8 || defined(XSIMD_NO_SUPPORTED_ARCHITECTURE) || defined(__arm__)
    #error
    #endif
    int main() {}" XSIMD_KNOWS_THIS_MACHINE)
  unset(CMAKE_REQUIRED_INCLUDES)
endif()
add_library(packs INTERFACE)
if(xsimd_INCLUDE_DIR AND XSIMD_KNOWS_THIS_MACHINE)
  target_include_directories(packs SYSTEM INTERFACE "${xsimd_INCLUDE_DIR}")
  target_compile_definitions(packs INTERFACE TEXMAP_HAVE_XSIMD)
else()
  message(STATUS "no xsimd for this machine: packs of numbers will be slow (Debian libxsimd-dev, Fedora xsimd-devel, Arch, brew, vcpkg xsimd)")
endif()

# PNG files are packed and unpacked by libdeflate; without it by stb, which takes longer and makes larger files. The static library
# comes first: programs then run where it is not installed. Being there is not enough: it may be that of another machine.
if(NOT EMSCRIPTEN)
  find_path(libdeflate_INCLUDE_DIR libdeflate.h)
  find_library(libdeflate_LIBRARY NAMES libdeflate.a deflate deflatestatic libdeflate)
  mark_as_advanced(libdeflate_INCLUDE_DIR libdeflate_LIBRARY)
endif()
if(libdeflate_INCLUDE_DIR AND libdeflate_LIBRARY)
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_INCLUDES "${libdeflate_INCLUDE_DIR}")
  set(CMAKE_REQUIRED_LIBRARIES "${libdeflate_LIBRARY}")
  check_cxx_source_compiles("
    #include <libdeflate.h>
    int main() { libdeflate_free_compressor(libdeflate_alloc_compressor(12)); }" LIBDEFLATE_LINKS)
  unset(CMAKE_REQUIRED_INCLUDES)
  unset(CMAKE_REQUIRED_LIBRARIES)
endif()
if(libdeflate_INCLUDE_DIR AND LIBDEFLATE_LINKS)
  add_library(libdeflate INTERFACE)
  target_include_directories(libdeflate SYSTEM INTERFACE "${libdeflate_INCLUDE_DIR}")
  target_link_libraries(libdeflate INTERFACE "${libdeflate_LIBRARY}")
  target_compile_definitions(libdeflate INTERFACE TEXMAP_HAVE_LIBDEFLATE)
elseif(NOT EMSCRIPTEN)
  message(STATUS "no libdeflate: pictures load and are saved more slowly, and are larger (Debian libdeflate-dev, Fedora libdeflate-devel, Arch, brew, vcpkg libdeflate)")
endif()

# The book's pages are turned from Markdown into HTML by cmark-gfm; without it `gallery` writes a page of pictures.
find_path(CMARK_INCLUDE_DIR cmark-gfm-core-extensions.h)
find_library(CMARK_LIBRARY cmark-gfm)
find_library(CMARK_EXTENSIONS_LIBRARY cmark-gfm-extensions)
mark_as_advanced(CMARK_INCLUDE_DIR CMARK_LIBRARY CMARK_EXTENSIONS_LIBRARY)
if(CMARK_INCLUDE_DIR AND CMARK_LIBRARY AND CMARK_EXTENSIONS_LIBRARY)
  add_library(cmark INTERFACE)
  target_include_directories(cmark SYSTEM INTERFACE "${CMARK_INCLUDE_DIR}")
  target_link_libraries(cmark INTERFACE "${CMARK_EXTENSIONS_LIBRARY}" "${CMARK_LIBRARY}")
endif()
