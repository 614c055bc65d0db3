// Naming damage.
#include "gamelog/record/damage.h"

#include <utility>

namespace cls::gamelog {

std::string to_text(std::string_view path, const Damage& damage) {
  std::string text(path);
  text += ": ";
  if (damage.line > 0) text += "line " + std::to_string(damage.line) + ", ";
  text += "byte " + std::to_string(damage.byte) + ", cycle " + std::to_string(damage.cycle) + ": ";
  return text + damage.what;
}

void DamageList::add(Damage damage) {
  if (first.size() < kKept) first.push_back(std::move(damage));
  ++count;
}

void DamageList::add_reason(Damage damage) {
  const bool same_place =
      count > 0 && count == first.size() &&
      (first.back().byte == damage.byte || (damage.line > 0 && first.back().line == damage.line));
  if (same_place) {
    first.back().what += ": " + damage.what;
  } else {
    add(std::move(damage));
  }
}

}  // namespace cls::gamelog
