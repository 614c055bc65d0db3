# Files as part of a library.

# Splits "cls::match::files" into `namespace` and `name` of the caller.
function(cls_split_function text)
  string(REGEX MATCH "^(.*)::([^:]+)$" found "${text}")
  set(namespace "${CMAKE_MATCH_1}" PARENT_SCOPE)
  set(name "${CMAKE_MATCH_2}" PARENT_SCOPE)
endfunction()

# cls_embed(<output.cpp> FUNCTION <namespaced name> TYPE <struct> HEADER <header> BASE <folder>
#   FILES <file...>)
# Generates the definition of `const std::vector<TYPE>& FUNCTION()`, which HEADER declares: name,
# relative to BASE, and text of each file.
function(cls_embed output)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FUNCTION;TYPE;HEADER;BASE" "FILES")
  cls_split_function("${arg_FUNCTION}")
  set(script "${CMAKE_SOURCE_DIR}/cmake/EmbedFiles.cmake")
  list(JOIN arg_FILES "|" files)
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DNAMESPACE=${namespace}" "-DNAME=${name}"
            "-DTYPE=${arg_TYPE}" "-DHEADER=${arg_HEADER}" "-DBASE=${arg_BASE}" "-DFILES=${files}"
            -P "${script}"
    DEPENDS ${arg_FILES} "${script}"
    COMMENT "embedding ${arg_BASE}"
    VERBATIM)
endfunction()

# cls_embed_bytes(<output.cpp> FUNCTION <namespaced name> HEADER <header> FILE <file>)
# Generates the definition of `std::string_view FUNCTION()`, which HEADER declares: the bytes of the
# file.
function(cls_embed_bytes output)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FUNCTION;HEADER;FILE" "")
  cls_split_function("${arg_FUNCTION}")
  set(script "${CMAKE_SOURCE_DIR}/cmake/EmbedBytes.cmake")
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DNAMESPACE=${namespace}" "-DNAME=${name}"
            "-DHEADER=${arg_HEADER}" "-DFILE=${arg_FILE}" -P "${script}"
    DEPENDS "${arg_FILE}" "${script}"
    COMMENT "embedding ${arg_FILE}"
    VERBATIM)
endfunction()
