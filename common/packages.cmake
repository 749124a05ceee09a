# What the project borrows from the system's packages. Every missing header is noted, so that all can
# be named at once before anything compiles.

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

# Optional packages. One that is there may be too old, too new, damaged or another machine's: CMake
# compiles and links what the course uses of it, or says in a line that the course goes on without.
option(TEXMAP_REQUIRE_PACKS "Without xsimd stop (for continuous integration)" OFF)
include(CheckCXXSourceCompiles)

# try_package(NAME HEADER WITHOUT [options]): the target NAME if NAME_USED compiles; NAME_OPTIONS are
# `options` if it does with them, too. WITHOUT: what the course else loses. Tried again when a byte of
# NAME_FILES or NAME_LIBRARIES has changed.
function(try_package name header without)
  find_path(${name}_INCLUDE_DIR ${header})
  mark_as_advanced(${name}_INCLUDE_DIR)
  set(folder "${${name}_INCLUDE_DIR}")
  set(libraries ${${name}_LIBRARIES})
  set(trouble "no ${name}: ${without} (${${name}_INSTALL})")
  set(works OFF)
  if(folder AND NOT "${libraries}" MATCHES NOTFOUND)
    list(TRANSFORM ${name}_FILES PREPEND "${folder}/" OUTPUT_VARIABLE files)
    file(GLOB files LIST_DIRECTORIES OFF ${files} ${libraries})
    set(tried "${${name}_USED} ${folder} ${libraries} ${CMAKE_CXX_FLAGS}")
    set(version "of an unknown version")
    foreach(file IN LISTS files)
      file(MD5 "${file}" sum)
      string(APPEND tried " ${sum}")
      file(STRINGS "${file}" lines REGEX "^#define [A-Z]+_(VERSION_M(AJ|IN)OR|GFM_VERSION_STRING) ?")
      if(lines)
        string(REGEX MATCHALL "[0-9][0-9a-z.]*" numbers "${lines}")
        list(JOIN numbers "." version)
      endif()
    endforeach()
    set(CMAKE_REQUIRED_INCLUDES "${folder}")
    set(CMAKE_REQUIRED_LIBRARIES ${libraries})
    set(CMAKE_REQUIRED_QUIET ON)
    set(trouble "")
    foreach(options IN LISTS ARGN ITEMS "")
      string(MD5 key "${tried} ${options}")
      set(CMAKE_REQUIRED_FLAGS "${options}")
      check_cxx_source_compiles("${${name}_USED}" ${name}_WORKS_${key})
      set(works ${${name}_WORKS_${key}})
      if(works)
        set(${name}_OPTIONS "${options}" PARENT_SCOPE)
        break()
      endif()
      string(REGEX REPLACE ".+" " with \\0" with "${options}")
      set(trouble "${name} ${version} in ${folder} does not work here${with} (${${name}_KNOWN} do), the \
course goes on without it: ${without}")
    endforeach()
  endif()
  if(trouble AND TEXMAP_REQUIRE_PACKS AND name STREQUAL "xsimd")
    message(FATAL_ERROR " TEXMAP_REQUIRE_PACKS forbids: ${trouble}")  # the blank keeps it one line
  elseif(trouble)
    message(STATUS "${trouble}")
  endif()
  if(works)
    add_library(${name} INTERFACE)
    target_include_directories(${name} SYSTEM INTERFACE "${folder}")
    target_link_libraries(${name} INTERFACE ${libraries})
    string(TOUPPER "TEXMAP_HAVE_${name}" have)
    string(MAKE_C_IDENTIFIER "${have}" have)
    target_compile_definitions(${name} INTERFACE ${have})
  endif()
endfunction()

# Packs of numbers: without xsimd a fallback compiles everywhere (number/kinds/batch.hpp). Vectors of
# 32-bit ARM do not round as single numbers do. What compiles with the widest instructions compiles
# without them, and is tried once.
set(xsimd_KNOWN "8.1 to 14.3")
set(xsimd_INSTALL "Debian libxsimd-dev, Fedora xsimd-devel, else xsimd")
set(xsimd_FILES xsimd/*.hpp xsimd/*/*.hpp xsimd/*/*/*.hpp)
set(xsimd_USED [[
  #include <bit>
  #include <xsimd/xsimd.hpp>
  #if XSIMD_VERSION_MAJOR < 8 || defined(XSIMD_NO_SUPPORTED_ARCHITECTURE) || defined(__arm__)
  #error
  #endif
  template <class Arch, class T> T use(T* at) {
    using Batch = xsimd::batch<T, Arch>;
    const Batch a = Batch::load_aligned(at), b = Batch(T(2)) * Batch::load_unaligned(at) / a - a + a;
    const xsimd::batch_bool<T, Arch> mask = (a < b || a >= b) && !(a == b || a <= b || a > b);
    const Batch c = xsimd::select(mask, xsimd::sqrt(a), xsimd::floor(xsimd::abs(a)));
    ((a & b) | (c ^ ~b)).store_unaligned(at);
    return xsimd::any(mask) ? Batch(std::bit_cast<typename Batch::register_type>(b)).get(0) : T(0);
  }
  int main() {
  #ifdef __AVX512F__
    use<xsimd::sse2, float>(nullptr), use<xsimd::sse2, double>(nullptr);
    use<xsimd::avx2, float>(nullptr), use<xsimd::avx2, double>(nullptr);
  #endif
    use<xsimd::default_arch, float>(nullptr), use<xsimd::default_arch, double>(nullptr);
  }]])
if(TAKES_GNU_OPTIONS AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT TEXMAP_INSTRUMENT AND
   NOT CMAKE_CXX_FLAGS MATCHES "-m(arch|avx)")
  set(wide_options "-mavx512f -mavx512cd -mavx512dq -mavx512bw")
endif()
try_package(xsimd xsimd/xsimd.hpp "packs of numbers are slow" ${wide_options})

# PNG files are packed and unpacked by libdeflate, else by stb. The static library comes first:
# programs then run where it is not installed.
set(libdeflate_KNOWN "1.14 to 1.25")
set(libdeflate_INSTALL "Debian libdeflate-dev, Fedora libdeflate-devel, else libdeflate")
set(libdeflate_FILES libdeflate.h)
set(libdeflate_USED [[
  #include <libdeflate.h>
  int main() {
    size_t made = libdeflate_crc32(0, "", 1) + libdeflate_adler32(1, "", 1);
    libdeflate_compressor* const packs = libdeflate_alloc_compressor(11);
    made += libdeflate_zlib_compress(packs, "", 1, &made, libdeflate_zlib_compress_bound(packs, 1));
    libdeflate_decompressor* const unpacks = libdeflate_alloc_decompressor();
    libdeflate_free_compressor(packs), libdeflate_free_decompressor(unpacks);
    return libdeflate_deflate_decompress(unpacks, "", 1, &made, 1, &made) == LIBDEFLATE_SUCCESS;
  }]])
find_library(libdeflate_LIBRARY NAMES libdeflate.a deflate deflatestatic libdeflate)
set(libdeflate_LIBRARIES "${libdeflate_LIBRARY}")
try_package(libdeflate libdeflate.h "pictures load and are saved more slowly, and are larger")

# The book's pages are turned from Markdown into HTML by cmark-gfm.
set(cmark-gfm_KNOWN "0.29.0.gfm.6 to gfm.13")
set(cmark-gfm_INSTALL "Debian libcmark-gfm-dev libcmark-gfm-extensions-dev")
set(cmark-gfm_FILES cmark-gfm*.h)
set(cmark-gfm_USED [[
  #include <cmark-gfm-core-extensions.h>
  #include <cmark-gfm.h>
  int main() {
    cmark_gfm_core_extensions_ensure_registered();
    cmark_parser* const parser = cmark_parser_new(CMARK_OPT_UNSAFE);
    cmark_parser_attach_syntax_extension(parser, cmark_find_syntax_extension("table"));
    return cmark_node_replace(cmark_parser_finish(parser), cmark_node_new(CMARK_NODE_HTML_BLOCK));
  }]])
find_library(CMARK_LIBRARY cmark-gfm)
find_library(CMARK_EXTENSIONS_LIBRARY cmark-gfm-extensions)
mark_as_advanced(libdeflate_LIBRARY CMARK_LIBRARY CMARK_EXTENSIONS_LIBRARY)
set(cmark-gfm_LIBRARIES "${CMARK_EXTENSIONS_LIBRARY}" "${CMARK_LIBRARY}")
try_package(cmark-gfm cmark-gfm-core-extensions.h "out/index.html shows pictures without the pages")
