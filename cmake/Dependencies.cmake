# All libraries. All are Debian 12 packages: nothing is downloaded at configure time.

# cls_need(<package> <debian package> <find_package arguments...>): a missing one is one clear line.
macro(cls_need package debian)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "${package} not found: install ${debian} (./bootstrap deps does it)")
  endif()
endmacro()

set(THREADS_PREFER_PTHREAD_FLAG ON)
cls_need(Threads libc6-dev)
cls_need(Protobuf libprotobuf-dev MODULE)
cls_need(gRPC libgrpc++-dev CONFIG)
cls_need(CLI11 libcli11-dev CONFIG)
cls_need(fmt libfmt-dev CONFIG)
cls_need(nlohmann_json nlohmann-json3-dev CONFIG)
cls_need(tomlplusplus libtomlplusplus-dev CONFIG)
cls_need(SQLiteCpp libsqlitecpp-dev CONFIG)
cls_need(ZLIB zlib1g-dev)
cls_need(LibLZMA liblzma-dev)
cls_need(zstd libzstd-dev CONFIG)
cls_need(OpenSSL libssl-dev)
cls_need(Boost libboost-dev 1.74 CONFIG)
if(BUILD_TESTING)
  cls_need(GTest libgmock-dev CONFIG)
endif()
if(CLS_BUILD_BENCH)
  cls_need(benchmark libbenchmark-dev CONFIG)
endif()

# Which functions soccer/math.cpp calls: both have the same bits.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(default_math sleef)
else()
  set(default_math portable)
endif()
set(CLS_MATH ${default_math} CACHE STRING "transcendental functions: sleef (x86-64 only) or portable")
if(NOT CLS_MATH MATCHES "^(sleef|portable)$")
  message(FATAL_ERROR "CLS_MATH: '${CLS_MATH}' is not sleef or portable")
endif()

# SLEEF brings a pkg-config file only.
if(CLS_MATH STREQUAL "sleef")
  find_path(CLS_SLEEF_INCLUDE sleef.h)
  find_library(CLS_SLEEF_LIBRARY sleef)
  if(NOT CLS_SLEEF_INCLUDE OR NOT CLS_SLEEF_LIBRARY)
    message(FATAL_ERROR "sleef not found: install libsleef-dev (./bootstrap deps does it), or take "
      "-DCLS_MATH=portable")
  endif()
  add_library(sleef::sleef UNKNOWN IMPORTED)
  set_target_properties(sleef::sleef PROPERTIES
    IMPORTED_LOCATION "${CLS_SLEEF_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${CLS_SLEEF_INCLUDE}")
endif()
