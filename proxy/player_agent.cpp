// An agent's part of a cycle.
#include "proxy/player_agent.h"

#include <cassert>
#include <utility>

#include "proxy/executor.h"
#include "proxy/fallback.h"
#include "proxy/home_positions.h"
#include "proxy/state_message.h"
#include "soccer/protocol/connection_request.h"
#include "soccer/protocol/message_kind.h"
#include "soccer/protocol/parameter_message.h"

namespace cls::proxy {
namespace {

// From this version on players see in synchronous mode without asking.
constexpr int kSynchronousVersion = 18;
constexpr std::size_t kQuotedLength = 60;

template <typename... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <typename... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

// The agents' own settings, sent once the server has let them in.
std::string settings(int protocol) {
  std::vector<soccer::PlayerCommand> commands;
  if (protocol < kSynchronousVersion) commands.push_back(soccer::SynchSee{});
  // What opponents shout is noise to us and would use up hearing capacity.
  commands.push_back(
      soccer::Ear{false, soccer::TeamReference{soccer::TeamReference::Kind::kOpponent, ""}, {}});
  std::string datagram;
  for (const soccer::PlayerCommand& command : commands) {
    const bool formatted = soccer::format(command, datagram);
    assert(formatted);
  }
  return datagram;
}

}  // namespace

PlayerAgent::PlayerAgent(std::unique_ptr<soccer::Channel> channel, AgentOptions options)
    : channel_(std::move(channel)), options_(options) {}

bool PlayerAgent::connect() {
  soccer::PlayerInit request;
  request.team = options_.team_name;
  request.version = options_.protocol;
  request.goalie = options_.goalie;
  datagram_.clear();
  soccer::format(request, datagram_);
  return channel_->send(datagram_);
}

bool PlayerAgent::ready() const {
  return admitted_ && types_known_ > 0 && types_known_ >= world_.parameters->player.player_types;
}

void PlayerAgent::set_identity(const protos::RegisterResponse& identity) {
  *state_.mutable_register_response() = identity;
}

void PlayerAgent::perceive() {
  while (channel_->receive(message_)) take_in(message_);
}

void PlayerAgent::take_in(const std::string& message) {
  const auto parsed = [&](auto& out) {
    const soccer::Result<void> result = soccer::parse(message, out);
    if (!result) note_unreadable(result.error(), message);
    return result.ok();
  };
  switch (soccer::message_kind(message)) {
    case soccer::MessageKind::kSenseBody:
      if (parsed(sense_)) on_sense_body(world_, sense_);
      break;
    case soccer::MessageKind::kSee:
      if (parsed(see_)) on_see(world_, see_);
      break;
    case soccer::MessageKind::kHear:
      if (parsed(hear_)) on_hear(world_, hear_);
      break;
    case soccer::MessageKind::kServerParam:
    case soccer::MessageKind::kPlayerParam:
    case soccer::MessageKind::kPlayerType:
      take_in_parameters(message);
      break;
    case soccer::MessageKind::kReply:
      take_in_reply(message);
      break;
    case soccer::MessageKind::kFullState:   // the world model lives on senses alone
    case soccer::MessageKind::kGlobalView:  // for coaches
      break;
    case soccer::MessageKind::kUnknown:
      note_unreadable({"unknown message"}, message);
      break;
  }
}

void PlayerAgent::take_in_parameters(const std::string& message) {
  soccer::Result<void> result;
  switch (soccer::message_kind(message)) {
    case soccer::MessageKind::kServerParam: {
      soccer::ServerParams params;
      result = soccer::parse(message, params);
      if (result) on_server_param(world_, params);
      break;
    }
    case soccer::MessageKind::kPlayerParam: {
      soccer::PlayerParams params;
      result = soccer::parse(message, params);
      if (result) on_player_param(world_, params);
      break;
    }
    default: {
      soccer::PlayerType type = soccer::default_player_type(world_.server());
      result = soccer::parse(message, type);
      if (result) on_player_type(world_, type);
      if (result) ++types_known_;
    }
  }
  if (!result) note_unreadable(result.error(), message);
}

void PlayerAgent::take_in_reply(const std::string& message) {
  soccer::ServerReply reply;
  if (const soccer::Result<void> result = soccer::parse(message, reply); !result) {
    note_unreadable(result.error(), message);
    return;
  }
  std::visit(
      Overloaded{
          [this](const soccer::Think&) { decision_due_ = true; },
          [this](const soccer::PlayerInitReply& init) {
            on_init(world_, init, options_.team_name, options_.goalie);
            admitted_ = true;
            channel_->send(settings(options_.protocol));
          },
          [this](const soccer::PlayerTypeChange& change) { on_change_player_type(world_, change); },
          [this](const soccer::ErrorReply& error) {
            if (!admitted_) refusal_ = error.text;
            if (trouble_.errors++ == 0) trouble_.first_error = error.text;
          },
          [](const auto&) {},
      },
      reply);
}

void PlayerAgent::note_unreadable(const soccer::Error& error, const std::string& message) {
  if (trouble_.unreadable++ != 0) return;
  trouble_.first_unreadable = error.message + ": " + message.substr(0, kQuotedLength);
}

const protos::State& PlayerAgent::state() {
  assert(decision_due_);
  complete(world_);
  fill_state(world_, home_positions(world_), needs_preprocess(world_), state_);
  return state_;
}

void PlayerAgent::act(const protos::PlayerActions& actions) {
  CommandSlots slots(world_);
  execute(actions, world_, memory_, slots, statistics_.actions);
  if (options_.on_late == OnLate::kLast) last_actions_ = actions;
  send(slots);
}

void PlayerAgent::act_without_reply() {
  CommandSlots slots(world_);
  if (options_.on_late == OnLate::kDefault) make_fallback(world_, last_actions_);
  if (options_.on_late == OnLate::kHold || last_actions_.actions_size() == 0) {
    execute_without_reply(world_, memory_, slots, statistics_.actions);
  } else {
    ActionReport unasked;  // not what the Playmaker wanted in this cycle
    execute(last_actions_, world_, memory_, slots, unasked);
  }
  send(slots);
}

void PlayerAgent::send(const CommandSlots& slots) {
  slots.compose(commands_, true);
  datagram_.clear();
  for (const soccer::PlayerCommand& command : commands_) {
    const bool formatted = soccer::format(command, datagram_);
    assert(formatted && "slots hold what the grammar can say");
    if (!std::holds_alternative<soccer::Done>(command)) statistics_.count(command);
  }
  channel_->send(datagram_);
  note_sent_commands(world_, commands_);
  decision_due_ = false;
}

void PlayerAgent::leave() {
  datagram_.clear();
  const bool formatted = soccer::format(soccer::PlayerCommand(soccer::Bye{}), datagram_);
  assert(formatted);
  channel_->send(datagram_);
}

}  // namespace cls::proxy
