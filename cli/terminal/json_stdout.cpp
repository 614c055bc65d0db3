// Formats documents; replaces descriptor 1.
#include "cli/terminal/json_stdout.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cassert>
#include <cstdio>
#include <string>

#include "base/io/standard_streams.h"
#include "base/text/json_text.h"
#include "cli/terminal/exit_code.h"

namespace cls::cli {

int print_json(const base::Json& document) {
  fmt::print("{}", base::json_document(document));
  return kOk;
}

JsonStdout::JsonStdout(bool active) {
  if (!active) return;
  std::fflush(stdout);
  stdout_ = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  if (stdout_ >= 0) dup2(STDERR_FILENO, STDOUT_FILENO);
}

JsonStdout::~JsonStdout() {
  if (!active()) return;
  std::fflush(stdout);
  dup2(stdout_, STDOUT_FILENO);
  close(stdout_);
}

void JsonStdout::print_line(std::string_view line) const {
  assert(active());
  base::write_to_duplicate(stdout_, base::StandardStream::kOutput, std::string(line) + "\n");
}

}  // namespace cls::cli
