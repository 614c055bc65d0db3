// Executes commands of coaches and the trainer.
#include <utility>
#include <variant>

#include "simulator/actions/trainer.h"
#include "simulator/referee/substitution.h"
#include "simulator/sessions/coach_registry.h"
#include "simulator/world/roster.h"

namespace cls::simulator {
namespace {

using soccer::ErrorCode;
using soccer::ServerReply;
using soccer::WarningCode;

constexpr int kTileColumns = 32;
constexpr int kTileRows = 8;
constexpr std::string_view kTileSize = "8 8 ";  // start of the XPM header

ServerReply error(ErrorCode code) { return soccer::ErrorReply{std::string(name(code)), code}; }
ServerReply warning(WarningCode code) {
  return soccer::WarningReply{std::string(name(code)), code};
}

}  // namespace

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
    result.reply = refusal ? error(*refusal) : soccer::OkSay{};
  }
  void operator()(const soccer::TrainerSay& message) {
    const auto max_length = static_cast<std::size_t>(world.params().say_coach_msg_size);
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
      result.reply = error(ErrorCode::kIllegalCommandForm);
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
    result.reply = error(*datagram.error);
  }
  return result;
}

// A tile outside the graphic causes a warning but is accepted.
std::optional<ServerReply> CoachRegistry::reject_tile(const World& world, CoachSession& coach,
                                                      const soccer::TeamGraphic& tile,
                                                      std::optional<ErrorCode> form_error) {
  if (world.mode != PlayMode::kBeforeKickOff) return warning(WarningCode::kOnlyBeforeKickOff);
  if (form_error == ErrorCode::kIllegalCommandForm) return error(*form_error);
  if (tile.x < 0 || tile.x >= kTileColumns || tile.y < 0 || tile.y >= kTileRows) {
    coach.reply(WarningCode::kInvalidTileLocation);
  }
  if (form_error) return error(*form_error);
  if (!tile.xpm.front().starts_with(kTileSize)) return warning(WarningCode::kInvalidTileSize);
  return std::nullopt;
}

}  // namespace cls::simulator
