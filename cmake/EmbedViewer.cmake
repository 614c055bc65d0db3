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

# Modules become one script: imports and the word export are left out.
set(program "(() => {'use strict';")
file(STRINGS "${WEB}/modules.txt" modules)
foreach(module IN LISTS modules)
  file(READ "${WEB}/src/${module}" text)
  set(text "\n${text}")
  string(REGEX REPLACE "\nimport [^\n]*" "" text "${text}")
  string(REPLACE "\nexport " "\n" text "${text}")
  string(APPEND program "${text}")
endforeach()
string(APPEND program "})();\n")
file(READ "${WEB}/style.css" style)
foreach(text IN ITEMS "${program}" "${style}")
  string(FIND "${text}" ")embedded\"" found)
  if(NOT found EQUAL -1)
    message(FATAL_ERROR "${WEB}: the text )embedded\" cannot be embedded")
  endif()
endforeach()

file(WRITE "${OUTPUT}" "// Generated from viewer/web.
#include \"viewer/page/viewer_program.h\"

namespace cls::viewer {

std::string_view viewer_script() {
  return R\"embedded(")
file(APPEND "${OUTPUT}" "${program}")
file(APPEND "${OUTPUT}" ")embedded\";
}

std::string_view viewer_style() {
  return R\"embedded(")
file(APPEND "${OUTPUT}" "${style}")
file(APPEND "${OUTPUT}" ")embedded\";
}

}  // namespace cls::viewer
")
