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

/// Folders that may hold C++, each with a library of its own: "soccer", "orchestration/match". A
/// new one must first get its place in the table.
const std::set<std::string>& known_rooms();

/// The rooms whose files `room` may include, itself among them.
std::set<std::string> allowed_rooms(const std::string& room);

/// The room of a path: "simulator" for "simulator/server/udp.cpp"; empty: in none.
std::string room_of(const std::string& path);

/// Includes of this project point to lower rooms and, within a room, to lower layers; they are
/// written from the root of the repository.
std::vector<Violation> check_arrows(const SourceFile& file);

/// Libraries and system headers that a folder must do without.
std::vector<Violation> check_foreign_headers(const SourceFile& file);

/// Calls that would make a match depend on the processor, the library or the clock, or a test on
/// what else runs.
std::vector<Violation> check_determinism(const SourceFile& file);

/// One line of purpose first; no file over 800 lines, no function over 60, main under 60; nothing
/// put off.
std::vector<Violation> check_shape(const SourceFile& file);

/// Boost.Process is wrapped once: in one file, in orchestration/process.
std::vector<Violation> check_process_wrapper(const std::vector<SourceFile>& files);

}  // namespace cls::tests
