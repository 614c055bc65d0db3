// The referee's words as text.
#include "simulator/event.h"

#include "soccer/protocol/number_text.h"

namespace cls::simulator {

void RefereeSaid::append_to(std::string& out) const {
  out += word;
  if (side != Side::kNeutral) {
    out += '_';
    out += letter(side);
  }
  if (number) {
    out += '_';
    soccer::append_int(*number, out);
  }
}

std::string RefereeSaid::text() const {
  std::string result;
  append_to(result);
  return result;
}

}  // namespace cls::simulator
