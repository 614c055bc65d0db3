// Damage, one line a place.
#include "cli/support/damage_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/support/exit_code.h"

namespace cls::cli {
namespace {

constexpr std::size_t kShown = 5;

}  // namespace

void report_damage(std::string_view path, const gamelog::DamageList& damage) {
  const std::size_t shown = std::min(damage.first.size(), kShown);
  for (std::size_t i = 0; i < shown; ++i) {
    fmt::print(stderr, "cls: {}\n", gamelog::to_text(path, damage.first[i]));
  }
  if (damage.count > shown) {
    fmt::print(stderr, "cls: {}: {} more damaged places\n", path, damage.count - shown);
  }
}

int report_missing(const gamelog::FoundLogs& found) {
  for (const std::string& missing : found.missing) {
    fmt::print(stderr, "cls: no log '{}'\n", missing);
  }
  return found.missing.empty() ? kDone : kNoInput;
}

int report_log(int exit_code, const std::string& unreadable, std::string_view path,
               const gamelog::DamageList& damage) {
  if (!unreadable.empty()) {
    fmt::print(stderr, "cls: {}\n", unreadable);
    exit_code = kNoInput;
  }
  report_damage(path, damage);
  return !damage.empty() && exit_code == kDone ? kBadData : exit_code;
}

}  // namespace cls::cli
