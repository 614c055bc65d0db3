// Keeping what a client has sent.
#include "simulator/sessions/session.h"

#include <algorithm>
#include <variant>

namespace cls::simulator {

bool Inbox::add(std::string_view text, bool null_terminated) {
  if (count_ == datagrams_.size()) datagrams_.emplace_back().text.reserve(kUsualSize);
  Datagram& datagram = datagrams_[count_++];
  datagram.text = text;
  datagram.null_terminated = null_terminated;
  datagram.first = commands_.size();
  datagram.complete = !soccer::parse_player_commands(text, commands_).has_value();
  datagram.last = commands_.size();
  return std::any_of(commands_.begin() + static_cast<std::ptrdiff_t>(datagram.first),
                     commands_.end(), [](const auto& command) {
                       return std::holds_alternative<soccer::Done>(command) ||
                              std::holds_alternative<soccer::Bye>(command);
                     });
}

void Inbox::clear() {
  count_ = 0;
  commands_.clear();
}

}  // namespace cls::simulator
