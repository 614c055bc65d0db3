// Requests and names.
#include "match/server/relay_gate.h"

#include <variant>

#include "soccer/commands/connection_request.h"
#include "soccer/protocol/loose_scanner.h"
#include "soccer/side.h"

namespace cls::match {
namespace {

using soccer::ErrorCode;

Refusal intrusion(ErrorCode reply) { return {reply, true, true}; }

// Generous: a server may take for a number what soccer::parse() does not.
bool may_connect(std::string_view request) {
  soccer::LooseScanner in(request);
  in.token("(");
  return in.token("init") || in.token("reconnect") || in.token("dispinit");
}

std::optional<Refusal> refusal_of_player(std::string_view request, soccer::Side side,
                                         ClaimedNames& names) {
  soccer::GameRequest parsed;
  if (const auto error = soccer::parse(request, parsed)) {
    return Refusal{*error, false, may_connect(request)};
  }
  if (const auto* init = std::get_if<soccer::PlayerInit>(&parsed)) {
    if (names.claim(side, init->team.view())) return std::nullopt;
    return intrusion(ErrorCode::kNoMoreTeam);
  }
  if (const auto* again = std::get_if<soccer::PlayerReconnect>(&parsed)) {
    if (names.has(side, again->team)) return std::nullopt;
    return intrusion(ErrorCode::kNoSuchTeamOrPlayer);
  }
  return intrusion(ErrorCode::kNoMoreMonitor);
}

std::optional<Refusal> refusal_of_coach(std::string_view request, soccer::Side side,
                                        const ClaimedNames& names) {
  soccer::CoachInit init;
  if (const auto error = soccer::parse(request, init)) {
    return Refusal{*error, false, may_connect(request)};
  }
  if (names.has(side, init.team.view())) return std::nullopt;
  return intrusion(ErrorCode::kNoSuchTeam);
}

}  // namespace

bool ClaimedNames::claim(soccer::Side side, std::string_view name) {
  const std::scoped_lock lock(mutex_);
  if (names_[soccer::opponent(side)].view() == name) {
    collided_[side] = true;
    return false;
  }
  if (names_[side].empty()) names_[side] = soccer::TeamName(name);
  return names_[side].view() == name;
}

bool ClaimedNames::has(soccer::Side side, std::string_view name) const {
  const std::scoped_lock lock(mutex_);
  return !name.empty() && names_[side].view() == name;
}

bool ClaimedNames::collided(soccer::Side side) const {
  const std::scoped_lock lock(mutex_);
  return collided_[side];
}

std::optional<Refusal> refusal_of(RelayedPort port, std::string_view request, soccer::Side side,
                                  ClaimedNames& names) {
  return port == RelayedPort::kPlayers ? refusal_of_player(request, side, names)
                                       : refusal_of_coach(request, side, names);
}

bool gets_own_port(RelayedPort port, std::string_view request) {
  constexpr double kFirstVersion = 8.0;
  if (port == RelayedPort::kCoaches) {
    soccer::CoachInit init;
    return !soccer::parse(request, init) && init.version >= kFirstVersion;
  }
  soccer::GameRequest parsed;
  if (soccer::parse(request, parsed)) return false;
  const auto* init = std::get_if<soccer::PlayerInit>(&parsed);
  return init != nullptr && init->version >= kFirstVersion;
}

}  // namespace cls::match
