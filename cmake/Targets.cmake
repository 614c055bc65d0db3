# Two functions that keep the CMakeLists.txt of the folders plain lists.

option(CLS_UNITY "compile several sources as one where a library allows it" OFF)

# cls_library(<target> SOURCES <files...> LINK <targets...> [PCH <name>] [COLD [HOT <files...>]]
#   [UNITY [ALONE <files...>]] [NATIVE <regular expressions...>])
# The static library of a folder. LINK states what the folder may include (and libraries that its
# headers or sources use). PCH names precompiled headers (cmake/PrecompiledHeaders.cmake). COLD code,
# in which no match spends its time, is optimized less, but for its files that are HOT: there the
# optimizer takes a third of the time of a build. UNITY and ALONE: see cls_unity(). NATIVE are files
# that need sockets, threads, gRPC or what else browsers lack, or that nothing there needs: a build for
# WebAssembly leaves them out, and the libraries that it does not have.
function(cls_library target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "COLD;UNITY" "PCH"
    "SOURCES;LINK;ALONE;HOT;NATIVE")
  if(EMSCRIPTEN)
    cls_without_native()
  endif()
  add_library(${target} STATIC ${arg_SOURCES})
  target_include_directories(${target} PUBLIC "${CMAKE_SOURCE_DIR}")
  target_link_libraries(${target} PUBLIC ${arg_LINK} PRIVATE cls_warnings)
  if(arg_PCH)
    target_precompile_headers(${target} REUSE_FROM cls_pch_${arg_PCH})
  endif()
  if(arg_COLD)
    cls_cold(${target})
    set_source_files_properties(${arg_HOT} PROPERTIES
      COMPILE_OPTIONS "$<$<CONFIG:RelWithDebInfo,Release>:-O2>")
  endif()
  if(arg_UNITY)
    cls_unity(${target} ${arg_ALONE})
  endif()
endfunction()

macro(cls_without_native)
  foreach(pattern IN LISTS arg_NATIVE)
    list(FILTER arg_SOURCES EXCLUDE REGEX "${pattern}")
  endforeach()
  foreach(library IN LISTS arg_LINK)
    if(NOT TARGET ${library})
      list(REMOVE_ITEM arg_LINK ${library})
    endif()
  endforeach()
endmacro()

# Compiles the sources in batches, because most time goes into headers and templates that they share:
# half of it for libraries and tests alike. Files that are ALONE repeat names of others in their
# anonymous namespaces. After a change in one file -DCLS_UNITY=OFF is faster.
function(cls_unity target)
  if(CLS_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

function(cls_cold target)
  target_compile_options(${target} PRIVATE "$<$<CONFIG:RelWithDebInfo,Release>:-O1>")
endfunction()

# Tests are compiled more often than they run, and what they call is optimized. Files that are HOT work
# in their own code for long. Sanitizers add to each variable of a frame: without optimization the
# recursion of std::regex leaves the stack.
function(cls_unoptimized target)
  if(NOT CLS_SANITIZE)
    target_compile_options(${target} PRIVATE "$<$<CONFIG:RelWithDebInfo,Release>:-O0>")
  endif()
endfunction()

# cls_test(<folder> SOURCES <files...> [LINK <targets...>] [NEEDS <targets...>] [TIMEOUT <seconds>]
#   [PCH <name>] [SHARDS <number> | SLOW] [ALONE <files...>] [HOT <files...> | OPTIMIZED])
# One GoogleTest binary for tests/<folder>, `cls_<folder>_tests`, linked with the folder's library.
# NEEDS lists what must be built although it is not linked (the binary `cls`). In CTest each test is
# an entry <folder>.<Suite>.<Case> with the label <folder>; where no process is tested, SHARDS entries
# run all of them instead: starting a binary costs more than such a test, and test-results/ has their
# names and times. SLOW tests have the label <folder>.slow: `make test` leaves them to `make
# slow-test`. OPTIMIZED is for tests that work in their own code alone. Paths: see
# tests/support/files.h.
function(cls_test folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SLOW;OPTIMIZED" "TIMEOUT;PCH;SHARDS" "SOURCES;LINK;NEEDS;ALONE;HOT")
  if(NOT arg_SOURCES)
    return()
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 120)
    if(arg_SHARDS)
      set(arg_TIMEOUT 900)
    endif()
  endif()
  string(REGEX REPLACE "[-/]" "_" name ${folder})
  set(target cls_${name}_tests)
  add_executable(${target} ${arg_SOURCES})
  if(TARGET cls_${name})
    target_link_libraries(${target} PRIVATE cls_${name})
  endif()
  target_link_libraries(${target} PRIVATE
    ${arg_LINK} cls_test_support GTest::gmock GTest::gtest_main cls_warnings)
  cls_unity(${target} ${arg_ALONE})
  if(NOT arg_OPTIMIZED)
    cls_unoptimized(${target})
    if(NOT arg_PCH)
      set(arg_PCH tests)
    endif()
    target_precompile_headers(${target} REUSE_FROM cls_pch_${arg_PCH})
  endif()
  # Precompiled headers belong to one level of optimization.
  set_source_files_properties(${arg_HOT} PROPERTIES
    COMPILE_OPTIONS "$<$<CONFIG:RelWithDebInfo,Release>:-O2>"
    SKIP_PRECOMPILE_HEADERS ON)
  target_compile_definitions(${target} PRIVATE CLS_BUILD_DIR="${CMAKE_BINARY_DIR}")
  set(label ${folder})
  if(arg_SLOW)
    string(APPEND label ".slow")
  endif()
  if(arg_NEEDS)
    add_dependencies(${target} ${arg_NEEDS})
  endif()
  # Two properties: gtest_discover_tests passes only the first element of a list.
  set(properties
    LABELS "${label}"
    TIMEOUT ${arg_TIMEOUT}
    ENVIRONMENT "TSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/cmake/tsan.supp"
    ENVIRONMENT_MODIFICATION
      "LSAN_OPTIONS=set:suppressions=${CMAKE_SOURCE_DIR}/cmake/lsan.supp:print_suppressions=0")
  if(arg_SHARDS)
    cls_test_shards(${folder} ${target} ${arg_SHARDS} ${properties})
  else()
    gtest_discover_tests(${target}
      TEST_PREFIX "${folder}."
      DISCOVERY_TIMEOUT 60
      WORKING_DIRECTORY "${CMAKE_BINARY_DIR}"
      PROPERTIES ${properties})
  endif()
endfunction()

# Entries <folder>.1 to <folder>.<number>, each with every <number>-th test of the binary.
function(cls_test_shards folder target number)
  math(EXPR last "${number} - 1")
  foreach(index RANGE ${last})
    math(EXPR shown "${index} + 1")
    set(name "${folder}.${shown}")
    add_test(NAME ${name}
      COMMAND ${target} --gtest_brief=1 "--gtest_output=xml:test-results/${name}.xml"
      WORKING_DIRECTORY "${CMAKE_BINARY_DIR}")
    set_tests_properties(${name} PROPERTIES ${ARGN})
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT
      "GTEST_TOTAL_SHARDS=${number}" "GTEST_SHARD_INDEX=${index}")
  endforeach()
endfunction()
