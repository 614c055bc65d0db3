// Exit and last words.
#include "orchestration/checks/ended_program.h"

namespace cls::orchestration::checks {

std::string account_of_end(const std::string& what, const process::Child& child) {
  const process::Child::Status status = child.status();
  if (!process::has_ended(status)) return {};
  std::string account = what + " has ended";
  if (status.exit) account += " (" + to_text(*status.exit) + ")";
  const auto lines = child.last_lines(1);
  if (!lines.empty()) account += "; its last words: " + lines.front();
  return account;
}

}  // namespace cls::orchestration::checks
