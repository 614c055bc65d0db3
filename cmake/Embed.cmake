# Text files as part of a library.

# cls_embed(<output.cpp> <file...>): generates the definition of cls::orchestration::scenario::shipped_files().
function(cls_embed output)
  set(script "${CMAKE_SOURCE_DIR}/cmake/EmbedFiles.cmake")
  list(JOIN ARGN "|" files)
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DFILES=${files}" -P "${script}"
    DEPENDS ${ARGN} "${script}"
    COMMENT "embedding scenarios"
    VERBATIM)
endfunction()
