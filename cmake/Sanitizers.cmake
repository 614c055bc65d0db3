# One switch for instrumented builds; the presets asan and tsan set it.
set(CLS_SANITIZE "" CACHE STRING "sanitizers for the whole build, e.g. address,undefined or thread")

if(CLS_SANITIZE)
  add_compile_options(-fsanitize=${CLS_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${CLS_SANITIZE})
  # GCC sees uninitialised values that are none in instrumented library headers.
  add_compile_options(-Wno-maybe-uninitialized)
endif()
