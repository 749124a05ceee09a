# Writes the source file OUT with ROOM::stages() or ROOM::variants(), the LESSONS by what HEADER makes of each.
# usage: cmake -D OUT=... -D ROOM=steps -D LIST=stages -D HEADER=comparison.hpp "-DLESSONS=...;..." -P stages.cmake
# Lists: stages, whose objects are those of the stage; single_stages, those of them that draw it alone; variants, all others.
set(includes "")
set(rows "")
set(function stages)
set(make on_stage)
if(LIST STREQUAL variants)
  set(function variants)
  set(make in_colors)
endif()
foreach(lesson IN LISTS LESSONS)
  cmake_path(GET lesson PARENT_PATH folder)
  cmake_path(GET folder FILENAME name)
  string(SUBSTRING "${name}" 0 2 number)
  file(STRINGS "${lesson}" objects REGEX "^enum ObjectIndex { middle, left, right, ground };")
  file(STRINGS "${lesson}" sheets REGEX "^  void draw_all")
  set(list single_stages)
  if(NOT objects OR sheets)
    set(list variants)
  endif()
  if(LIST STREQUAL list OR (LIST STREQUAL stages AND objects))
    string(APPEND includes "#include \"${name}/lesson.hpp\"\n")
    string(APPEND rows "\n      ${make}<chapter_${number}::Lesson>(\"${name}\"),")
  endif()
endforeach()
file(WRITE "${OUT}" "// Written by stages.cmake.
#include \"${HEADER}\"

${includes}
namespace texmap::${ROOM} {

const std::vector<OnStage>& ${function}() {
  static const std::vector<OnStage> all{${rows}
  };
  return all;
}

}  // namespace texmap::${ROOM}
")
