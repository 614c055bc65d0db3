# C++ from .proto files, with Debian's protoc and gRPC plugin, at build time.

# cls_proto_library(<target> SERVICES <file.proto...> MESSAGES <file.proto...>)
# Files are named relative to the repository root, and so are the headers that code includes:
# proto/playmaker.proto gives "proto/playmaker.pb.h" and "proto/playmaker.grpc.pb.h". Those of
# MESSAGES have no service, and so no header of gRPC. WebAssembly has no gRPC.
function(cls_proto_library target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SERVICES;MESSAGES")
  set(out "${CMAKE_BINARY_DIR}/generated")
  file(MAKE_DIRECTORY "${out}")
  set(generated)
  foreach(file IN LISTS arg_SERVICES arg_MESSAGES)
    string(REGEX REPLACE "\\.proto$" "" stem "${file}")
    set(outputs "${out}/${stem}.pb.cc" "${out}/${stem}.pb.h")
    set(grpc)
    if(file IN_LIST arg_SERVICES AND NOT EMSCRIPTEN)
      list(APPEND outputs "${out}/${stem}.grpc.pb.cc" "${out}/${stem}.grpc.pb.h")
      set(grpc "--grpc_out=${out}"
               "--plugin=protoc-gen-grpc=$<TARGET_FILE:gRPC::grpc_cpp_plugin>")
    endif()
    add_custom_command(
      OUTPUT ${outputs}
      COMMAND protobuf::protoc "--proto_path=${CMAKE_SOURCE_DIR}" "--cpp_out=${out}" ${grpc}
              "${CMAKE_SOURCE_DIR}/${file}"
      DEPENDS "${CMAKE_SOURCE_DIR}/${file}"
      COMMENT "protoc ${file}"
      VERBATIM)
    list(APPEND generated ${outputs})
  endforeach()
  add_library(${target} STATIC ${generated})
  target_include_directories(${target} SYSTEM PUBLIC "${out}")
  if(NOT EMSCRIPTEN)
    target_link_libraries(${target} PUBLIC gRPC::grpc++)
  endif()
  target_link_libraries(${target} PUBLIC protobuf::libprotobuf)
  # Not ours, and half of a sanitized build's time. It also reads and writes buffers that gRPC hands
  # from thread to thread behind locks that thread sanitizer does not see: false alarms.
  if(CLS_SANITIZE)
    target_compile_options(${target} PRIVATE -fno-sanitize=all)
  endif()
endfunction()
