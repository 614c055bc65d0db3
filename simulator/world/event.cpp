// Formats referee messages.
#include "simulator/world/event.h"

#include "base/text/number_text.h"

namespace cls::simulator {

void RefereeMessage::append_to(std::string& out) const {
  out += name;
  if (side != Side::kNeutral) {
    out += '_';
    out += letter(side);
  }
  if (number) {
    out += '_';
    base::append_int(*number, out);
  }
}

std::string RefereeMessage::text() const {
  std::string result;
  append_to(result);
  return result;
}

}  // namespace cls::simulator
