// Replaces descriptor 1.
#include "cli/terminal/json_stdout.h"

#include <fcntl.h>
#include <unistd.h>

#include <cassert>
#include <cstdio>
#include <string>

namespace cls::cli {

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
  std::string rest = std::string(line) + "\n";
  while (!rest.empty()) {
    const ssize_t written = write(stdout_, rest.data(), rest.size());
    if (written <= 0) return;  // the reader has left
    rest.erase(0, static_cast<std::size_t>(written));
  }
}

}  // namespace cls::cli
