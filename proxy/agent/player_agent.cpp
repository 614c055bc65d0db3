// An agent's part of a cycle.
#include "proxy/agent/player_agent.h"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <utility>

#include "base/overloaded.h"
#include "proxy/actions/executor.h"
#include "proxy/actions/fallback.h"
#include "proxy/messages/shoot_out_view.h"
#include "proxy/messages/state_message.h"
#include "proxy/movement/home_positions.h"
#include "proxy/planner/planner_messages.h"
#include "soccer/commands/connection_request.h"
#include "soccer/protocol/message_kind.h"

namespace cls::proxy {
namespace {

// From this version on players see in synchronous mode without asking.
constexpr int kSynchronousVersion = 18;

// The agents' own settings, sent once the server has let them in.
std::string settings(int protocol) {
  std::vector<soccer::PlayerCommand> commands;
  if (protocol < kSynchronousVersion) commands.push_back(soccer::SynchSee{});
  // What opponents shout is noise to us and would use up hearing capacity.
  commands.push_back(
      soccer::Ear{false, soccer::TeamReference{soccer::TeamReference::Kind::kOpponent, ""}, {}});
  // Who does not say this is not told what the coach says.
  constexpr int kOldestCoachLanguage = 7;
  constexpr int kNewestCoachLanguage = 8;
  commands.push_back(soccer::Clang{kOldestCoachLanguage, kNewestCoachLanguage});
  std::string datagram;
  for (const soccer::PlayerCommand& command : commands) {
    const bool formatted = soccer::format(command, datagram);
    assert(formatted);
  }
  return datagram;
}

bool leaves_choice_open(const protos::PlayerActions& actions) {
  return std::any_of(actions.actions().begin(), actions.actions().end(), [](const auto& action) {
    return action.has_helios_offensive_planner() &&
           action.helios_offensive_planner().server_side_decision();
  });
}

// Commands that the server counts whatever comes of them, one a cycle; a kick it does not when the
// ball is out of reach.
bool is_counted(const soccer::PlayerCommand& command, soccer::PlayMode mode) {
  return std::holds_alternative<soccer::Turn>(command) ||
         std::holds_alternative<soccer::Dash>(command) ||
         (std::holds_alternative<soccer::Tackle>(command) && !clock_stands(mode));
}

}  // namespace

std::optional<OnLate> on_late_from_name(std::string_view name) {
  if (name == "hold") return OnLate::kHold;
  if (name == "last") return OnLate::kLast;
  if (name == "default") return OnLate::kDefault;
  return std::nullopt;
}

PlayerAgent::PlayerAgent(std::unique_ptr<soccer::Channel> channel, AgentOptions options)
    : server_(std::move(channel)), options_(std::move(options)) {
  if (options_.formations != nullptr) world_.formations = options_.formations;
}

bool PlayerAgent::connect() {
  if (options_.reconnect_unum != 0) {
    const std::string team(options_.team_name.view());
    return request_entry(server_, soccer::PlayerReconnect{team, options_.reconnect_unum});
  }
  soccer::PlayerInit request;
  request.team = options_.team_name;
  request.version = options_.protocol;
  request.goalie = options_.goalie;
  return request_entry(server_, request);
}

void PlayerAgent::perceive() {
  while (!deciding_ && server_.channel->receive(server_.message)) take_in_message();
  statistics_.undecided = timer_.undecided();
}

void PlayerAgent::take_in_message() {
  switch (soccer::message_kind(server_.message)) {
    case soccer::MessageKind::kSenseBody:
      if (read(server_, sense_)) take_in_sense_body();
      break;
    case soccer::MessageKind::kSee:
      if (!read(server_, see_)) break;
      on_see(world_, see_);
      if (see_.time == world_.game.time.cycle) timer_.on_see(server_.channel->arrived());
      break;
    case soccer::MessageKind::kHear:
      if (read(server_, hear_)) on_hear(world_, hear_);
      break;
    case soccer::MessageKind::kServerParam:
      if (!read_parameters(server_, world_)) break;
      timer_.set_synchronous(world_.server().synch_mode);
      timer_.set_slow_down(world_.server().slow_down_factor);
      break;
    case soccer::MessageKind::kPlayerParam:
    case soccer::MessageKind::kPlayerType:
      read_parameters(server_, world_);
      break;
    case soccer::MessageKind::kReply:
      take_in_reply();
      break;
    case soccer::MessageKind::kFullState:   // the world model lives on senses alone
    case soccer::MessageKind::kGlobalView:  // for coaches
      break;
    case soccer::MessageKind::kUnknown:
      server_.trouble.note_unreadable("unknown message", server_.message);
      break;
  }
}

void PlayerAgent::take_in_sense_body() {
  note_lost_commands();
  on_sense_body(world_, sense_);
  timer_.on_sense_body(server_.channel->arrived(), sense_.width);
}

// The server counts what it carries out. Nothing of it is due from a player who was frozen, or was
// fouled before his command's turn came.
void PlayerAgent::note_lost_commands() {
  const auto total = [](const soccer::CommandCounts& counts, int tackles) {
    return counts.kick + counts.dash + counts.turn + counts.catches + counts.move + tackles;
  };
  const SelfState& self = world_.self;
  const bool frozen =
      self.tackle_expires_in > 0 || self.foul_charged > 0 || sense_.foul_charged > 0;
  const int before = total(self.counts, self.tackle_count);
  if (awaits_count_ && !frozen && total(sense_.counts, sense_.tackle_count) == before) {
    ++statistics_.lost_commands;
  }
  awaits_count_ = false;
}

void PlayerAgent::begin_part(const soccer::PlayerInitReply& init) {
  on_init(world_, init, options_.team_name, options_.goalie);
  server_.admitted = true;
  server_.channel->send(settings(options_.protocol));
}

void PlayerAgent::take_in_reply() {
  soccer::ServerReply reply;
  if (!read(server_, reply)) return;
  std::visit(
      base::Overloaded{
          [this](const soccer::Think&) { timer_.on_think(server_.channel->arrived()); },
          [this](const soccer::PlayerInitReply& init) { begin_part(init); },
          [this](const soccer::OkSynchSee&) { timer_.set_synch_see(true); },
          [this](const soccer::ReconnectReply& back) {
            // The server keeps what the lost connection had asked for, and does not repeat it.
            if (options_.protocol >= kSynchronousVersion) timer_.set_synch_see(true);
            begin_part({back.side, options_.reconnect_unum, back.mode});
          },
          [this](const soccer::PlayerTypeChange& change) { on_change_player_type(world_, change); },
          [this](const soccer::ErrorReply& error) { note(server_, error); },
          [this](const soccer::WarningReply& warning) { note(server_, warning); },
          [](const auto&) {},
      },
      reply);
}

const protos::State& PlayerAgent::state(Instant now) {
  assert(decision_due(now));
  if (!timer_.synchronous()) {
    const auto delay = std::chrono::duration_cast<std::chrono::microseconds>(now - timer_.due_at());
    if (delay > kLateWakeup) ++statistics_.late_wakeups;
    statistics_.longest_wakeup = std::max(statistics_.longest_wakeup, delay);
  }
  deciding_ = true;
  timer_.decided();
  complete(world_);
  view_.reset();
  if (turned_for_shoot_out(world_)) view_ = std::make_unique<WorldModel>(turned(world_));
  const WorldModel& world = decision_world();
  fill_state(world, home_positions(world), needs_preprocess(world), state_);
  return state_;
}

bool PlayerAgent::act(const protos::PlayerActions& actions) {
  const WorldModel& world = decision_world();
  if (options_.on_late == OnLate::kLast) last_actions_ = actions;
  choice_ = {};
  if (world.self.kickable && leaves_choice_open(actions)) {
    // What is tried here is tried again with the answer.
    choice_.chooser = PlanChoice::Chooser::kOpen;
    ActionMemory memory = memory_;
    CommandSlots slots(world);
    ActionReport report = statistics_.actions;
    execute(actions, world, memory, slots, report, choice_);
    if (choice_.chooser == PlanChoice::Chooser::kWanted) {
      chosen_from_ = actions;
      fill_planner_request(world, choice_.plan, state_, planner_request_);
      awaits_choice_ = true;
      return false;
    }
    memory_ = std::move(memory);
    statistics_.actions = report;
    send(slots);
    return true;
  }
  CommandSlots slots(world);
  execute(actions, world, memory_, slots, statistics_.actions, choice_);
  send(slots);
  return true;
}

void PlayerAgent::act_on_choice(std::optional<int> node) {
  assert(awaits_choice_);
  awaits_choice_ = false;
  const WorldModel& world = decision_world();
  choice_.chooser = PlanChoice::Chooser::kAnswered;
  choice_.node = node.value_or(-1);
  // An index that no node has is no failure: the plan's own best stands in for it.
  if (node && *node < 0) choice_.node = choice_.plan.best;
  CommandSlots slots(world);
  execute(chosen_from_, world, memory_, slots, statistics_.actions, choice_);
  send(slots);
}

void PlayerAgent::act_without_reply() {
  const WorldModel& world = decision_world();
  CommandSlots slots(world);
  if (options_.on_late == OnLate::kDefault) make_fallback(world, last_actions_);
  if (options_.on_late == OnLate::kHold || last_actions_.actions_size() == 0) {
    execute_without_reply(world, memory_, slots, statistics_.actions);
  } else {
    ActionReport unasked;  // not what the Playmaker wanted in this cycle
    execute(last_actions_, world, memory_, slots, unasked);
  }
  send(slots);
}

void PlayerAgent::write_debug_log() {
  if (options_.debug_log.empty() || memory_.debug.empty()) return;
  if (!debug_log_.is_open()) {
    const std::string name =
        std::string(options_.team_name.view()) + "-" + std::to_string(world_.unum) + ".log";
    debug_log_.open(std::filesystem::path(options_.debug_log) / name);
  }
  debug_log_ << memory_.debug;
}

void PlayerAgent::send(const CommandSlots& slots) {
  slots.compose(commands_, timer_.synchronous());
  server_.datagram.clear();
  for (const soccer::PlayerCommand& command : commands_) {
    const bool formatted = soccer::format(command, server_.datagram);
    assert(formatted && "slots hold what the grammar can say");
    if (!std::holds_alternative<soccer::Done>(command)) statistics_.count(command);
    awaits_count_ = awaits_count_ || is_counted(command, world_.game.mode);
  }
  server_.channel->send(server_.datagram);
  note_sent_commands(world_, commands_);
  deciding_ = false;
  write_debug_log();
}

void PlayerAgent::leave() {
  server_.datagram.clear();
  const bool formatted = soccer::format(soccer::PlayerCommand(soccer::Bye{}), server_.datagram);
  assert(formatted);
  server_.channel->send(server_.datagram);
}

}  // namespace cls::proxy
