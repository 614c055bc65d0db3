// The rules of the house that a compiler does not check, each a pure function over source files.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/architecture/source_text.h"

namespace cls::tests {

/// A broken rule: where, and what to do instead.
struct Violation {
  std::string path;
  int line;  ///< from 1; 0 for the whole file
  std::string message;
};

/// "path:line: message", one a line.
std::string to_text(const std::vector<Violation>& violations);

/// Folders that may hold C++ at all. A new folder must first get its arrows.
const std::set<std::string>& known_folders();

/// The folders whose files `folder` may include, itself among them.
const std::set<std::string>& allowed_folders(const std::string& folder);

/// The first part of a path: "simulator/server/udp.cpp" lies in "simulator".
std::string folder_of(const std::string& path);

/// Includes of ours point down, and are written from the root of the repository.
std::vector<Violation> check_arrows(const SourceFile& file);

/// Libraries and system headers that a folder must do without.
std::vector<Violation> check_foreign_headers(const SourceFile& file);

/// Calls that would make a match depend on the processor, the library or the clock, or a test on
/// what else runs.
std::vector<Violation> check_determinism(const SourceFile& file);

/// One line of purpose first; no file over 800 lines, no function over 60, main under 60; nothing
/// put off.
std::vector<Violation> check_shape(const SourceFile& file);

/// Boost.Process is wrapped once: in one file, in orchestration.
std::vector<Violation> check_process_wrapper(const std::vector<SourceFile>& files);

}  // namespace cls::tests
