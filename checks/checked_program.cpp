// Programs started by a check.
#include "checks/checked_program.h"

namespace cls::checks {

std::string describe_exit(const std::string& what, const process::Child& child) {
  const process::Child::Status status = child.status();
  if (!process::has_ended(status)) return {};
  std::string account = what + " exited";
  if (status.exit) account += " (" + to_text(*status.exit) + ")";
  const auto lines = child.last_lines(1);
  if (!lines.empty()) account += "; last output line: " + lines.front();
  return account;
}

}  // namespace cls::checks
