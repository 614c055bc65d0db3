# What holds for every target: language, build type, floating point, compiler cache, output places.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "kind of build" FORCE)
endif()

# No -DNDEBUG: assertions stay on, they guard results that people will compare.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1")
set(CMAKE_CXX_FLAGS_RELEASE "-O2")

# Same bits on every machine: no fused multiply-add, and never -ffast-math or -march (a test looks).
add_compile_options(-ffp-contract=off)

# Same bytes of a program wherever its source was: assertions and debug information name files
# relative to the root. Debug builds keep whole paths, which debuggers find from any folder.
add_compile_options("$<$<CONFIG:RelWithDebInfo,Release>:-ffile-prefix-map=${CMAKE_SOURCE_DIR}/=>")

# One compilation serves the programs and libcls_training.so. Code of a program stays as fast: hidden
# functions are inlined and called directly, as without -fPIC. WebAssembly has neither shared libraries
# nor, in a page without special headers, threads.
if(NOT EMSCRIPTEN)
  add_compile_options(-fPIC)
endif()
add_compile_options(-fvisibility=hidden -fvisibility-inlines-hidden)

# Everywhere, not only where a library asks for it: precompiled headers want equal flags.
if(NOT EMSCRIPTEN)
  add_compile_options(-pthread)
endif()

# Precompiled headers make every compilation uncacheable unless ccache may trust them; -fpch-preprocess
# (GCC) and -fno-pch-timestamp (Clang) are what its manual demands. The base folder lets another clone
# hit what this one compiled: it makes names of files relative to the build folder, and their prefix is
# taken away again for the same bytes.
find_program(CLS_CCACHE ccache)
if(CLS_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros
    "CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}" "${CLS_CCACHE}")
  file(RELATIVE_PATH source_from_build "${CMAKE_BINARY_DIR}" "${CMAKE_SOURCE_DIR}")
  add_compile_options(
    "$<$<CONFIG:RelWithDebInfo,Release>:-ffile-prefix-map=${source_from_build}=>")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
  elseif(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
  endif()
endif()
