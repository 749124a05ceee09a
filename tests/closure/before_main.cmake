# No work before main: none of the files has a function that runs when the program starts.
# usage: cmake -D NM=nm -D FILES=a;b -P before_main.cmake
cmake_minimum_required(VERSION 3.25)
set(symbols "")
foreach(file IN LISTS FILES)
  execute_process(COMMAND "${NM}" -C "${file}" OUTPUT_VARIABLE found RESULT_VARIABLE status ERROR_QUIET)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "cannot list the symbols of ${file}")
  endif()
  string(APPEND symbols "${found}")
  if(found MATCHES "_GLOBAL__sub_I[^\n]*|__cxx_global_var_init[^\n]*")
    # The blank in front keeps CMake from breaking the line where the path happens to be long.
    message(FATAL_ERROR " ${file} works before main: ${CMAKE_MATCH_0}")
  endif()
endforeach()
if(NOT symbols MATCHES "texmap::")
  message(FATAL_ERROR "no symbols of the course: this check would prove nothing")
endif()
message("nothing works before main")
