// Where the documentation explains an end reason.
#pragma once

#include <string>

#include "soccer/end_reason.h"

namespace cls::cli {

/// "see `cls explain stalled`"; empty for a match that finished.
std::string troubleshooting_hint(soccer::EndReason reason);

}  // namespace cls::cli
