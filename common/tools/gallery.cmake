# Writes the gallery, out/index.html: each chapter's picture with the idea it shows, taken from the chapter's README.
# usage: cmake -DCHAPTERS=... -DFOLDER=chapters -DGALLERY=out -P gallery.cmake

cmake_minimum_required(VERSION 3.25)
function(escape_html text out)
  string(REPLACE "&" "&amp;" text "${text}")
  string(REPLACE "<" "&lt;" text "${text}")
  string(REPLACE ">" "&gt;" text "${text}")
  string(REPLACE "\"" "&quot;" text "${text}")
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

set(figures "")
set(before "")
foreach(chapter IN LISTS CHAPTERS)
  # A README begins with "# title", then the idea in one line, then ![alternative text](picture).
  file(STRINGS "${FOLDER}/${chapter}/README.md" lines ENCODING UTF-8)
  set(title "")
  set(idea "")
  set(alt "")
  foreach(line IN LISTS lines)
    if(title STREQUAL "" AND line MATCHES "^# (.*)$")
      set(title "${CMAKE_MATCH_1}")
    elseif(alt STREQUAL "" AND line MATCHES "^!\\[([^]]*)\\]")
      set(alt "${CMAKE_MATCH_1}")
    elseif(idea STREQUAL "" AND NOT title STREQUAL "" AND NOT line STREQUAL "")
      set(idea "${line}")
    endif()
  endforeach()
  if(title STREQUAL "" OR idea STREQUAL "" OR alt STREQUAL "")
    message(FATAL_ERROR "${FOLDER}/${chapter}/README.md must begin with a title, the idea in one line, and a picture with a text")
  endif()
  foreach(part title idea alt)
    escape_html("${${part}}" ${part})
  endforeach()

  set(step "")
  string(SUBSTRING "${chapter}" 0 2 number)
  if(before AND EXISTS "${GALLERY}/diff/${before}-${number}/index.html")
    set(step "<p><a href=\"diff/${before}-${number}/index.html\">What changed from chapter ${before} to chapter ${number}</a></p>")
  endif()
  set(before "${number}")

  file(GLOB frames RELATIVE "${GALLERY}" "${GALLERY}/${chapter}_[0-9][0-9][0-9].png")
  list(SORT frames)
  set(turn "")
  if(frames)
    list(JOIN frames " " frame_list)
    set(turn "<p><button type=\"button\" data-frames=\"${frame_list}\">Turn the globe</button></p>")
  endif()
  # Plots of what the chapter's program measured: NN_name_this_that.svg is linked as "this against that".
  file(GLOB plots RELATIVE "${GALLERY}" "${GALLERY}/${chapter}_*.svg")
  list(SORT plots)
  set(plot_links "")
  foreach(plot IN LISTS plots)
    string(REGEX REPLACE "^${chapter}_(.*)\\.svg$" "\\1" name "${plot}")
    string(REPLACE "_" " against " name "${name}")
    list(APPEND plot_links "<a href=\"${plot}\">${name}</a>")
  endforeach()
  if(plot_links)
    list(JOIN plot_links ", " plot_links)
    set(plot_links "<p>Measured on this machine: ${plot_links}</p>")
  endif()
  string(APPEND figures "
<section id=\"${chapter}\">
<h2>${title}</h2>
<figure>
<a href=\"${chapter}.png\"><img src=\"${chapter}.png\" alt=\"${alt}\" loading=\"lazy\"></a>
<figcaption>${idea}</figcaption>
</figure>
${step}${turn}${plot_links}
</section>")
endforeach()

set(page [=[<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Texture Mapping, Step by Step</title>
<style>
:root { color-scheme: light dark; }
body { font: 1rem/1.5 system-ui, sans-serif; margin: 0 auto; padding: 1rem; max-width: 76rem; background: Canvas; color: CanvasText; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 22rem), 1fr)); gap: 2rem; }
h1 { font-size: 1.7rem; line-height: 1.2; }
h2 { font-size: 1.1rem; margin: 0 0 .5rem; }
figure { margin: 0; }
img { width: 100%; aspect-ratio: 4 / 3; object-fit: contain; background: #8882; display: block; }
figcaption { margin-top: .5rem; }
button { font: inherit; padding: .3rem .9rem; }
a:focus-visible, button:focus-visible { outline: 3px solid Highlight; outline-offset: 2px; }
</style>
</head>
<body>
<h1>Texture Mapping, Step by Step</h1>
<p>Each chapter adds one idea to the chapter before it. A picture opens in full size.</p>
<main>@FIGURES@
</main>
<script>
@TURNTABLE@</script>
</body>
</html>
]=])
string(REPLACE "@FIGURES@" "${figures}" page "${page}")
file(READ "${CMAKE_CURRENT_LIST_DIR}/turntable.js" turntable)
string(REPLACE "@TURNTABLE@" "${turntable}" page "${page}")
file(WRITE "${GALLERY}/index.html.new" "${page}")
file(RENAME "${GALLERY}/index.html.new" "${GALLERY}/index.html")
list(LENGTH CHAPTERS count)
message(STATUS "${count} chapters are in ${GALLERY}/index.html")
