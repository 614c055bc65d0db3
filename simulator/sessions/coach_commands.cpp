// Executing what coaches and the trainer send.
#include <utility>
#include <variant>

#include "simulator/actions/trainer.h"
#include "simulator/referee/substitution.h"
#include "simulator/sessions/coaches.h"
#include "simulator/world/roster.h"

namespace cls::simulator {
namespace {

using soccer::ErrorCode;
using soccer::ServerReply;
using soccer::WarningCode;

constexpr int kPictureColumns = 32;
constexpr int kPictureRows = 8;
constexpr std::string_view kTileSize = "8 8 ";  // in the header of a picture

ServerReply error(ErrorCode code) { return soccer::ErrorReply{std::string(name(code)), code}; }
ServerReply warning(WarningCode code) {
  return soccer::WarningReply{std::string(name(code)), code};
}

}  // namespace

/// One overload per command that is not the world's alone.
struct Coaches::Executor {
  Coaches& all;
  World& world;
  CoachSession& coach;
  Events& events;
  CoachOutcome& outcome;

  void operator()(const soccer::Look&) { all.send_view(world, coach, true); }
  void operator()(const soccer::Eye& command) {
    coach.eye = command.on;
    outcome.reply = soccer::OkEye{command.on};
  }
  void operator()(const soccer::TrainerEar& command) {
    coach.ear = command.on;
    outcome.reply = soccer::OkEar{command.on};
  }
  void operator()(const soccer::AskTeamNames&) {
    outcome.reply = soccer::OkTeamNames{shown_name(world, coach.side(), Side::kLeft),
                                        shown_name(world, coach.side(), Side::kRight)};
  }
  void operator()(const soccer::ChangePlayerType& command) {
    outcome.reply = command.type
                        ? change_type(world, coach.side(), command.unum, *command.type, events)
                        : change_goalie(world, coach.side(), command.unum, events);
  }
  void operator()(const soccer::CoachSay& said) {
    const auto refusal = all.language_[index(coach.side())].say(world, said);
    outcome.reply = refusal ? error(*refusal) : soccer::OkSay{};
  }
  void operator()(const soccer::TrainerSay& said) {
    const auto longest = static_cast<std::size_t>(world.params().say_coach_msg_size);
    outcome.words.emplace().said.text = said.text.substr(0, longest);
    outcome.reply = soccer::OkSay{};
  }
  void operator()(const soccer::TeamGraphic& graphic) {
    outcome.reply = all.refuse_tile(world, coach, graphic, std::nullopt);
    if (outcome.reply) return;
    outcome.tile = Tile{coach.side(), graphic};
    outcome.reply = soccer::OkTeamGraphic{graphic.x, graphic.y};
  }
  void operator()(const soccer::Done&) {}
  void operator()(const soccer::Bye&) { coach.lost = true; }
  void operator()(const soccer::Compression& command) {
    if (command.level > Connection::kMostCompression) {
      outcome.reply = error(ErrorCode::kIllegalCommandForm);
    } else {
      coach.compress(command.level);
    }
  }
  template <typename Other>
  void operator()(const Other& command) {
    outcome.reply = obey(world, command, events);
  }
};

CoachOutcome Coaches::execute(World& world, CoachSession& coach,
                              const CoachInbox::Datagram& datagram, Events& events) {
  CoachOutcome outcome;
  if (!datagram.error) {
    std::visit(Executor{*this, world, coach, events, outcome}, datagram.command);
  } else if (const auto* tile = std::get_if<soccer::TeamGraphic>(&datagram.command)) {
    outcome.reply = refuse_tile(world, coach, *tile, datagram.error);
  } else {
    outcome.reply = error(*datagram.error);
  }
  return outcome;
}

// A place outside the picture is warned of, and the tile is taken all the same.
std::optional<ServerReply> Coaches::refuse_tile(const World& world, CoachSession& coach,
                                                const soccer::TeamGraphic& tile,
                                                std::optional<ErrorCode> form_error) {
  if (world.mode != PlayMode::kBeforeKickOff) return warning(WarningCode::kOnlyBeforeKickOff);
  if (form_error == ErrorCode::kIllegalCommandForm) return error(*form_error);
  if (tile.x < 0 || tile.x >= kPictureColumns || tile.y < 0 || tile.y >= kPictureRows) {
    coach.reply(WarningCode::kInvalidTileLocation);
  }
  if (form_error) return error(*form_error);
  if (!tile.xpm.front().starts_with(kTileSize)) return warning(WarningCode::kInvalidTileSize);
  return std::nullopt;
}

}  // namespace cls::simulator
