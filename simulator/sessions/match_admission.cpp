// Letting players in: requests, refusals, and the greeting.
#include <string>
#include <variant>

#include "simulator/actions/actions.h"
#include "simulator/sessions/greeting.h"
#include "simulator/sessions/match_server.h"
#include "simulator/world/roster.h"
#include "soccer/commands/connection_request.h"
#include "soccer/protocol/protocol_version.h"

namespace cls::simulator {
namespace {

using soccer::ErrorCode;

constexpr int kFirstSynchronousVersion = 18;

const std::string& fixed_name(const soccer::ServerParams& params, Side side) {
  return side == Side::kLeft ? params.fixed_teamname_l : params.fixed_teamname_r;
}

}  // namespace

std::variant<Admission, ErrorCode> MatchServer::admit(Door door, std::string_view datagram) {
  if (door == Door::kOnlineCoach || door == Door::kOfflineCoach)
    return coaches_.admit(world_, door, datagram);
  soccer::GameRequest request;
  if (const auto error = soccer::parse(datagram, request)) return *error;
  if (door == Door::kMonitors && !std::holds_alternative<soccer::MonitorInit>(request)) {
    return ErrorCode::kUnknownCommand;
  }
  if (const auto* init = std::get_if<soccer::PlayerInit>(&request)) return admit_player(*init);
  if (const auto* again = std::get_if<soccer::PlayerReconnect>(&request)) {
    return readmit_player(*again);
  }
  return admit_monitor(std::get<soccer::MonitorInit>(request));
}

std::variant<Admission, ErrorCode> MatchServer::admit_monitor(const soccer::MonitorInit& init) {
  // Cut to a whole number, as the real server does.
  const bool known = init.version > -2.0 && init.version < 6.0;
  const int version = known ? static_cast<int>(init.version) : 0;
  if (version == 0) return ErrorCode::kIllegalClientVersion;
  const auto seat = monitors_.admit(world_.params().max_monitors);
  if (!seat) return ErrorCode::kNoMoreMonitor;
  return Admission{*seat, version, false,
                   gamelog::is_binary(static_cast<gamelog::MonitorVersion>(version))};
}

std::variant<Admission, ErrorCode> MatchServer::admit_player(const soccer::PlayerInit& init) {
  const std::string_view name = init.team.view();
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (!name.empty() && name == fixed_name(world_.params(), side)) {
      return ErrorCode::kConflictWithFixedTeamName;
    }
  }
  const std::optional<Side> side = side_for(name);
  if (!side) return ErrorCode::kNoMoreTeam;
  if (init.version < soccer::kOldestServedVersion ||
      init.version >= soccer::kNewestProtocolVersion + 1) {
    return ErrorCode::kNoMorePlayerOrGoalieOrIllegalVersion;
  }
  const int version = static_cast<int>(init.version);
  const std::optional<Slot> slot = join(world_, *side, init.goalie, version);
  if (!slot) return ErrorCode::kNoMorePlayerOrGoalieOrIllegalVersion;
  return Admission{*slot, version, false};
}

std::variant<Admission, ErrorCode> MatchServer::readmit_player(
    const soccer::PlayerReconnect& request) {
  if (world_.mode == PlayMode::kPlayOn) return ErrorCode::kCannotReconnectWhilePlayOn;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (request.team != world_.team(side).name.view()) continue;
    if (request.unum < 1 || request.unum > soccer::kPlayersPerTeam) break;
    const Player& player = world_.player(side, request.unum);
    if (!player.joined) break;
    if (player.has(state::kRedCard)) return ErrorCode::kRedCardedPlayer;
    rejoin(world_, player.slot());
    Player& back = world_.player(player.slot());
    back.ears.complete = {true, true};
    back.ears.partial = {false, false};
    back.attention = kNobody;
    return Admission{player.slot(), player.client_version, true};
  }
  return ErrorCode::kNoSuchTeamOrPlayer;
}

// The first name becomes the left team, the next other one the right: taken for good, even if the
// request is refused for another reason afterwards.
std::optional<Side> MatchServer::side_for(std::string_view name) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    Team& team = world_.team(side);
    if (team.name.empty()) team.name = soccer::TeamName(name);
    if (team.name.view() == name) return side;
  }
  return std::nullopt;
}

void MatchServer::withdraw(const Admission& admission) {
  if (is_player(admission.client)) leave(world_, admission.client);
}

void MatchServer::greet(const Admission& admission, std::unique_ptr<soccer::Channel> channel,
                        std::string_view request) {
  if (is_monitor(admission.client)) {
    monitors_.attach(admission.client, admission.version, std::move(channel), *world_.rules);
    return;
  }
  recorder_.command(world_, admission.client, request);
  if (is_player(admission.client)) {
    greet_player(admission, std::move(channel));
  } else {
    greet_coach(admission, std::move(channel));
  }
}

void MatchServer::greet_player(const Admission& admission,
                               std::unique_ptr<soccer::Channel> channel) {
  auto& client = sessions_[static_cast<std::size_t>(admission.client)];
  client = std::make_unique<Session>();
  client->client = admission.client;
  client->version = admission.version;
  client->channel = std::move(channel);

  const Player& player = world_.player(admission.client);
  if (admission.reconnected) {
    client->reply(soccer::ReconnectReply{player.side, world_.mode});
  } else {
    client->reply(soccer::PlayerInitReply{player.side, player.unum, world_.mode});
  }
  send_parameters(world_, *client);
  send_changed_types(world_, player.side, *client);
  if (!admission.reconnected && admission.version >= kFirstSynchronousVersion) {
    execute(*client, soccer::SynchSee{});
  }
}

void MatchServer::greet_coach(const Admission& admission,
                              std::unique_ptr<soccer::Channel> channel) {
  CoachSession& coach = coaches_.connect(world_, admission, std::move(channel));
  if (coach.is_trainer()) return;
  for (const auto& client : sessions_) {
    if (client == nullptr) continue;
    const soccer::Clang& versions = clang_versions_[static_cast<std::size_t>(client->slot())];
    if (versions.min_version != 0 || versions.max_version != 0) tell_coach(coach, client->slot());
  }
  send_coach_file(world_, coach);
}

}  // namespace cls::simulator
