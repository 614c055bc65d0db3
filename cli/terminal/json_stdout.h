// The output of --json: a document, or one line of a command that runs until it is stopped.
#pragma once

#include <string_view>

#include "base/text/json.h"

namespace cls::cli {

/// Prints a document. Returns kOk.
int print_json(const base::Json& document);

/// While it exists and is active, everything printed to stdout goes to stderr, except print_line().
class JsonStdout {
 public:
  explicit JsonStdout(bool active);
  ~JsonStdout();
  JsonStdout(const JsonStdout&) = delete;
  JsonStdout& operator=(const JsonStdout&) = delete;

  bool active() const { return stdout_ >= 0; }

  /// Writes `line` and a line feed to the real stdout. Requires active().
  void print_line(std::string_view line) const;

 private:
  int stdout_ = -1;  ///< descriptor of the real stdout; -1: inactive
};

}  // namespace cls::cli
