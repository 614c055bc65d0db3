// Architecture rules that the compiler does not check, as pure functions over source files.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/architecture/source_text.h"

namespace cls::tests {

/// A violation of a rule: place and hint.
struct Violation {
  std::string path;
  int line;  ///< from 1; 0 for the whole file
  std::string message;
};

/// One "path:line: message" per line.
std::string to_text(const std::vector<Violation>& violations);

/// Folders with C++ code, one library each: "soccer", "match". New folders must be
/// added to the table in rules.cpp.
const std::set<std::string>& known_libraries();

/// The libraries whose files `library` may include, including itself.
std::set<std::string> allowed_libraries(const std::string& library);

/// The library of a path: "simulator" for "simulator/server/udp.cpp"; empty if there is none.
std::string library_of(const std::string& path);

/// Includes of this project refer to lower libraries and, within a library, to lower layers. Paths
/// are relative to the root of the repository.
std::vector<Violation> check_includes(const SourceFile& file);

/// No folder includes third-party or system headers that are forbidden for it.
std::vector<Violation> check_forbidden_headers(const SourceFile& file);

/// No calls that make a match depend on CPU, C library or clock, or a test on other running tests.
std::vector<Violation> check_determinism(const SourceFile& file);

/// Files begin with a comment on their purpose; files have at most 800 lines, functions 60,
/// main.cpp less than 60; no to-do comments.
std::vector<Violation> check_shape(const SourceFile& file);

/// Only one file, in process, includes Boost.Process.
std::vector<Violation> check_process_wrapper(const std::vector<SourceFile>& files);

}  // namespace cls::tests
