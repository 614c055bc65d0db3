// One function per action.
#include "proxy/coach/coach_actions.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/index.h"
#include "player/perception/player_types_message.h"
#include "proxy/coach/substitution.h"
#include "proxy/messages/state_message.h"
#include "soccer/play_mode.h"

namespace cls::proxy {
namespace {

using soccer::CoachCommand;
using soccer::PlayMode;
using soccer::Vec2;
using Commands = std::vector<CoachCommand>;

bool is_type(const player::WorldModel& world, int type) {
  return type >= 0 && type < world.parameters->player.player_types;
}

bool is_finite(Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }

/// Executed (with or without a command), or invalid.
enum class Outcome { kDone, kInvalid };

void count(CoachActionReport& report, int kind, std::optional<Outcome> outcome) {
  if (!outcome) {
    ++report.unknown;
  } else {
    ++(*outcome == Outcome::kDone ? report.done : report.invalid)[base::index(kind)];
  }
}

// Executed with one command.
Outcome send(CoachCommand command, Commands& out) {
  out.push_back(std::move(command));
  return Outcome::kDone;
}

Outcome change_type(const protos::ChangePlayerType& action, const player::WorldModel& world,
                    Commands& out) {
  if (!soccer::is_unum(action.uniform_number()) || !is_type(world, action.type())) {
    return Outcome::kInvalid;
  }
  return send(soccer::ChangePlayerType{action.uniform_number(), action.type()}, out);
}

// Sent only when changed and when the server accepts it: the number of messages is limited.
Outcome say_types(const player::WorldModel& world, CoachMemory& memory, Commands& out) {
  if (!has_types_to_say(world, memory) || !can_say_freeform(world, memory)) return Outcome::kDone;
  memory.said_types = world.their_types;
  memory.said_in = world.game.mode_start;
  memory.said_in_vain = false;
  ++memory.freeforms_sent;
  const std::string text = "(freeform \"" + player::format_player_types(memory.said_types) + "\")";
  return send(soccer::CoachSay{soccer::ClangKind::kFreeform, text}, out);
}

// Play mode of an enum value; nullopt for modes that a trainer cannot set.
std::optional<PlayMode> mode_of(const protos::DoChangeMode& action) {
  if (action.game_mode_type() == protos::PenaltyKick_) return std::nullopt;
  const soccer::Side wanted =
      action.side() == protos::LEFT ? soccer::Side::kLeft : soccer::Side::kRight;
  for (int i = 1; i < soccer::kPlayModeCount; ++i) {  // 0 is not a play mode
    const auto mode = static_cast<PlayMode>(i);
    if (wire_mode(mode) != action.game_mode_type()) continue;
    const soccer::Side side = soccer::side(mode);
    if (side == soccer::Side::kNeutral || side == wanted) return mode;
  }
  return std::nullopt;
}

std::string team_name(const player::WorldModel& world, bool own_team) {
  return std::string((own_team ? world.our_team_name : world.their_team_name).view());
}

Outcome move_ball(const protos::DoMoveBall& action, Commands& out) {
  const Vec2 position = vec(action.position());
  const Vec2 velocity = vec(action.velocity());
  if (!is_finite(position) || !is_finite(velocity)) return Outcome::kInvalid;
  return send(soccer::MoveBall{position, 0.0, velocity}, out);
}

Outcome move_player(const protos::DoMovePlayer& action, const player::WorldModel& world,
                    Commands& out) {
  const Vec2 position = vec(action.position());
  const std::string team = team_name(world, action.our_side());
  if (!is_finite(position) || !std::isfinite(action.body_direction()) || team.empty() ||
      !soccer::is_unum(action.uniform_number())) {
    return Outcome::kInvalid;
  }
  // Without a velocity the player would retain the old one.
  return send(
      soccer::MovePlayer{team, action.uniform_number(), position, action.body_direction(), Vec2{}},
      out);
}

Outcome change_mode(const protos::DoChangeMode& action, Commands& out) {
  const std::optional<PlayMode> mode = mode_of(action);
  if (!mode) return Outcome::kInvalid;
  return send(soccer::ChangeMode{*mode}, out);
}

Outcome change_type(const protos::DoChangePlayerType& action, const player::WorldModel& world,
                    Commands& out) {
  const std::string team = team_name(world, action.our_side());
  if (team.empty() || !soccer::is_unum(action.uniform_number()) || !is_type(world, action.type())) {
    return Outcome::kInvalid;
  }
  return send(soccer::TrainerChangePlayerType{team, action.uniform_number(), action.type()}, out);
}

// Nothing for an action without a known member.
std::optional<Outcome> run(const protos::CoachAction& action, const player::WorldModel& world,
                           CoachMemory& memory, Commands& out) {
  using protos::CoachAction;
  switch (action.action_case()) {
    case CoachAction::kChangePlayerTypes:
      return change_type(action.change_player_types(), world, out);
    case CoachAction::kDoHeliosSubstitute:
      substitute(world, memory, out);
      return Outcome::kDone;
    case CoachAction::kDoHeliosSayPlayerTypes:
      return say_types(world, memory, out);
    case CoachAction::ACTION_NOT_SET:
      break;
  }

  return std::nullopt;
}

std::optional<Outcome> run(const protos::TrainerAction& action, const player::WorldModel& world,
                           Commands& out) {
  using protos::TrainerAction;
  switch (action.action_case()) {
    case TrainerAction::kDoKickOff:
      return send(soccer::Start{}, out);
    case TrainerAction::kDoMoveBall:
      return move_ball(action.do_move_ball(), out);
    case TrainerAction::kDoMovePlayer:
      return move_player(action.do_move_player(), world, out);
    case TrainerAction::kDoRecover:
      return send(soccer::Recover{}, out);
    case TrainerAction::kDoChangeMode:
      return change_mode(action.do_change_mode(), out);
    case TrainerAction::kDoChangePlayerType:
      return change_type(action.do_change_player_type(), world, out);
    case TrainerAction::ACTION_NOT_SET:
      break;
  }

  return std::nullopt;
}

}  // namespace

void execute(const protos::CoachActions& actions, const player::WorldModel& world,
             CoachMemory& memory, CoachActionReport& report, Commands& out) {
  for (const protos::CoachAction& action : actions.actions()) {
    count(report, action.action_case(), run(action, world, memory, out));
  }
}

void execute(const protos::TrainerActions& actions, const player::WorldModel& world,
             CoachActionReport& report, Commands& out) {
  for (const protos::TrainerAction& action : actions.actions()) {
    count(report, action.action_case(), run(action, world, out));
  }
}

ActionOutcomes outcomes_by_name(const CoachActionReport& report, bool is_trainer) {
  const google::protobuf::Descriptor* type =
      is_trainer ? protos::TrainerAction::descriptor() : protos::CoachAction::descriptor();

  ActionOutcomes outcomes;
  for (int kind = 1; kind < kCoachActionKinds; ++kind) {
    const std::size_t index = base::index(kind);
    const google::protobuf::FieldDescriptor* field = type->FindFieldByNumber(kind);
    if (field == nullptr) continue;
    if (report.done[index] != 0) outcomes[field->name()]["executed"] = report.done[index];
    if (report.invalid[index] != 0) outcomes[field->name()]["invalid"] = report.invalid[index];
  }

  if (report.unknown != 0) outcomes["unknown"]["unimplemented"] = report.unknown;
  return outcomes;
}

}  // namespace cls::proxy
