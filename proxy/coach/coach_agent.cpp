// A coach's or trainer's part of a cycle.
#include "proxy/coach/coach_agent.h"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>

#include "base/index.h"
#include "base/overloaded.h"
#include "player/perception/perception.h"
#include "proxy/coach/global_perception.h"
#include "proxy/messages/state_message.h"
#include "soccer/commands/connection_request.h"
#include "soccer/protocol/message_kind.h"

namespace cls::proxy {
namespace {

// "(move (ball) 1 2)" -> "move"
std::string name_of(std::string_view command) {
  const std::size_t end = command.find_first_of(" )");
  return std::string(command.substr(1, end - 1));
}

}  // namespace

CoachAgent::CoachAgent(std::unique_ptr<soccer::Channel> channel, CoachOptions options)
    : Agent(std::move(channel)), options_(std::move(options)) {
  if (options_.planner != nullptr) world_.planner = options_.planner;
}

bool CoachAgent::connect() {
  // Version 19 is the same for coaches and trainers, and servers may not know it.
  constexpr int kNewestVersion = 18;
  const int version = std::min(options_.protocol, kNewestVersion);
  if (is_trainer()) {
    return send_init(server_, soccer::TrainerInit{static_cast<double>(version)});
  }
  soccer::CoachInit request;
  request.team = options_.team_name;
  request.version = version;
  return send_init(server_, request);
}

void CoachAgent::perceive() {
  while (!deciding_ && server_.channel->receive(server_.message)) handle_message();
}

void CoachAgent::handle_message() {
  switch (soccer::message_kind(server_.message)) {
    case soccer::MessageKind::kGlobalView:
      if (!read(server_, view_)) break;
      on_global_view(world_, view_);
      if (!world_.server().synch_mode) due_ = true;
      break;

    case soccer::MessageKind::kHear:
      if (!read(server_, hear_)) break;
      on_coach_hear(world_, hear_);
      if (hear_.sender == soccer::Hear::Sender::kPlayer && hear_.team == world_.our_team_name) {
        memory_.stamina.hear(world_, hear_.unum, hear_.text);
      }
      break;

    case soccer::MessageKind::kServerParam:
    case soccer::MessageKind::kPlayerParam:
    case soccer::MessageKind::kPlayerType:
      read_parameters(server_, world_);
      break;
    case soccer::MessageKind::kReply:
      handle_server_reply();
      break;
    case soccer::MessageKind::kSenseBody:  // for players
    case soccer::MessageKind::kSee:
    case soccer::MessageKind::kFullState:
    case soccer::MessageKind::kUnknown:
      break;
  }
}

void CoachAgent::handle_server_reply() {
  soccer::ServerReply reply;
  if (!read(server_, reply)) return;

  std::visit(base::Overloaded{
                 [this](const soccer::Think&) { due_ = true; },
                 [this](const soccer::CoachInitReply& init) {
                   if (server_.accepted) return;
                   on_coach_init(world_, init.side, options_.team_name);
                   server_.accepted = true;
                   send(soccer::Eye{true});
                   if (is_trainer()) send(soccer::TrainerEar{true});
                 },
                 [this](const soccer::PlayerTypeChange& change) { change_type(change); },
                 [this](const soccer::OkChangePlayerType& change) { confirm_type(change); },
                 [this](const soccer::OkTeamNames& names) { set_names(names); },
                 [this](const soccer::ErrorReply& error) { handle_error(error); },
                 [this](const soccer::WarningReply& warning) { handle(server_, warning); },
                 [](const auto&) {},
             },
             reply);
}

// Confirms a trainer's own change; other changes are not reported to trainers.
void CoachAgent::confirm_type(const soccer::OkChangePlayerType& change) {
  if (!is_trainer() || !change.type || !soccer::is_unum(change.unum)) return;
  const bool own = change.team == world_.our_team_name;
  (own ? world_.our_types : world_.their_types)[base::index(change.unum - 1)] = *change.type;
}

void CoachAgent::set_names(const soccer::OkTeamNames& names) {
  if (!is_trainer()) return;
  world_.our_team_name = names.left;
  world_.their_team_name = names.right;
  names_complete_ = !names.left.empty() && !names.right.empty();
}

void CoachAgent::change_type(const soccer::PlayerTypeChange& change) {
  on_change_player_type(world_, change);
  if (change.goalie_side != soccer::Side::kNeutral || !soccer::is_unum(change.unum)) return;
  if (change.type) {
    record_type_change(memory_, world_, change.unum, *change.type);
  } else {
    memory_.analysis.forget(change.unum);
  }
}

// A kick may start play between the view and the coach's message, which the server then refuses.
// That happens in healthy matches, so it is not counted as an error.
void CoachAgent::handle_error(const soccer::ErrorReply& error) {
  if (error.code == soccer::ErrorCode::kCannotSayFreeformWhilePlayOn) {
    record_refused_types(memory_);
  } else {
    handle(server_, error);
  }
}

const protos::State& CoachAgent::state() {
  assert(decision_due());
  deciding_ = true;
  complete_global(world_);

  if (!is_trainer()) {
    update_memory(memory_, world_);
    for (player::PlayerState& opponent : world_.opponents) {
      const std::size_t i = base::index(opponent.unum - 1);
      int& known = world_.their_types[i];
      if (known < 0) known = memory_.analysis.found()[i];
      opponent.type_id = known;
    }
  }

  fill_coach_state(world_, options_.role, state_);
  return state_;
}

void CoachAgent::act(const protos::CoachActions& actions) {
  commands_.clear();
  execute(actions, world_, memory_, report_, commands_);
  send_commands();
}

void CoachAgent::act(const protos::TrainerActions& actions) {
  commands_.clear();
  execute(actions, world_, report_, commands_);
  send_commands();
}

void CoachAgent::act_without_reply() {
  commands_.clear();
  send_commands();
}

// The server takes tiles only before the kick-off.
void CoachAgent::show_graphic() {
  constexpr std::size_t kTilesPerCycle = 32;
  if (options_.graphic == nullptr || is_trainer()) return;
  if (world_.game.mode != soccer::PlayMode::kBeforeKickOff) return;
  const TeamGraphic& tiles = *options_.graphic;
  for (std::size_t i = 0; i < kTilesPerCycle && tiles_sent_ < tiles.size(); ++i) {
    send(tiles[tiles_sent_++]);
  }
}

void CoachAgent::send_commands() {
  show_graphic();
  for (const soccer::CoachCommand& command : commands_) send(command);
  if (is_trainer() && !names_complete_) send(soccer::RequestTeamNames{});
  if (world_.server().synch_mode) send(soccer::Done{});
  due_ = deciding_ = false;
}

// The server reads only the first command of a datagram.
void CoachAgent::send(const soccer::CoachCommand& command) {
  server_.datagram.clear();
  const bool formatted = soccer::format(command, server_.datagram);
  assert(formatted && "commands can be formatted");
  server_.channel->send(server_.datagram);
  if (!std::holds_alternative<soccer::Done>(command)) ++sent_[name_of(server_.datagram)];
}

// Trainers have no (bye). Without views the server does not wait for them.
void CoachAgent::leave() {
  send(is_trainer() ? soccer::CoachCommand(soccer::Eye{false}) : soccer::Bye{});
}

}  // namespace cls::proxy
