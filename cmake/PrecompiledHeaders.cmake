# Precompiled headers: one per family of folders, so that each large library header is parsed once.
# -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without them, as the preset `lint` does: clang-tidy
# then finds missing includes.

# cls_pch(<name> LINK <targets...> HEADERS <headers...>)
# Precompiles the headers as target cls_pch_<name>; a cls_library() or cls_test() takes it by
# `PCH <name>`. LINK brings the include folders and definitions of the headers' libraries.
function(cls_pch name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LINK;HEADERS")
  set(source "${CMAKE_BINARY_DIR}/pch/${name}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "// Carries the precompiled headers '${name}'.\n")
  add_library(cls_pch_${name} STATIC "${source}")
  target_include_directories(cls_pch_${name} PUBLIC "${CMAKE_SOURCE_DIR}")
  target_link_libraries(cls_pch_${name} PUBLIC ${arg_LINK} PRIVATE cls_warnings)
  target_precompile_headers(cls_pch_${name} PRIVATE ${arg_HEADERS})
endfunction()

set(standard_headers
  <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <filesystem> <functional> <map> <memory>
  <mutex> <optional> <set> <string> <string_view> <thread> <utility> <variant> <vector>
  <fmt/format.h>)

# A large header costs every file of its family about half a second, even one that does not use it
# (measured with GCC 12). So only the family whose files include it has one.
cls_pch(standard LINK fmt::fmt HEADERS ${standard_headers})
cls_pch(wire LINK fmt::fmt cls_proto_generated
  HEADERS ${standard_headers} <proto/playmaker.pb.h>)
if(BUILD_TESTING)
  cls_pch(tests LINK fmt::fmt GTest::gtest HEADERS ${standard_headers} <gtest/gtest.h>)
  cls_pch(json_tests LINK fmt::fmt GTest::gtest nlohmann_json::nlohmann_json
    HEADERS ${standard_headers} <gtest/gtest.h> <nlohmann/json.hpp>)
  cls_pch(wire_tests LINK fmt::fmt GTest::gtest cls_proto_generated
    HEADERS ${standard_headers} <gtest/gtest.h> <proto/playmaker.pb.h>)
  foreach(name tests json_tests wire_tests)
    cls_unoptimized(cls_pch_${name})
  endforeach()
endif()
