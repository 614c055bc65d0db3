# Run at every build: writes what `git describe` prints, if that has changed.
cmake_minimum_required(VERSION 3.22)
execute_process(
  COMMAND git -C "${SOURCE}" describe --always --tags
  OUTPUT_VARIABLE version
  OUTPUT_STRIP_TRAILING_WHITESPACE
  ERROR_QUIET)
file(CONFIGURE OUTPUT "${HEADER}"
  CONTENT "#pragma once\n#define CLS_GIT_VERSION \"${version}\"\n")
