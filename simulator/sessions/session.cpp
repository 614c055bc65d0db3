// Parses and stores received datagrams.
#include "simulator/sessions/session.h"

#include <algorithm>
#include <variant>

namespace cls::simulator {
namespace {

template <typename Command>
bool is_done_or_bye(const Command& command) {
  return std::holds_alternative<soccer::Done>(command) ||
         std::holds_alternative<soccer::Bye>(command);
}

}  // namespace

bool PlayerInbox::add(std::string_view text, bool null_terminated) {
  if (count_ == datagrams_.size()) datagrams_.emplace_back().text.reserve(kTextCapacity);
  Datagram& datagram = datagrams_[count_++];
  datagram.text = text;
  datagram.null_terminated = null_terminated;
  datagram.first = commands_.size();
  datagram.complete = !soccer::parse_player_commands(text, commands_).has_value();
  datagram.last = commands_.size();
  return std::any_of(commands_.begin() + static_cast<std::ptrdiff_t>(datagram.first),
                     commands_.end(), is_done_or_bye<soccer::PlayerCommand>);
}

void PlayerInbox::clear() {
  count_ = 0;
  commands_.clear();
}

bool CoachInbox::add(std::string_view text, bool null_terminated, soccer::CoachRole role) {
  Datagram& datagram = datagrams_.emplace_back();
  datagram.text = text;
  datagram.null_terminated = null_terminated;
  datagram.error = soccer::parse(text, role, datagram.command);
  return !datagram.error && is_done_or_bye(datagram.command);
}

}  // namespace cls::simulator
