// Plays an episode: commands, physics, rules of the task, rewards.
#include "training/episode/episode.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "simulator/actions/actions.h"
#include "simulator/step.h"
#include "training/episode/state.h"
#include "training/tasks/formation.h"

namespace cls::training {
namespace {

constexpr std::size_t kMaxParameters = 16;

// Modes in which players may move to any place of their half.
bool allows_moves(soccer::PlayMode mode) {
  return mode == soccer::PlayMode::kBeforeKickOff || mode == soccer::PlayMode::kGoalLeft ||
         mode == soccer::PlayMode::kGoalRight;
}

}  // namespace

Episode::Episode(std::shared_ptr<const Setup> setup)
    : setup_(std::move(setup)), world_(setup_->prepared) {}

void Episode::reset(std::uint64_t seed, const OptionValues& options) {
  world_ = setup_->prepared;
  world_.seed = seed;
  world_.random = simulator::RandomStreams(seed);
  options_ = options;
  memory_ = {};
  status_ = Status::kInGame;
  started_ = true;
  for (Agent& agent : agents_) agent = {};
  soccer::RandomStream stream(seed, "training start");
  if (setup_->random_types) draw_types(stream);
  setup_->task->place({world_, setup_->cast, options_, stream});
  memory_.previous_ball = world_.ball.position;
  begin_rewards(world_, setup_->cast, reward_memory_);
  rewards_ = {};
  fill_scenes();
}

void Episode::draw_types(soccer::RandomStream& random) {
  const int types = static_cast<int>(world_.rules->types.size());
  for (simulator::Player& player : world_.players) {
    if (!player.enabled || player.goalie) continue;
    player.type = random.integer(types);
    player.stamina.effort = world_.type_of(player).effort_max;
  }
}

void Episode::fill_scenes() {
  fill_scene(world_, Side::kLeft, scenes_[0]);
  fill_scene(world_, Side::kRight, scenes_[1]);
}

double Episode::time_left() const {
  return 1.0 - static_cast<double>(memory_.cycles) / setup_->max_cycles;
}

PointOfView Episode::view_of(int slot, bool last_action_worked) const {
  const Side side = soccer::side_of_slot(slot);
  return {scenes_[side == Side::kRight ? 1 : 0],
          setup_->cast,
          seat_of(side, slot),
          setup_->task->stage(side),
          last_action_worked,
          time_left()};
}

void Episode::step(const AgentActions& actions, simulator::MatchRecorder* recorder) {
  rewards_ = {};
  for (int i = 0; i < setup_->frame_skip && !ended(); ++i) {
    choose_commands(actions);
    play_cycle(recorder);
  }
}

PlayerCommand Episode::command_of(std::size_t agent, const AgentActions& actions) {
  const ActionSet& set = *setup_->actions;
  const PointOfView view = view_of(setup_->cast.agents[agent], true);
  const float* values =
      actions.values == nullptr ? nullptr : actions.values + agent * setup_->value_count();
  std::array<float, kMaxParameters> clipped{};
  const auto clip = [&](std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const Column& column = setup_->value_columns[first + i];
      clipped[i] = std::clamp(values[first + i], column.low, column.high);
    }
  };
  agents_[agent].last_action_worked = true;
  if (set.actions.empty()) {
    clip(0, setup_->value_count());
    return set.choose(view, clipped.data());
  }
  const auto id = static_cast<std::size_t>(actions.ids[agent]);
  const Action& action = set.actions[id];
  if (action.legal != nullptr && !action.legal(view)) {
    ++agents_[agent].illegal;
    agents_[agent].last_action_worked = false;
    return stand();
  }
  clip(static_cast<std::size_t>(setup_->offsets[id]), action.parameters.size());
  return action.command(view, clipped.data());
}

void Episode::choose_commands(const AgentActions& actions) {
  const Cast& cast = setup_->cast;
  for (std::size_t agent = 0; agent < cast.agents.size(); ++agent) {
    const int slot = cast.agents[agent];
    if (!world_.player(slot).enabled) continue;
    PlayerCommand& command = commands_[static_cast<std::size_t>(slot)];
    command = command_of(agent, actions);
    if (const auto* dash = std::get_if<soccer::Dash>(&command)) {
      add_effort(dash->power, rewards_[agent]);
    }
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (const int slot : cast.team(side)) {
      const auto i = static_cast<std::size_t>(slot);
      if (setup_->is_agent[i] || !world_.player(slot).enabled) continue;
      commands_[i] =
          setup_->drivers[i] == Driver::kScripted ? scripted_command(view_of(slot, true)) : stand();
    }
  }
}

// Before a kick-off all players move to the formation; the agents have no action for it.
void Episode::return_to_formation() {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (const int slot : setup_->cast.team(side)) {
      const Vec2 place = kick_off_position(slot) * soccer::sign(side);
      commands_[static_cast<std::size_t>(slot)] = soccer::Move{place.x, place.y};
    }
  }
}

// In the order that a match server draws for this cycle.
void Episode::execute_commands() {
  std::array<simulator::Slot, soccer::kPlayersOnPitch> order;
  std::iota(order.begin(), order.end(), 0);
  simulator::clock_stream(world_, "command order", 0).shuffle(std::span<simulator::Slot>(order));
  for (const simulator::Slot slot : order) {
    if (!world_.player(slot).enabled) continue;
    simulator::apply(world_, slot, commands_[static_cast<std::size_t>(slot)], events_);
  }
}

void Episode::play_cycle(simulator::MatchRecorder* recorder) {
  if (setup_->task->referee && allows_moves(world_.mode)) return_to_formation();
  const std::array<int, 2> score = memory_.score;
  execute_commands();
  for (simulator::Player& player : world_.players) player.contacts = {};
  simulator::step(world_, events_);
  if (recorder != nullptr) recorder->step(world_);
  simulator::finish_step(world_, events_);
  events_.clear();

  ++memory_.cycles;
  status_ = setup_->task->judge(world_, options_, memory_);
  if (status_ == Status::kInGame && memory_.cycles >= setup_->max_cycles) {
    status_ = Status::kOutOfTime;
  }
  memory_.previous_ball = world_.ball.position;
  add_rewards(world_, setup_->cast, status_, memory_, score, reward_memory_, rewards_);
  fill_scenes();
}

bool Episode::alive(std::size_t agent) const {
  return world_.player(setup_->cast.agents[agent]).enabled;
}

double Episode::reward(std::size_t agent) const {
  double sum = 0.0;
  for (std::size_t term = 0; term < kRewardTerms; ++term) {
    sum += setup_->weights[term] * rewards_[agent][term];
  }
  return sum;
}

double Episode::reward_term(std::size_t term) const {
  double sum = 0.0;
  for (std::size_t agent = 0; agent < setup_->agent_count(); ++agent) {
    sum += rewards_[agent][term];
  }
  return sum / static_cast<double>(setup_->agent_count());
}

void Episode::observe(std::size_t agent, float* out) const {
  std::fill(out, out + setup_->feature_count(), 0.0F);
  if (!alive(agent)) return;
  setup_->features->fill(view_of(setup_->cast.agents[agent], agents_[agent].last_action_worked),
                         out);
}

void Episode::mask(std::size_t agent, std::uint8_t* out) const {
  const PointOfView view = view_of(setup_->cast.agents[agent], true);
  const bool plays = alive(agent);
  for (std::size_t id = 0; id < setup_->id_count(); ++id) {
    const Action& action = setup_->actions->actions[id];
    out[id] = plays && (action.legal == nullptr || action.legal(view)) ? 1 : 0;
  }
}

void Episode::state(float* out) const { fill_state(world_, setup_->cast, time_left(), out); }

}  // namespace cls::training
