# Switches for instrumented builds; the presets asan, tsan and fuzz set them.
option(CLS_FUZZ "build the fuzzers in tests/fuzz (clang only)" OFF)
set(CLS_SANITIZE "" CACHE STRING "sanitizers for the whole build, e.g. address,undefined or thread")

if(CLS_SANITIZE)
  # -O1 compiles faster, and stack traces stay readable.
  add_compile_options(
    -O1 -fsanitize=${CLS_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${CLS_SANITIZE})
  # Indices and iterators of the standard library are checked, too.
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  # GCC sees uninitialized values that are none in instrumented library headers, and warns of the
  # fences in Boost.Asio's, which thread sanitizer does not follow.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-Wno-maybe-uninitialized -Wno-tsan)
  endif()
  # Clang's check of dynamic types asks the kernel about memory through a pipe: in a process without
  # free descriptors it reports objects that are sound.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CLS_SANITIZE MATCHES undefined)
    add_compile_options(-fno-sanitize=vptr)
  endif()
  # Seeing this macro, protobuf's headers give maps two more members than Debian's library knows.
  if(CLS_SANITIZE MATCHES thread)
    add_compile_options(-U__SANITIZE_THREAD__)
  endif()
endif()
