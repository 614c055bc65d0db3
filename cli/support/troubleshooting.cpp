// Where the documentation explains an end reason.
#include "cli/support/troubleshooting.h"

#include <fmt/format.h>

namespace cls::cli {

using soccer::EndReason;

std::string troubleshooting_hint(EndReason reason) {
  if (reason == EndReason::kFinished) return {};
  // Not the page: a program without a checkout beside it has no docs/.
  const std::string entry = fmt::format("see `cls explain {}`", name(reason));
  return reason == EndReason::kRefused ? entry + "; `cls doctor` checks the host" : entry;
}

}  // namespace cls::cli
