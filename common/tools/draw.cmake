# Runs a chapter's program that may fail. The program has then said why, and the gallery goes on without its picture.
# usage: cmake -P draw.cmake PROGRAM [option ...]
set(words "")
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE 3 ${last})
  list(APPEND words "${CMAKE_ARGV${i}}")
endforeach()
execute_process(COMMAND ${words} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  cmake_path(GET CMAKE_ARGV3 STEM name)
  string(SUBSTRING "${name}" 0 2 number)
  message("${name} has no picture in this gallery: ./course run ${number} tries again")
endif()
