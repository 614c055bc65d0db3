// Selects the commands that need a guard by the first argument, before parsing.
#include "cli/support/early_guard.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace cls::cli {
namespace {

constexpr std::array<std::string_view, 9> kCommands = {
    "match", "tournament", "compare", "tune", "test", "dev", "check", "doctor", "server"};

}  // namespace

bool may_start_programs(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument.starts_with("-")) continue;
    return std::find(kCommands.begin(), kCommands.end(), argument) != kCommands.end();
  }
  return false;
}

std::optional<orchestration::process::Guard> start_early_guard(int argc, char** argv) {
  if (!may_start_programs(argc, argv)) return std::nullopt;
  auto guard = orchestration::process::Guard::start(argc, argv);
  if (!guard) return std::nullopt;
  return *std::move(guard);
}

}  // namespace cls::cli
