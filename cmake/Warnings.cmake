# Warnings as a target that all libraries link privately; errors in a git checkout and in CI.
if(EXISTS "${CMAKE_SOURCE_DIR}/.git" OR DEFINED ENV{CI})
  set(cls_werror_default ON)
else()
  set(cls_werror_default OFF)
endif()
option(CLS_WERROR "treat compiler warnings as errors" ${cls_werror_default})

add_library(cls_warnings INTERFACE)
target_compile_options(cls_warnings INTERFACE
  -Wall
  -Wextra
  -Wnon-virtual-dtor
  -Woverloaded-virtual
  -Wpedantic
  -Wshadow
  # Files compiled as one repeat the aliases of their anonymous namespaces; the preset lint looks.
  $<$<AND:$<CXX_COMPILER_ID:Clang>,$<BOOL:${CLS_UNITY}>>:-Wno-shadow>
  # GCC 12 reports overruns in std::string that cannot happen (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
  $<$<BOOL:${CLS_WERROR}>:-Werror>)
