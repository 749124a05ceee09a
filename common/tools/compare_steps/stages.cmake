# Writes the source file OUT with ROOM::stages(): the LESSONS whose objects are those of the stage, by what HEADER makes of a lesson.
# usage: cmake -D OUT=... -D ROOM=steps -D HEADER=comparison.hpp "-DLESSONS=...;..." -P stages.cmake
set(includes "")
set(rows "")
foreach(lesson IN LISTS LESSONS)
  file(STRINGS "${lesson}" objects REGEX "^enum ObjectIndex { middle, left, right, ground };")
  if(objects)
    cmake_path(GET lesson PARENT_PATH folder)
    cmake_path(GET folder FILENAME name)
    string(SUBSTRING "${name}" 0 2 number)
    string(APPEND includes "#include \"${name}/lesson.hpp\"\n")
    string(APPEND rows "\n      on_stage<chapter_${number}::Lesson>(\"${name}\"),")
  endif()
endforeach()
file(WRITE "${OUT}" "// Written by stages.cmake.
#include \"${HEADER}\"

${includes}
namespace texmap::${ROOM} {

const std::vector<OnStage>& stages() {
  static const std::vector<OnStage> all{${rows}
  };
  return all;
}

}  // namespace texmap::${ROOM}
")
