# The libraries of a build for browsers and Node (`make playground`), in place of Dependencies.cmake.
# Libraries of templates come from this host. protobuf and zlib are compiled from the source packages
# that playground/build unpacks in CLS_SOURCE_PACKAGES: protobuf in the version of this host's protoc,
# which generates code for it.
set(CLS_SOURCE_PACKAGES "${CMAKE_BINARY_DIR}/sources" CACHE PATH "folder of unpacked source packages")
set(CLS_MATH portable)
enable_language(C)  # of zlib

# Exceptions of WebAssembly itself: those that the compiler emulates by JavaScript cost each call.
add_compile_options(-fwasm-exceptions)
add_link_options(-fwasm-exceptions)

# cls_host_headers(<target> <package> <header> <folder>): the folder /usr/include/FOLDER of a library
# of headers. The rest of /usr/include is of another machine.
function(cls_host_headers target package header folder)
  find_path(found_${folder} "${header}" PATHS /usr/include NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
  if(NOT found_${folder})
    message(FATAL_ERROR "${header} not found: install ${package} (./bootstrap deps does it)")
  endif()
  file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/headers")
  file(CREATE_LINK "${found_${folder}}/${folder}" "${CMAKE_BINARY_DIR}/headers/${folder}" SYMBOLIC)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE "${CMAKE_BINARY_DIR}/headers")
endfunction()

cls_host_headers(fmt::fmt libfmt-dev fmt/format.h fmt)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
cls_host_headers(nlohmann_json::nlohmann_json nlohmann-json3-dev nlohmann/json.hpp nlohmann)

# cls_source_package(<variable> <pattern>): the one folder of an unpacked source package.
function(cls_source_package variable pattern)
  file(GLOB found "${CLS_SOURCE_PACKAGES}/${pattern}")
  list(LENGTH found number)
  if(NOT number EQUAL 1)
    message(FATAL_ERROR "${CLS_SOURCE_PACKAGES}: ${number} folders ${pattern}; playground/build makes one")
  endif()
  set(${variable} "${found}" PARENT_SCOPE)
endfunction()

cls_source_package(zlib "zlib-*")
file(GLOB zlib_files "${zlib}/*.c")
list(FILTER zlib_files EXCLUDE REGEX "/gz[^/]*$")
add_library(cls_zlib STATIC ${zlib_files})
target_include_directories(cls_zlib SYSTEM PUBLIC "${zlib}")
target_compile_options(cls_zlib PRIVATE -w)
add_library(ZLIB::ZLIB ALIAS cls_zlib)

# Everything but the compiler of .proto files and tests.
cls_source_package(protobuf "protobuf-*")
file(GLOB protobuf_files "${protobuf}/src/google/protobuf/*.cc" "${protobuf}/src/google/protobuf/io/*.cc"
  "${protobuf}/src/google/protobuf/stubs/*.cc" "${protobuf}/src/google/protobuf/util/*.cc"
  "${protobuf}/src/google/protobuf/util/internal/*.cc")
list(FILTER protobuf_files EXCLUDE REGEX "test|mock|benchmark|lite_arena|_tester|google/protobuf/io/gzip_stream_|map_proto2")
add_library(cls_protobuf STATIC ${protobuf_files})
target_include_directories(cls_protobuf SYSTEM PUBLIC "${protobuf}/src")
target_compile_definitions(cls_protobuf PRIVATE HAVE_ZLIB)
target_compile_options(cls_protobuf PRIVATE -w)
target_link_libraries(cls_protobuf PUBLIC cls_zlib)
add_library(protobuf::libprotobuf ALIAS cls_protobuf)

find_program(CLS_PROTOC protoc NO_CMAKE_FIND_ROOT_PATH)
if(NOT CLS_PROTOC)
  message(FATAL_ERROR "protoc not found: install protobuf-compiler (./bootstrap deps does it)")
endif()
add_executable(protobuf::protoc IMPORTED)
set_target_properties(protobuf::protoc PROPERTIES IMPORTED_LOCATION "${CLS_PROTOC}")

# The standard library of this compiler is older than those of Debian's GCC and Clang. This concerns the
# targets from here on.
add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include ${CMAKE_SOURCE_DIR}/cmake/newer_standard_library.h>")
