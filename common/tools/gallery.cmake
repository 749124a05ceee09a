# Writes out/index.html where the book cannot be made (no cmark-gfm): each chapter's picture with the title and the text of its README.
# usage: cmake -DCHAPTERS=... -DFOLDER=chapters -DGALLERY=out -P gallery.cmake

cmake_minimum_required(VERSION 3.25)
set(figures "")
foreach(chapter IN LISTS CHAPTERS)
  # A README begins with "# title", then the idea in one line, then ![alternative text](picture).
  file(READ "${FOLDER}/${chapter}/README.md" text)
  string(REGEX MATCH "\n!\\[([^]\n]+)\\]" picture "${text}")
  set(alt "${CMAKE_MATCH_1}")
  if(NOT picture OR NOT text MATCHES "^# ([^\n]+)\n\n([^\n]+)\n")
    message(FATAL_ERROR "${FOLDER}/${chapter}/README.md must begin with a title, the idea in one line, and a picture with a text")
  endif()
  string(APPEND figures "<figure id=\"${chapter}\"><img src=\"${chapter}.png\" alt=\"${alt}\">
<figcaption><b>${CMAKE_MATCH_1}</b>: ${CMAKE_MATCH_2}</figcaption></figure>\n")
endforeach()
file(COPY "${CMAKE_CURRENT_LIST_DIR}/book/book.css" "${CMAKE_CURRENT_LIST_DIR}/book/favicon.svg" DESTINATION "${GALLERY}")
file(WRITE "${GALLERY}/index.html.new" "<!doctype html>
<html lang=\"en\">
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">
<title>Texture Mapping, Step by Step</title>
<link rel=\"icon\" href=\"favicon.svg\">
<link rel=\"stylesheet\" href=\"book.css\">
<main>
<h1>Texture Mapping, Step by Step</h1>
${figures}</main>
</html>\n")
file(RENAME "${GALLERY}/index.html.new" "${GALLERY}/index.html")
list(LENGTH CHAPTERS count)
message(STATUS "${count} chapters are in ${GALLERY}/index.html")
