// Admits coaches, executes their commands, and sends them messages and views.
#include "simulator/sessions/coach_registry.h"

#include <utility>
#include <variant>

#include "base/index.h"
#include "simulator/actions/trainer.h"
#include "simulator/referee/substitution.h"
#include "simulator/senses/exact_view.h"
#include "simulator/world/roster.h"
#include "soccer/commands/connection_request.h"
#include "soccer/messages/hear.h"

namespace cls::simulator {
namespace {

using soccer::ErrorCode;
using soccer::reply_of;
using soccer::ServerReply;
using soccer::WarningCode;

bool allows_trainer(const World& world) {
  return world.params().coach || world.params().coach_w_referee;
}

constexpr int kTileColumns = 32;
constexpr int kTileRows = 8;
constexpr std::string_view kTileSize = "8 8 ";  // start of the XPM header

}  // namespace

const CoachSession* CoachRegistry::session(ClientId client) const {
  return sessions_[base::index(client - kLeftCoach)].get();
}

AdmissionResult CoachRegistry::admit(const World& world, ListeningPort port,
                                     std::string_view datagram, const ClientRights& rights) {
  if (port != ListeningPort::kTrainers) return admit_coach(world, datagram, rights);
  if (!rights.trainer) return Intrusion{ErrorCode::kTrainerWithoutCoachMode};
  return admit_trainer(world, datagram);
}

AdmissionResult CoachRegistry::admit_coach(const World& world, std::string_view datagram,
                                           const ClientRights& rights) {
  soccer::CoachInit init;
  if (const auto error = soccer::parse(datagram, init)) return *error;
  const Side side = rights.team_name.empty()
                        ? find_side(world, init.team.view(), rights.only_side())
                        : rights.only_side();
  if (side == Side::kNeutral) return ErrorCode::kNoSuchTeam;
  if (!rights.may_play_for(side)) return Intrusion{ErrorCode::kNoSuchTeam};
  const ClientId client = side == Side::kLeft ? kLeftCoach : kRightCoach;
  if (slot(client) != nullptr) return ErrorCode::kAlreadyHaveCoach;
  if (!is_supported_version(init.version)) return ErrorCode::kIllegalClientVersion;

  names_[index(side)] = std::move(init.coach_name);
  Admission admission{client, static_cast<int>(init.version), false};
  if (!has_name(world, side, side, init.team.view())) admission.own_name = init.team;
  return admission;
}

AdmissionResult CoachRegistry::admit_trainer(const World& world, std::string_view datagram) {
  if (!allows_trainer(world)) return ErrorCode::kTrainerWithoutCoachMode;
  if (slot(kTrainer) != nullptr) return ErrorCode::kAlreadyHaveTrainer;

  soccer::TrainerInit init;
  if (const auto error = soccer::parse(datagram, init)) return *error;
  if (!is_supported_version(init.version)) return ErrorCode::kIllegalClientVersion;
  return Admission{kTrainer, static_cast<int>(init.version), false};
}

CoachSession& CoachRegistry::connect(const World& world, const Admission& admission,
                                     std::unique_ptr<soccer::Channel> channel) {
  slot(admission.client) = std::make_unique<CoachSession>();
  CoachSession& coach = *slot(admission.client);
  coach.open(admission, std::move(channel));

  coach.reply(soccer::CoachInitReply{coach.side()});
  send_parameters(world, coach);
  if (!coach.is_trainer()) send_changed_types(world, coach.side(), coach);
  return coach;
}

void CoachRegistry::disconnect_all() {
  for (auto& coach : sessions_) coach.reset();
}

void CoachRegistry::remove_lost() {
  for (auto& coach : sessions_) {
    if (coach != nullptr && coach->lost) coach.reset();
  }
}

void CoachRegistry::begin_step(const World& world, std::vector<CoachMessage>& out) {
  for (auto& coach : sessions_) {
    if (coach != nullptr) coach->begin_step();
  }

  for (const Side side : {Side::kLeft, Side::kRight}) {
    due_.clear();
    language_[index(side)].begin_step(world, due_);
    for (auto& [say, received] : due_) out.push_back({side, std::move(say), received});
  }
}

void CoachRegistry::end_step(const World& world) {
  const soccer::ServerParams& params = world.params();
  const int game_time = world.rules->normal_time;
  if (params.nr_normal_halfs <= 0 || game_time == 0) return;
  if (world.clock.stoppage != 0 || world.clock.time <= 0 || world.clock.time % game_time != 0) {
    return;
  }

  for (CoachLanguage& language : language_) language.extend_freeform_quota(params);
}

void CoachRegistry::send(CoachSession& coach, const soccer::Hear& message) {
  text_.clear();
  soccer::format(message, coach.recipient(), text_);
  coach.send(text_);
}

void CoachRegistry::send_referee_message(const soccer::Hear& message) {
  for (auto& coach : sessions_) {
    if (coach != nullptr && coach->hears()) send(*coach, message);
  }
}

void CoachRegistry::send_say(const World& world, const PlayerSaid& said) {
  const Player& speaker = world.player(said.speaker);
  for (auto& coach : sessions_) {
    if (coach == nullptr || !coach->hears()) continue;

    send(*coach, {.time = world.clock.time,
                  .sender = soccer::Hear::Sender::kPlayer,
                  .goalie = speaker.goalie,
                  .unum = speaker.unum,
                  .team = visible_team_name(world, coach->side(), speaker.side, coach->own_name),
                  .text = said.text});
  }
}

void CoachRegistry::send_coach_message(const World& world, const CoachMessage& message) {
  soccer::Hear hear = {.time = world.clock.time, .text = message.say.text};
  if (message.side != Side::kNeutral) {
    hear.sender = message.side == Side::kLeft ? soccer::Hear::Sender::kOnlineCoachLeft
                                              : soccer::Hear::Sender::kOnlineCoachRight;
    if (slot(kTrainer) != nullptr && slot(kTrainer)->ear) send(*slot(kTrainer), hear);
    return;
  }

  hear.sender = soccer::Hear::Sender::kTrainer;
  for (auto& coach : sessions_) {
    if (coach != nullptr && coach->hears()) send(*coach, hear);
  }
}

void CoachRegistry::send_type_change(const TypeChanged& change) {
  for (auto& coach : sessions_) {
    if (coach == nullptr || coach->is_trainer()) continue;

    soccer::PlayerTypeChange message{change.unum, std::nullopt};
    if (coach->side() == change.side) message.type = change.type;
    coach->reply(message);
  }
}

void CoachRegistry::send_goalie_change(const GoalieAppointed& change) {
  for (auto& coach : sessions_) {
    if (coach == nullptr || coach->is_trainer()) continue;
    if (coach->version < kFirstGoalieChangeVersion) continue;

    coach->reply(soccer::PlayerTypeChange{change.unum, std::nullopt, change.side});
  }
}

void CoachRegistry::send_view(const World& world, CoachSession& coach, bool is_look_reply) {
  coach_view(world, coach.side(), coach.version, is_look_reply, view_);
  if (!coach.own_name.empty()) {
    const soccer::TeamName ours = visible_team_name(world, coach.side(), coach.side());
    for (auto& player : view_.players) {
      const Side side = player.team == ours ? coach.side() : opponent(coach.side());
      player.team = visible_team_name(world, coach.side(), side, coach.own_name);
    }
  }
  text_.clear();
  soccer::format(view_, text_);
  coach.send(text_);
}

void CoachRegistry::send_views(const World& world) {
  for (const ClientId client : {kTrainer, kLeftCoach, kRightCoach}) {
    const auto& coach = slot(client);
    if (coach == nullptr || !coach->eye) continue;
    send_view(world, *coach, false);
    coach->sensed = true;
  }
}

void CoachRegistry::send_think() {
  text_.clear();
  soccer::format(soccer::ServerReply(soccer::Think{}), text_);
  for (auto& coach : sessions_) {
    if (coach == nullptr || !coach->eye || !coach->sensed) continue;
    coach->send(text_);
    coach->think_sent = true;
  }
}

/// One overload per command that concerns more than the world.
struct CoachRegistry::Executor {
  CoachRegistry& registry;
  World& world;
  CoachSession& coach;
  Events& events;
  CoachCommandResult& result;

  void operator()(const soccer::Look&) { registry.send_view(world, coach, true); }
  void operator()(const soccer::Eye& command) {
    coach.eye = command.on;
    result.reply = soccer::OkEye{command.on};
  }
  void operator()(const soccer::TrainerEar& command) {
    coach.ear = command.on;
    result.reply = soccer::OkEar{command.on};
  }
  void operator()(const soccer::RequestTeamNames&) {
    result.reply =
        soccer::OkTeamNames{visible_team_name(world, coach.side(), Side::kLeft, coach.own_name),
                            visible_team_name(world, coach.side(), Side::kRight, coach.own_name)};
  }
  void operator()(const soccer::ChangePlayerType& command) {
    result.reply = command.type
                       ? change_type(world, coach.side(), command.unum, *command.type, events)
                       : change_goalie(world, coach.side(), command.unum, events);
  }
  void operator()(const soccer::CoachSay& message) {
    const auto refusal = registry.language_[index(coach.side())].say(world, message);
    result.reply = refusal ? reply_of(*refusal) : soccer::OkSay{};
  }
  void operator()(const soccer::TrainerSay& message) {
    const auto max_length = base::index(world.params().say_coach_msg_size);
    result.message.emplace().say.text = message.text.substr(0, max_length);
    result.reply = soccer::OkSay{};
  }
  void operator()(const soccer::TeamGraphic& graphic) {
    result.reply = registry.reject_tile(world, coach, graphic, std::nullopt);
    if (result.reply) return;
    result.tile = TeamGraphicTile{coach.side(), graphic};
    result.reply = soccer::OkTeamGraphic{graphic.x, graphic.y};
  }
  void operator()(const soccer::Done&) {}
  void operator()(const soccer::Bye&) { coach.lost = true; }
  void operator()(const soccer::Compression& command) {
    if (command.level > Connection::kMaxCompressionLevel) {
      result.reply = reply_of(ErrorCode::kIllegalCommandForm);
    } else {
      coach.compress(command.level);
    }
  }
  template <typename Other>
  void operator()(const Other& command) {
    result.reply = apply(world, command, events);
  }
};

CoachCommandResult CoachRegistry::execute(World& world, CoachSession& coach,
                                          const CoachInbox::Datagram& datagram, Events& events) {
  CoachCommandResult result;
  if (!datagram.error) {
    std::visit(Executor{*this, world, coach, events, result}, datagram.command);
  } else if (const auto* tile = std::get_if<soccer::TeamGraphic>(&datagram.command)) {
    result.reply = reject_tile(world, coach, *tile, datagram.error);
  } else {
    result.reply = reply_of(*datagram.error);
  }
  return result;
}

// A tile outside the graphic causes a warning but is accepted.
std::optional<ServerReply> CoachRegistry::reject_tile(const World& world, CoachSession& coach,
                                                      const soccer::TeamGraphic& tile,
                                                      std::optional<ErrorCode> form_error) {
  if (world.mode != PlayMode::kBeforeKickOff) return reply_of(WarningCode::kOnlyBeforeKickOff);
  if (form_error == ErrorCode::kIllegalCommandForm) return reply_of(*form_error);
  if (tile.x < 0 || tile.x >= kTileColumns || tile.y < 0 || tile.y >= kTileRows) {
    coach.reply(WarningCode::kInvalidTileLocation);
  }
  if (form_error) return reply_of(*form_error);
  if (!tile.xpm.front().starts_with(kTileSize)) return reply_of(WarningCode::kInvalidTileSize);
  return std::nullopt;
}

}  // namespace cls::simulator
