// Keeping what a coach has sent.
#include "simulator/sessions/coach_session.h"

#include <variant>

namespace cls::simulator {

bool CoachInbox::add(std::string_view text, bool null_terminated, soccer::CoachRole role) {
  Datagram& datagram = datagrams_.emplace_back();
  datagram.text = text;
  datagram.null_terminated = null_terminated;
  datagram.error = soccer::parse(text, role, datagram.command);
  return !datagram.error && (std::holds_alternative<soccer::Done>(datagram.command) ||
                             std::holds_alternative<soccer::Bye>(datagram.command));
}

}  // namespace cls::simulator
