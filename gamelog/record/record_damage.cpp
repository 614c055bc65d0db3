// The place of damage in a game log.
#include "gamelog/record/record_damage.h"

#include <utility>

namespace cls::gamelog {

Damage damage_at(const base::InputBuffer& input, const MatchRecord& record, std::string what,
                 std::size_t column) {
  const int cycle = record.time.empty() ? 0 : record.time.back();
  const bool text = record.version >= RcgVersion::kV4;
  return {text ? input.line_number() : 0, input.offset() + column, cycle, std::move(what)};
}

}  // namespace cls::gamelog
