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

template <typename Command, typename... Types>
constexpr bool is_one_of(const Command& command) {
  return (std::holds_alternative<Types>(command) || ...);
}

bool needs_no_order(const soccer::PlayerCommand& command) {
  return is_one_of<soccer::PlayerCommand, soccer::Clang, soccer::SynchSee, soccer::GaussianSee,
                   soccer::RequestSenseBody, soccer::RequestScore, soccer::Compression,
                   soccer::Done>(command);
}

bool needs_no_order(const soccer::CoachCommand& command) {
  return is_one_of<soccer::CoachCommand, soccer::Look, soccer::Eye, soccer::TrainerEar,
                   soccer::RequestTeamNames, soccer::CheckBall, soccer::Compression, soccer::Done>(
      command);
}

// Whether all but the newest of `count` datagrams are answered.
template <typename Datagrams>
bool earlier_are_answered(const Datagrams& datagrams, std::size_t count) {
  return count > 0 &&
         std::all_of(datagrams.begin(), datagrams.begin() + static_cast<std::ptrdiff_t>(count - 1),
                     [](const auto& datagram) { return datagram.answered; });
}

}  // namespace

bool PlayerInbox::add(std::string_view text, bool null_terminated) {
  if (count_ == datagrams_.size()) datagrams_.emplace_back().text.reserve(kTextCapacity);
  Datagram& datagram = datagrams_[count_++];
  datagram.text = text;
  datagram.null_terminated = null_terminated;
  datagram.answered = false;
  datagram.first = commands_.size();
  datagram.complete = !soccer::parse_player_commands(text, commands_).has_value();
  datagram.last = commands_.size();
  return std::any_of(commands_.begin() + static_cast<std::ptrdiff_t>(datagram.first),
                     commands_.end(), is_done_or_bye<soccer::PlayerCommand>);
}

PlayerInbox::Datagram* PlayerInbox::answerable() {
  if (!earlier_are_answered(datagrams_, count_)) return nullptr;
  Datagram& newest = datagrams_[count_ - 1];
  const auto begin = commands_.begin();
  const bool answerable =
      std::all_of(begin + static_cast<std::ptrdiff_t>(newest.first),
                  begin + static_cast<std::ptrdiff_t>(newest.last),
                  [](const soccer::PlayerCommand& command) { return needs_no_order(command); });
  return answerable ? &newest : nullptr;
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

CoachInbox::Datagram* CoachInbox::answerable() {
  if (!earlier_are_answered(datagrams_, datagrams_.size())) return nullptr;
  Datagram& newest = datagrams_.back();
  return newest.error || needs_no_order(newest.command) ? &newest : nullptr;
}

}  // namespace cls::simulator
