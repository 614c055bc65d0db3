// Where the documentation explains an end reason.
#include "cli/support/troubleshooting.h"

#include <fmt/format.h>

namespace cls::cli {

using orchestration::match::EndReason;

std::string troubleshooting_hint(EndReason reason) {
  if (reason == EndReason::kFinished) return {};
  // The anchors of the page are the names of result.json.
  const std::string page = fmt::format("see docs/troubleshooting.md#{}", name(reason));
  return reason == EndReason::kRefused ? page + "; `cls doctor` checks the host" : page;
}

}  // namespace cls::cli
