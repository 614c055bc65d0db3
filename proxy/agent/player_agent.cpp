// A player's part of a cycle.
#include "proxy/agent/player_agent.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/overloaded.h"
#include "player/behaviors/automatic_play.h"
#include "player/movement/home_positions.h"
#include "player/world/planner_parameters.h"
#include "proxy/actions/executor.h"
#include "proxy/messages/full_state_view.h"
#include "proxy/messages/shoot_out_view.h"
#include "proxy/messages/state_message.h"
#include "proxy/planner/planner_messages.h"
#include "soccer/commands/connection_request.h"
#include "soccer/messages/values.h"
#include "soccer/protocol/message_kind.h"
#include "soccer/protocol/reply_code.h"

namespace cls::proxy {
namespace {

// Protocol version since which players have synchronous see without a request.
constexpr int kSynchronousVersion = 18;

// Two-leg dashes and Gaussian see are as old as version 19; servers of that version send this
// parameter to clients of it.
constexpr std::string_view kVersion19Parameter = "(dist_noise_rate ";
// For servers that do not know version 19.
constexpr int kOlderVersion = 18;

// Appends the command, which can be formatted.
void append(const soccer::PlayerCommand& command, std::string& datagram) {
  const bool formatted = soccer::format(command, datagram);
  assert(formatted);
}

// Settings, sent after the server has accepted the agent.
std::string initial_commands(int protocol) {
  std::string datagram;
  if (protocol < kSynchronousVersion) append(soccer::SynchSee{}, datagram);
  // Opponents' say messages are noise and would use up hearing capacity.
  append(soccer::Ear{false, soccer::TeamReference{soccer::TeamReference::Kind::kOpponent, ""}, {}},
         datagram);
  // Without (clang ...) the server does not forward coach messages.
  constexpr int kMinCoachLanguage = 7;
  constexpr int kMaxCoachLanguage = 8;
  append(soccer::Clang{kMinCoachLanguage, kMaxCoachLanguage}, datagram);
  return datagram;
}

bool requests_choice(const protos::PlayerActions& actions) {
  return std::ranges::any_of(actions.actions(), [](const auto& action) {
    return action.has_helios_offensive_planner() &&
           action.helios_offensive_planner().server_side_decision();
  });
}

// Commands that the server counts even without effect, one per cycle. It does not count a kick when
// the ball is out of reach.
bool is_counted(const soccer::PlayerCommand& command, soccer::PlayMode mode) {
  return std::holds_alternative<soccer::Turn>(command) ||
         std::holds_alternative<soccer::Dash>(command) ||
         std::holds_alternative<soccer::LegDash>(command) ||
         (std::holds_alternative<soccer::Tackle>(command) && !player::clock_stopped(mode));
}

// As values or as text.
template <typename Message>
bool read_senses(ServerConnection& server, Message& out) {
  const bool read_as_values = server.reads_values && soccer::read_values(server.message, out);
  return read_as_values || read(server, out);
}

}  // namespace

PlayerAgent::PlayerAgent(std::unique_ptr<soccer::Channel> channel, AgentOptions options)
    : Agent(std::move(channel)), options_(std::move(options)) {
  server_.reads_values = server_.channel->ask_for_values();
  if (options_.formations != nullptr) world_.formations = options_.formations;
  if (options_.planner != nullptr) world_.planner = options_.planner;
  if (options_.make_own_play) own_play_ = options_.make_own_play();
}

bool PlayerAgent::connect() {
  if (options_.reconnect_unum != 0) {
    const std::string team(options_.team_name.view());
    return send_init(server_, soccer::PlayerReconnect{team, options_.reconnect_unum});
  }
  soccer::PlayerInit request;
  request.team = options_.team_name;
  request.version = options_.protocol;
  request.goalie = options_.goalie;
  return send_init(server_, request);
}

void PlayerAgent::perceive() {
  while (!deciding() && server_.channel->receive(server_.message)) handle_message();
  statistics_.undecided = timer_.undecided();
}

void PlayerAgent::handle_message() {
  switch (soccer::message_kind(server_.message)) {
    case soccer::MessageKind::kSenseBody:
      if (read_senses(server_, sense_)) handle_sense_body();
      break;
    case soccer::MessageKind::kSee:
      if (!read_senses(server_, see_)) break;
      on_see(world_, see_);
      if (see_.time == world_.game.time.cycle) timer_.on_see(server_.channel->received_at());
      break;

    case soccer::MessageKind::kHear:
      if (read(server_, hear_)) on_hear(world_, hear_);
      break;

    case soccer::MessageKind::kServerParam:
      if (!read_parameters(server_, world_)) break;
      timer_.set_synchronous(world_.server().synch_mode);
      timer_.set_slow_down(world_.server().slow_down_factor);
      use_version_19();
      break;

    case soccer::MessageKind::kPlayerParam:
    case soccer::MessageKind::kPlayerType:
      read_parameters(server_, world_);
      break;
    case soccer::MessageKind::kReply:
      handle_server_reply();
      break;
    case soccer::MessageKind::kFullState:
      if (options_.full_state != FullStateUse::kIgnore) read(server_, full_state_);
      break;
    case soccer::MessageKind::kGlobalView:  // for coaches
      break;
    case soccer::MessageKind::kUnknown:
      server_.errors.add_unreadable("unknown message", server_.message);
      break;
  }
}

void PlayerAgent::handle_sense_body() {
  count_lost_commands();
  on_sense_body(world_, sense_);
  timer_.on_sense_body(server_.channel->received_at(), sense_.width);
}

// The server counts executed commands. It executes none of a player that was frozen, or that was
// fouled before their command was handled.
void PlayerAgent::count_lost_commands() {
  const auto total = [](const soccer::CommandCounts& counts, int tackles) {
    return counts.kick + counts.dash + counts.turn + counts.catches + counts.move + tackles;
  };

  const player::SelfState& self = world_.self;
  const bool frozen =
      self.tackle_expires_in > 0 || self.foul_charged > 0 || sense_.foul_charged > 0;
  const int before = total(self.counts, self.tackle_count);
  if (awaits_count_ && !frozen && total(sense_.counts, sense_.tackle_count) == before) {
    ++statistics_.lost_commands;
  }
  awaits_count_ = false;
}

// A datagram may arrive twice, and a faulty server may send a second reply: the number, under which
// the Playmaker knows the agent, stays.
void PlayerAgent::on_connected(const soccer::PlayerInitReply& init) {
  if (server_.accepted) {
    server_.errors.add_unreadable("reply to init after the first one", server_.message);
    return;
  }
  on_init(world_, init, options_.team_name, options_.goalie);
  server_.accepted = true;
  server_.channel->send(initial_commands(options_.protocol));
}

// After server_param.
void PlayerAgent::use_version_19() {
  const bool offered = server_.message.find(kVersion19Parameter) != std::string::npos;
  world_.leg_dashes = offered && world_.planner->leg_dashes != 0;
  if (!offered || world_.planner->gaussian_see == 0) return;
  std::string command;
  append(soccer::GaussianSee{}, command);
  server_.channel->send(command);
}

// A server refuses versions that it does not know as it refuses a twelfth player.
bool PlayerAgent::retry_with_older_version(const soccer::ErrorReply& error) {
  if (server_.accepted || options_.reconnect_unum != 0 || options_.protocol <= kOlderVersion ||
      error.text != soccer::name(soccer::ErrorCode::kNoMorePlayerOrGoalieOrIllegalVersion)) {
    return false;
  }
  options_.protocol = kOlderVersion;
  return connect();
}

void PlayerAgent::handle_server_reply() {
  soccer::ServerReply reply;
  if (!read(server_, reply)) return;

  std::visit(
      base::Overloaded{
          [this](const soccer::Think&) { timer_.on_think(server_.channel->received_at()); },
          [this](const soccer::PlayerInitReply& init) { on_connected(init); },
          [this](const soccer::OkSynchSee&) { timer_.set_synch_see(true); },
          [this](const soccer::OkGaussianSee&) { on_gaussian_see(world_); },
          [this](const soccer::ReconnectReply& reconnected) {
            // The server retains the synch_see of the lost connection and does not confirm it
            // again.
            if (options_.protocol >= kSynchronousVersion) timer_.set_synch_see(true);
            on_connected({reconnected.side, options_.reconnect_unum, reconnected.mode});
          },
          [this](const soccer::PlayerTypeChange& change) { on_change_player_type(world_, change); },
          [this](const soccer::ErrorReply& error) {
            if (!retry_with_older_version(error)) handle(server_, error);
          },
          [this](const soccer::WarningReply& warning) { handle(server_, warning); },
          [](const auto&) {},
      },
      reply);
}

const player::WorldModel& PlayerAgent::begin_decision(Instant now) {
  assert(decision_due(now));
  if (!timer_.synchronous()) {
    const auto delay = std::chrono::duration_cast<std::chrono::microseconds>(now - timer_.due_at());
    if (delay > kLateWakeup) ++statistics_.late_wakeups;
    statistics_.longest_wakeup = std::max(statistics_.longest_wakeup, delay);
  }

  phase_ = Phase::kAwaitingReply;
  timer_.decided();

  view_.reset();
  if (options_.full_state == FullStateUse::kOverride && has_full_state()) {
    view_ = std::make_unique<player::WorldModel>(full_state_view(world_, full_state_));
    update_derived(*view_);
  }

  update_derived(world_);
  if (needs_shoot_out_view(world_)) {
    view_ = std::make_unique<player::WorldModel>(rotated(decision_world()));
  }
  return decision_world();
}

// Of this cycle: a server may lose one.
bool PlayerAgent::has_full_state() const {
  return !full_state_.players.empty() && full_state_.time == world_.game.time.cycle;
}

const protos::State& PlayerAgent::state(Instant now) {
  const player::WorldModel& world = begin_decision(now);
  fill_state(world, home_positions(world), needs_preprocess(world), state_);
  state_.clear_full_world_model();
  if (options_.full_state != FullStateUse::kIgnore && has_full_state()) {
    player::WorldModel exact = full_state_view(world_, full_state_);
    update_derived(exact);
    fill_state(exact, home_positions(exact), false, full_view_);
    state_.mutable_full_world_model()->Swap(full_view_.mutable_world_model());
  }
  return state_;
}

bool PlayerAgent::act(const protos::PlayerActions& actions) {
  const player::WorldModel& world = decision_world();
  if (options_.on_late == OnLate::kLast) last_actions_ = actions;
  choice_ = {};
  player::CommandSlots slots(world);

  if (has_own_play()) {
    execute_own_play(own_play_, world, memory_, slots, statistics_.actions, choice_);
  } else if (world.self.kickable && requests_choice(actions)) {
    // This attempt is repeated with the choice.
    choice_.chooser = player::PlanChoice::Chooser::kPlaymaker;
    player::ActionMemory memory = memory_;
    player::ActionReport report = statistics_.actions;
    execute(actions, world, memory, slots, report, choice_);
    if (choice_.chooser == player::PlanChoice::Chooser::kRequested) {
      chosen_from_ = actions;
      fill_planner_request(world, choice_.plan, state_, planner_request_);
      phase_ = Phase::kAwaitingChoice;
      return false;
    }
    memory_ = std::move(memory);
    statistics_.actions = report;
  } else {
    execute(actions, world, memory_, slots, statistics_.actions, choice_);
  }

  send(slots);
  return true;
}

void PlayerAgent::act_on_planner_choice(std::optional<int> node) {
  assert(awaits_planner_choice());
  const player::WorldModel& world = decision_world();
  choice_.chooser = player::PlanChoice::Chooser::kReplied;
  choice_.node = node.value_or(-1);
  // A negative index is not a failure: use the plan's best node.
  if (node && *node < 0) choice_.node = choice_.plan.best;
  player::CommandSlots slots(world);
  execute(chosen_from_, world, memory_, slots, statistics_.actions, choice_);
  send(slots);
}

void PlayerAgent::act_without_reply() {
  const player::WorldModel& world = decision_world();
  choice_ = {};
  player::CommandSlots slots(world);

  if (options_.on_late == OnLate::kDefault) choose_fallback_actions(world, last_actions_);
  if (options_.on_late == OnLate::kHold || last_actions_.actions_size() == 0) {
    execute_without_reply(world, memory_, slots, statistics_.actions);
  } else {
    player::ActionReport uncounted;  // not requested in this cycle
    execute(last_actions_, world, memory_, slots, uncounted);
  }
  send(slots);
}

void PlayerAgent::send(const player::CommandSlots& slots) {
  slots.compose(commands_, timer_.synchronous());
  server_.datagram.clear();
  for (const soccer::PlayerCommand& command : commands_) {
    append(command, server_.datagram);
    if (!std::holds_alternative<soccer::Done>(command)) statistics_.count(command);
    awaits_count_ = awaits_count_ || is_counted(command, world_.game.mode);
  }
  if (!server_.datagram.empty()) server_.channel->send(server_.datagram);
  record_sent_commands(world_, commands_);
  phase_ = Phase::kIdle;
}

void PlayerAgent::leave() {
  server_.datagram.clear();
  append(soccer::Bye{}, server_.datagram);
  server_.channel->send(server_.datagram);
}

}  // namespace cls::proxy
