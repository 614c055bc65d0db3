// Damage, one line a place.
#include "cli/damage_report.h"

#include <fmt/format.h>

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

}  // namespace cls::cli
