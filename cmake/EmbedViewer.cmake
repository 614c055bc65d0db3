# Joins the modules of viewer/web into one script and writes it with the style sheet as C++.
# Used as a function by viewer/CMakeLists.txt, and run as a script with -D OUTPUT -D WEB.
if(NOT CMAKE_SCRIPT_MODE_FILE)
  # cls_embed_viewer(<output.cpp> <folder>): generates the definitions of viewer/page/viewer_program.h.
  function(cls_embed_viewer output web)
    file(GLOB modules CONFIGURE_DEPENDS "${web}/src/*.js")
    set(script "${CMAKE_SOURCE_DIR}/cmake/EmbedViewer.cmake")
    add_custom_command(
      OUTPUT "${output}"
      COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DWEB=${web}" -P "${script}"
      DEPENDS ${modules} "${web}/modules.txt" "${web}/style.css" "${script}"
      COMMENT "embedding the viewer"
      VERBATIM)
  endfunction()
  return()
endif()

cmake_policy(VERSION 3.25)

# The modules of some parts become one script: imports, the word export and lines of comment are left out. The part of a
# module is its second word, without one `page`.
function(join_modules output)
  set(program "(() => {'use strict';")
  file(STRINGS "${WEB}/modules.txt" lines)
  foreach(line IN LISTS lines)
    string(REPLACE " " ";" words "${line}")
    list(POP_FRONT words module part)
    if(NOT part)
      set(part page)
    endif()
    if(NOT part IN_LIST ARGN)
      continue()
    endif()
    file(READ "${WEB}/src/${module}" text)
    set(text "\n${text}")
    string(REGEX REPLACE "\nimport [^\n]*" "" text "${text}")
    string(REPLACE "\nexport " "\n" text "${text}")
    string(REGEX REPLACE "\n *(//|/\\*\\*|\\*( |/))[^\n]*" "" text "${text}")
    string(APPEND program "${text}")
  endforeach()
  set(${output} "${program}})();\n" PARENT_SCOPE)
endfunction()

join_modules(program page)
join_modules(drawings page drawings)
join_modules(debugger page drawings decisions)
join_modules(comparison page drawings comparison)
join_modules(list list)
join_modules(spectators spectators)
file(READ "${WEB}/style.css" style)
foreach(text IN ITEMS "${debugger}" "${comparison}" "${list}" "${spectators}" "${style}")
  string(FIND "${text}" ")embedded\"" found)
  if(NOT found EQUAL -1)
    message(FATAL_ERROR "${WEB}: the text )embedded\" cannot be embedded")
  endif()
endforeach()

file(WRITE "${OUTPUT}" "// Generated from viewer/web.
#include \"viewer/page/viewer_program.h\"

namespace cls::viewer {
")
foreach(entry IN ITEMS viewer_script:program drawings_script:drawings debugger_script:debugger
        comparison_script:comparison list_script:list spectator_script:spectators viewer_style:style)
  string(REPLACE ":" ";" entry "${entry}")
  list(GET entry 0 function)
  list(GET entry 1 text)
  file(APPEND "${OUTPUT}" "
std::string_view ${function}() {
  return R\"embedded(")
  file(APPEND "${OUTPUT}" "${${text}}")
  file(APPEND "${OUTPUT}" ")embedded\";
}
")
endforeach()
file(APPEND "${OUTPUT}" "
}  // namespace cls::viewer
")
