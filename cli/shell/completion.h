// Completion of a command line of `cls`: what may stand at the cursor, from the tree of commands.
#pragma once

#include <string>
#include <vector>

#include "cli/command/command.h"

namespace cls::cli {

/// A word that may stand at the cursor. A shell adds no space after one that ends in '=', ':', or
/// '/'.
struct Candidate {
  std::string text;
  std::string note;  ///< what it means; may be empty
};

/// The shell completes names of files itself, after a part of the word that is not a path.
enum class PathKind { kNone, kFiles, kFolders };

struct Completion {
  std::vector<Candidate> candidates;  ///< all begin with the word at the cursor
  PathKind paths = PathKind::kNone;
  std::string path_prefix;  ///< "team:" in "team:../helios", "--dir=" in "--dir=runs"
};

/// Completes the last of `words`, the arguments of `cls` up to the cursor; it may be empty. `root`
/// has all commands. Reads cls.toml for names of teams; an invalid one has none.
Completion complete(const Command& root, const std::vector<std::string>& words);

/// `cls complete -- WORD...`, which completion scripts call: prints one candidate per line,
/// "TEXT<tab>NOTE", and a line ":files<tab>PREFIX" or ":folders<tab>PREFIX" where paths may stand.
/// Returns kOk.
int print_completion(const Command& root, std::vector<std::string> words);

}  // namespace cls::cli
