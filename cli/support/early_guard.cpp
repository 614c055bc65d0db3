// Starts the guard; its failure is reported by who needs it.
#include "cli/support/early_guard.h"

#include <utility>

namespace cls::cli {

std::optional<process::Guard> start_early_guard(int argc, char** argv) {
  auto guard = process::Guard::start(argc, argv);
  if (!guard) return std::nullopt;
  return *std::move(guard);
}

}  // namespace cls::cli
