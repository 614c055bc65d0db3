// Letting players in: requests, refusals, and the greeting.
#include <string>
#include <variant>

#include "simulator/actions.h"
#include "simulator/roster.h"
#include "simulator/server/match_server.h"
#include "soccer/protocol/connection_request.h"
#include "soccer/protocol/parameter_message.h"
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
  switch (door) {
    case Door::kGame:
      return admit_at_game_door(datagram);
  }
  return ErrorCode::kUnknownCommand;
}

std::variant<Admission, ErrorCode> MatchServer::admit_at_game_door(std::string_view datagram) {
  soccer::GameRequest request;
  if (const auto error = soccer::parse(datagram, request)) return *error;
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
  if (init.version < soccer::kOldestProtocolVersion ||
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
  if (!is_player(admission.client)) {
    monitors_.attach(admission.client, admission.version, std::move(channel), *world_.rules);
    return;
  }
  const Slot slot = admission.client;
  recorder_.command(world_, slot, request);
  auto& client = sessions_[static_cast<std::size_t>(slot)];
  client = std::make_unique<Session>();
  client->client = slot;
  client->version = admission.version;
  client->channel = std::move(channel);

  const Player& player = world_.player(slot);
  if (admission.reconnected) {
    reply(*client, soccer::ReconnectReply{player.side, world_.mode});
  } else {
    reply(*client, soccer::PlayerInitReply{player.side, player.unum, world_.mode});
  }
  send_parameters(*client);
  if (!admission.reconnected && admission.version >= kFirstSynchronousVersion) {
    execute(*client, soccer::SynchSee{});
  }
}

void MatchServer::send_parameters(Session& client) {
  const auto send = [&](const auto& params) {
    text_.clear();
    soccer::format(params, client.version, text_);
    client.send(text_);
  };
  send(world_.rules->server);
  send(world_.rules->player);
  for (const soccer::PlayerType& type : world_.rules->types) send(type);
  for (const Player& other : world_.players) {
    if (other.type == 0) continue;
    const bool own = other.side == soccer::side_of_slot(client.slot());
    reply(client, soccer::PlayerTypeChange{other.unum,
                                           own ? std::optional<int>(other.type) : std::nullopt});
  }
}

}  // namespace cls::simulator
