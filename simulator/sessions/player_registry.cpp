// Admits players and sends them messages and senses.
#include "simulator/sessions/player_registry.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/index.h"
#include "simulator/senses/body_sense.h"
#include "simulator/senses/exact_view.h"
#include "simulator/world/roster.h"
#include "soccer/messages/sense_body.h"
#include "soccer/messages/values.h"

namespace cls::simulator {
namespace {

using soccer::ErrorCode;

// Initial capacity, so that a cycle does not allocate.
constexpr std::size_t kMessageCapacity = 8192;  // bytes

/// Sent to players that have not declared the version of the coach language that is needed.
constexpr const char* kUnsupportedClang = "(unsupported_clang)";

const std::string& fixed_name(const soccer::ServerParams& params, Side side) {
  return side == Side::kLeft ? params.fixed_teamname_l : params.fixed_teamname_r;
}

// The first name becomes the left team, the next other name the right team. The assignment is
// permanent, even if the request is refused afterwards.
std::optional<Side> assign_side(World& world, std::string_view name) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (world.team(side).name.empty()) name_team(world, side, name);
    if (has_name(world, Side::kNeutral, side, name)) return side;
  }
  return std::nullopt;
}

// A side has one name: its own, or the one of its first client.
bool accepts_name(World& world, Side side, std::string_view name, const ClientRights& rights) {
  if (!rights.team_name.empty()) {
    if (world.team(side).name.empty()) name_team(world, side, rights.team_name.view());
    return true;
  }
  if (world.team(side).name.empty()) name_team(world, side, name);
  return has_name(world, side, side, name);
}

// Replaces the names of teams by those that the player uses.
void use_own_names(const World& world, Slot slot, const soccer::TeamName& own_name,
                   soccer::See& see) {
  const Side own = world.player(slot).side;
  const soccer::TeamName ours = visible_team_name(world, own, own);
  const soccer::TeamName theirs = visible_team_name(world, own, opponent(own), own_name);
  for (auto& object : see.objects) {
    if (object.team.empty()) continue;
    object.team = object.team == ours ? own_name : theirs;
  }
}

}  // namespace

PlayerRegistry::PlayerRegistry(const soccer::ServerParams& params) : vision_(params) {
  see_.objects.reserve(soccer::kMaxObservations);
  text_.reserve(kMessageCapacity);
  heard_.reserve(soccer::kPlayersOnPitch);
}

AdmissionResult PlayerRegistry::admit(World& world, const soccer::PlayerInit& init,
                                      const ClientRights& rights) {
  if (!rights.left && !rights.right) return Intrusion{};
  const std::string_view name = init.team.view();
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (!name.empty() && name == fixed_name(world.params(), side)) {
      return ErrorCode::kConflictWithFixedTeamName;
    }
  }
  const Side own = rights.only_side();
  if (own != Side::kNeutral && !accepts_name(world, own, name, rights)) return Intrusion{};
  const std::optional<Side> side =
      own == Side::kNeutral ? assign_side(world, name) : std::optional<Side>(own);
  if (!side) return ErrorCode::kNoMoreTeam;
  if (!is_supported_version(init.version)) {
    return ErrorCode::kNoMorePlayerOrGoalieOrIllegalVersion;
  }

  const int version = static_cast<int>(init.version);
  const std::optional<Slot> slot = join(world, *side, init.goalie, version);
  if (!slot) return ErrorCode::kNoMorePlayerOrGoalieOrIllegalVersion;

  Admission admission{*slot, version, false};
  if (!has_name(world, *side, *side, name)) admission.own_name = init.team;
  return admission;
}

AdmissionResult PlayerRegistry::admit(World& world, const soccer::PlayerReconnect& request,
                                      const ClientRights& rights) {
  const Side own = rights.only_side();
  const Side named = rights.team_name.empty() ? find_side(world, request.team, own) : own;
  if (named != Side::kNeutral && !rights.may_play_for(named)) {
    return Intrusion{ErrorCode::kNoSuchTeamOrPlayer};
  }

  if (world.mode == PlayMode::kPlayOn) return ErrorCode::kCannotReconnectWhilePlayOn;
  const std::optional<Slot> slot = find_player(world, named, request.unum);
  if (!slot) return ErrorCode::kNoSuchTeamOrPlayer;
  Player& player = world.player(*slot);
  if (player.has(state::kRedCard)) return ErrorCode::kRedCardedPlayer;

  rejoin(world, *slot);
  player.ears.complete = {true, true};
  player.ears.partial = {false, false};
  player.attention = kNoPlayer;

  Admission admission{*slot, player.client_version, true};
  if (!has_name(world, named, named, request.team)) {
    admission.own_name = soccer::TeamName(request.team);
  }
  return admission;
}

PlayerSession& PlayerRegistry::connect(const World& world, const Admission& admission,
                                       std::unique_ptr<soccer::Channel> channel) {
  auto& session = sessions_[base::index(admission.client)];
  session = std::make_unique<PlayerSession>();
  session->open(admission, std::move(channel));

  const Player& player = world.player(admission.client);
  if (admission.reconnected) {
    session->reply(soccer::ReconnectReply{player.side, world.mode});
  } else {
    session->reply(soccer::PlayerInitReply{player.side, player.unum, world.mode});
  }

  send_parameters(world, *session);
  send_changed_types(world, player.side, *session);

  return *session;
}

int PlayerRegistry::connected() const {
  return static_cast<int>(
      std::ranges::count_if(sessions_, [](const auto& session) { return session != nullptr; }));
}

void PlayerRegistry::disconnect_all() {
  for (auto& session : sessions_) session.reset();
}

void PlayerRegistry::remove_lost(World& world) {
  for (auto& session : sessions_) {
    if (session == nullptr || !session->lost) continue;

    Player& player = world.player(session->slot());
    if (player.enabled) leave(world, player.slot());
    player.state &= ~state::kDiscard;  // logged until the connection is closed
    session.reset();
  }
}

void PlayerRegistry::begin_step() {
  for (auto& session : sessions_) {
    if (session != nullptr) session->begin_step();
  }
}

void PlayerRegistry::end_step() {
  ++steps_;
  synchronous_sees_sent_ = false;
}

// A player that was sent off is already disabled, but receives its card before it is disconnected.
void PlayerRegistry::send_referee_message(const World& world, const soccer::Hear& message) {
  text_.clear();
  soccer::format(message, soccer::Recipient::kPlayer, text_);
  for (auto& session : sessions_) {
    if (session == nullptr || session->lost) continue;
    const Player& player = world.player(session->slot());
    if (player.enabled || player.has(state::kRedCard)) session->send(text_);
  }
}

void PlayerRegistry::queue_say(const World& world, const PlayerSaid& said) {
  for (auto& session : sessions_) {
    if (session != nullptr) simulator::queue_say(world, said, session->slot(), session->pending);
  }
}

void PlayerRegistry::send_coach_message(const World& world, const CoachMessage& message) {
  for (auto& session : sessions_) {
    if (session == nullptr || !world.player(session->slot()).enabled) continue;
    if (message.side == Side::kNeutral) {
      session->pending.trainer.push_back(message.say.text);
      continue;
    }
    if (message.side != soccer::side_of_slot(session->slot())) continue;

    const bool understood = understands(clang_versions(session->slot()), message.say.kind);
    text_.clear();
    soccer::format({.time = world.clock.time,
                    .sender = message.side == Side::kLeft ? soccer::Hear::Sender::kOnlineCoachLeft
                                                          : soccer::Hear::Sender::kOnlineCoachRight,
                    .text = understood ? message.say.text : kUnsupportedClang},
                   soccer::Recipient::kPlayer, text_);
    session->send(text_);
  }
}

void PlayerRegistry::send_type_change(const TypeChanged& change) {
  for (auto& session : sessions_) {
    if (session == nullptr) continue;

    soccer::PlayerTypeChange message{change.unum, std::nullopt};
    if (soccer::side_of_slot(session->slot()) == change.side) message.type = change.type;
    session->reply(message);
  }
}

void PlayerRegistry::send_goalie_change(const GoalieAppointed& change) {
  for (auto& session : sessions_) {
    if (session == nullptr || session->version < kFirstGoalieChangeVersion) continue;
    session->reply(soccer::PlayerTypeChange{change.unum, std::nullopt, change.side});
  }
}

void PlayerRegistry::send_think(const World& world) {
  text_.clear();
  soccer::format(soccer::ServerReply(soccer::Think{}), text_);
  for (auto& session : sessions_) {
    if (session == nullptr || !session->sensed || !world.player(session->slot()).enabled) continue;
    session->send(text_);
    session->think_sent = true;
  }
}

void PlayerRegistry::send_senses(World& world) {
  for (auto& session : sessions_) {
    if (session == nullptr || !world.player(session->slot()).enabled) continue;

    Player& player = world.player(session->slot());
    send_sense_body(world, *session);
    player.contacts = {};
    if (has_full_state(world, player)) send_full_state(world, *session);
    send_heard(world, *session);
    session->sensed = true;
  }
}

void PlayerRegistry::send_sense_body(const World& world, PlayerSession& player) {
  text_.clear();
  soccer::SenseBody sense = sense_body(world, player.slot());
  if (player.channel->peer_reads_values() && make_as_sent(sense, player.version)) {
    soccer::write_values(sense, text_);
  } else {
    soccer::format(sense, player.version, text_);
  }
  player.send(text_);
}

void PlayerRegistry::send_full_state(const World& world, PlayerSession& player) {
  full_state(world, player.slot(), full_state_);
  text_.clear();
  soccer::format(full_state_, player.version, text_);
  player.send(text_);
}

void PlayerRegistry::send_heard(World& world, PlayerSession& player) {
  if (player.pending.says.empty() && player.pending.trainer.empty()) return;

  RandomStream choice = clock_stream(world, "hear", player.slot());
  heard_.clear();
  hear(world, player.slot(), player.pending, choice, heard_);
  for (const soccer::Hear& message : heard_) {
    text_.clear();
    soccer::format(message, soccer::Recipient::kPlayer, text_);
    player.send(text_);
  }
}

void PlayerRegistry::send_see(const World& world, PlayerSession& player) {
  RandomStream noise = clock_stream(world, "see", player.slot());
  see(vision_, world, player.slot(), noise, see_);
  if (!player.own_name.empty()) use_own_names(world, player.slot(), player.own_name, see_);

  text_.clear();
  if (player.channel->peer_reads_values() && make_as_sent(see_)) {
    soccer::write_values(see_, text_);
  } else {
    soccer::format(see_, text_);
  }
  player.send(text_);
}

void PlayerRegistry::send_due_sees(const World& world, int ms) {
  run_asynchronous_rounds(world, ms);
  if (synchronous_sees_sent_ || ms < world.params().synch_see_offset) return;
  run_view_round(world, true);
  synchronous_sees_sent_ = true;
}

void PlayerRegistry::run_view_round(const World& world, bool synchronous) {
  for (auto& session : sessions_) {
    if (session == nullptr) continue;

    const Player& player = world.player(session->slot());
    if (!player.enabled || player.view.synchronous != synchronous) continue;
    if (++session->view_rounds < view_interval(player.view)) continue;
    session->view_rounds = 0;
    send_see(world, *session);
  }
}

// A round is due every quarter of send_step in match time, which need not be whole milliseconds.
void PlayerRegistry::run_asynchronous_rounds(const World& world, int until_ms) {
  const std::int64_t now = steps_ * world.params().simulator_step + until_ms;
  const std::int64_t due = now * 4 / world.params().send_step;
  for (; asynchronous_rounds_ < due; ++asynchronous_rounds_) run_view_round(world, false);
}

}  // namespace cls::simulator
