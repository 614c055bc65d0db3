// Plays an episode: commands, physics, rules of the task, rewards.
#include "training/episode/episode.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "analysis/situations/book.h"
#include "base/index.h"
#include "base/overloaded.h"
#include "simulator/actions/actions.h"
#include "simulator/step.h"
#include "soccer/commands/rounding.h"
#include "training/features/sense_features.h"
#include "training/scene/estimated_scene.h"
#include "training/scene/openings.h"

namespace cls::training {
namespace {

constexpr std::size_t kMaxParameters = 16;

// Modes in which players may move to any place of their half.
bool allows_moves(soccer::PlayMode mode) {
  return mode == soccer::PlayMode::kBeforeKickOff || mode == soccer::PlayMode::kGoalLeft ||
         mode == soccer::PlayMode::kGoalRight;
}

// The text of a command has no more digits, so that a client can send the same command.
void round_numbers(PlayerCommand& command) {
  const auto round = [](auto&... numbers) {
    ((numbers = soccer::rounded_for_command(numbers)), ...);
  };
  std::visit(base::Overloaded{[&](soccer::Dash& dash) { round(dash.power, dash.direction); },
                              [&](soccer::Turn& turn) { round(turn.moment); },
                              [&](soccer::Kick& kick) { round(kick.power, kick.direction); },
                              [&](soccer::Tackle& tackle) { round(tackle.angle_or_power); },
                              [&](soccer::Catch& catches) { round(catches.direction); },
                              [&](soccer::Move& move) { round(move.x, move.y); }, [](auto&) {}},
             command);
}

// Logs the commands as one datagram.
void record_commands(std::span<const PlayerCommand> commands, const simulator::World& world,
                     simulator::Slot slot, simulator::MatchRecorder& recorder) {
  std::string text;
  for (const PlayerCommand& command : commands) {
    [[maybe_unused]] const bool formatted = soccer::format(command, text);
    assert(formatted);
  }
  recorder.command(world, slot, text);
}

// Logs the messages of the referee among the events from index `first` on.
void record_messages(const simulator::Events& events, std::size_t first,
                     simulator::MatchRecorder& recorder) {
  for (std::size_t i = first; i < events.size(); ++i) {
    const auto* message = std::get_if<simulator::RefereeMessage>(&events[i].what);
    if (message != nullptr) recorder.referee(events[i].clock, message->text());
  }
}

}  // namespace

Episode::Episode(std::shared_ptr<const Setup> setup)
    : setup_(std::move(setup)),
      world_(setup_->prepared),
      perceivers_(setup_->perceivers),
      estimated_(perceivers_.size()),
      memories_(setup_->actions->options ? perceivers_.size() : 0),
      tables_(memories_.size()) {
  others_.players = setup_->match_players;
}

void Episode::reset(std::uint64_t seed, const OptionValues& options) {
  soccer::RandomStream stream = clear(seed, options);
  if (setup_->book == nullptr) {
    setup_->task->place({world_, setup_->cast, options_, stream});
    return begin();
  }

  const std::vector<analysis::Situation>& situations = setup_->book->situations;
  const int drawn = stream.integer(static_cast<int>(situations.size()));
  begin_at(start_of(situations[base::index(drawn)]));
}

void Episode::reset_at(std::uint64_t seed, const OptionValues& options, const Start& start) {
  clear(seed, options);
  begin_at(start);
}

// Returns the random numbers of the start.
soccer::RandomStream Episode::clear(std::uint64_t seed, const OptionValues& options) {
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
  return stream;
}

void Episode::begin_at(const Start& start) {
  const bool perceived = has_world_models() || !setup_->match_players.empty();
  const StartFrame& moment = start.frames.back();
  const StartFrame& first = perceived ? start.frames.front() : moment;
  training::begin_at(start, first, setup_->cast, world_, events_);
  memory_.cycles = start.cycles;
  memory_.score = start.score;
  begin();
  if (&first == &moment) return;

  for (std::size_t i = 1; i < start.frames.size(); ++i) perceive_frame(start.frames[i]);
  for (Agent& agent : agents_) agent = {};
  if (world_.mode != start.mode) {  // the referee has intervened
    Start now = start;
    now.time = world_.clock.time;
    training::begin_at(now, moment, setup_->cast, world_, events_);
  }
  memory_.previous_ball = world_.ball.position;
  begin_rewards(world_, setup_->cast, reward_memory_);
  fill_scenes();
}

// A cycle before the start: heads, views and messages are the players' own, bodies and the ball
// those of the frame.
void Episode::perceive_frame(const StartFrame& frame) {
  for (simulator::Player& player : world_.players) player.command_done = true;
  for (const Side side : soccer::kBothSides) {
    for (const int slot : setup_->cast.team(side)) {
      commands_[base::index(slot)] = stand();
      MatchPlayer* player = training::match_player(*setup_, others_, slot);
      if (player != nullptr) decide(others_.drivers[base::index(slot)], *player);
    }
  }

  for (std::size_t agent = 0; agent < tables_.size(); ++agent) {
    if (alive(agent)) play_option(agent, player::kAutoOption, true);
  }

  clear_contacts();
  send_commands();
  execute_commands(nullptr);
  simulator::step(world_, events_);
  show(frame, setup_->cast, world_);
  simulator::finish_step(world_, events_);
  perceive_step();
  find_agent_options();
  events_.clear();
}

// Memory, knowledge and scenes of the first state.
void Episode::begin() {
  mode_start_ = world_.clock;
  memory_.previous_ball = world_.ball.position;
  begin_rewards(world_, setup_->cast, reward_memory_);
  rewards_ = {};

  begin_others(*setup_, world_, events_, senses_, others_);
  perceivers_ = setup_->perceivers;
  for (player::ActionMemory& memory : memories_) memory = {};
  for (std::size_t agent = 0; agent < perceivers_.size(); ++agent) {
    begin_perception(*setup_->vision, world_, events_, setup_->cast.agents[agent],
                     perceivers_[agent], senses_);
  }
  events_.clear();

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
  for (const Side side : soccer::kBothSides) {
    if (setup_->cast.team(side).empty()) continue;
    Scene& scene = scenes_[side];
    fill_scene(world_, side, setup_->cast, scene);
    scene.mode_age = cycles_between(mode_start_, world_.clock);
    const bool touched = memory_.holder != simulator::kNoPlayer;
    scene.last_touch_side = touched ? soccer::side_of_slot(memory_.holder) : Side::kNeutral;
    scene.last_touch = touched ? seat_of(side, memory_.holder) : kNoSeat;
    if (setup_->observes[side]) complete_for_observers(scenes_[side]);
  }
  for (std::size_t agent = 0; agent < perceivers_.size(); ++agent) {
    fill_scene(perceivers_[agent].world, setup_->cast, estimated_[agent]);
  }
  find_agent_options();
}

void Episode::find_agent_options() {
  for (std::size_t agent = 0; agent < tables_.size(); ++agent) {
    if (alive(agent)) {
      find_options(perceivers_[agent].world, memories_[agent], tables_[agent]);
    } else {
      tables_[agent].choice = player::OptionTable::Choice::kNothing;
    }
  }
}

double Episode::time_left() const {
  return 1.0 - static_cast<double>(memory_.cycles) / setup_->max_cycles;
}

int Episode::agent_in(int slot) const {
  const std::vector<int>& agents = setup_->cast.agents;
  const auto place = std::ranges::find(agents, slot);
  return place == agents.end() ? -1 : static_cast<int>(place - agents.begin());
}

PointOfView Episode::view_of(int slot, bool last_action_worked) const {
  const Side side = soccer::side_of_slot(slot);
  const int agent = has_world_models() ? agent_in(slot) : -1;
  PointOfView view{agent >= 0 ? estimated_[base::index(agent)] : scenes_[side],
                   setup_->cast,
                   seat_of(side, slot),
                   setup_->task->stage(side),
                   last_action_worked,
                   time_left()};
  if (agent >= 0 && !tables_.empty()) {
    view.world = &perceivers_[base::index(agent)].world;
    view.options = &tables_[base::index(agent)];
  }
  return view;
}

void Episode::step(const AgentActions& actions, simulator::MatchRecorder* recorder) {
  std::fill_n(rewards_.begin(), setup_->agent_count(), RewardValues{});
  for (int i = 0; i < setup_->frame_skip && !ended(); ++i) {
    const int holder = memory_.holder;
    const soccer::PlayMode mode = world_.mode;
    choose_commands(actions, nullptr, i == 0);
    play_cycle(recorder);
    if (setup_->until == Until::kDecision && has_decision(holder, mode)) break;
  }
}

void Episode::step_with(const Guest& guest) {
  choose_commands({}, &guest, true);
  play_cycle(nullptr);
}

// Whether another player has the ball or the mode is another one than before the cycle, or an agent
// knows that it can kick; of those with options, that it has a choice then.
bool Episode::has_decision(int holder, soccer::PlayMode mode) const {
  if (memory_.holder != holder || world_.mode != mode) return true;
  if (!tables_.empty()) {
    return std::ranges::any_of(tables_, [](const player::OptionTable& table) {
      return table.choice == player::OptionTable::Choice::kWithBall;
    });
  }
  return std::ranges::any_of(setup_->cast.agents, [this](int slot) {
    const PointOfView view = view_of(slot, true);
    return world_.player(slot).enabled && can_kick(view.scene, view.self);
  });
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

  const auto id = base::index(actions.ids[agent * setup_->id_width()]);
  const Action& action = set.actions[id];
  if (action.legal != nullptr && !action.legal(view)) {
    ++agents_[agent].illegal;
    agents_[agent].last_action_worked = false;
    return stand();
  }

  clip(base::index(setup_->offsets[id]), action.parameters.size());
  return action.command(view, clipped.data());
}

// A choice holds for all cycles of a step, as far as it is legal in them; whether it was legal
// counts in the first one.
void Episode::play_option(std::size_t agent, int id, bool first) {
  const player::OptionTable& table = tables_[agent];
  agents_[agent].last_action_worked = table.legal[base::index(id)];
  if (first && !agents_[agent].last_action_worked) ++agents_[agent].illegal;

  Perceiver& senses = perceivers_[agent];
  decide_with([&](player::ActionContext& context) { player::play_option(context, table, id); },
              senses, memories_[agent]);
  for (const PlayerCommand& command : senses.commands) {
    if (const auto* dash = std::get_if<soccer::Dash>(&command)) {
      add_effort(dash->power, rewards_[agent]);
    }
  }
}

// `first`: the first cycle of a step.
void Episode::choose_commands(const AgentActions& actions, const Guest* guest, bool first) {
  const Cast& cast = setup_->cast;
  for (std::size_t agent = 0; agent < cast.agents.size(); ++agent) {
    const int slot = cast.agents[agent];
    if (!world_.player(slot).enabled) continue;
    if (!tables_.empty()) {
      play_option(agent, actions.ids[agent], first);
      continue;
    }
    PlayerCommand& command = commands_[base::index(slot)];
    command = command_of(agent, actions);
    if (setup_->senses.any()) {
      const std::int32_t* row = actions.ids + agent * setup_->id_width();
      perceivers_[agent].chosen = read_senses(setup_->senses, row + 1);
    }
    if (const auto* dash = std::get_if<soccer::Dash>(&command)) {
      add_effort(dash->power, rewards_[agent]);
    }
  }

  for (const Side side : soccer::kBothSides) {
    std::optional<TeamSituation> situation;  // of the scripted players, if there is one
    for (const int slot : cast.team(side)) {
      const auto i = base::index(slot);
      if (setup_->is_agent[i] || !world_.player(slot).enabled) continue;
      commands_[i] = driven_command(slot, guest, situation);
    }
  }
}

PlayerCommand Episode::driven_command(int slot, const Guest* guest,
                                      std::optional<TeamSituation>& situation) {
  const Driver driver = others_.drivers[base::index(slot)];
  if (driver == Driver::kScripted) {
    const PointOfView view = view_of(slot, true);
    if (!situation) situation = assess(view.scene, view.cast);
    return scripted_command(view, *situation);
  }
  if (MatchPlayer* player = training::match_player(*setup_, others_, slot)) {
    if (guest != nullptr && guest->slot == slot) {
      guest->decide(*player);
    } else {
      decide(driver, *player);
    }
  }
  return stand();
}

// Before a kick-off all players move to the formation; the agents have no action for it.
void Episode::return_to_formation() {
  for (const Side side : soccer::kBothSides) {
    for (const int slot : setup_->cast.team(side)) {
      const Vec2 place = kick_off_position(slot) * soccer::sign(side);
      commands_[base::index(slot)] = soccer::Move{place.x, place.y};
    }
  }
}

std::span<const PlayerCommand> Episode::commands(int slot) const {
  const int agent = has_world_models() ? agent_in(slot) : -1;
  if (agent >= 0) return perceivers_[base::index(agent)].commands;
  if (const MatchPlayer* player = match_player(slot)) return player->senses.commands;
  return {&commands_[base::index(slot)], 1};
}

void Episode::send_commands() {
  for (const Side side : soccer::kBothSides) {
    for (const int slot : setup_->cast.team(side)) {
      round_numbers(commands_[base::index(slot)]);
    }
  }
  for (std::size_t agent = 0; agent < perceivers_.size() && tables_.empty(); ++agent) {
    const auto slot = base::index(setup_->cast.agents[agent]);
    if (!training::choose_commands(perceivers_[agent], commands_[slot])) {
      agents_[agent].last_action_worked = false;
    }
  }
}

// In the order that a match server draws for this cycle.
void Episode::execute_commands(simulator::MatchRecorder* recorder) {
  std::array<simulator::Slot, soccer::kPlayersOnPitch> order;
  std::iota(order.begin(), order.end(), 0);
  simulator::clock_stream(world_, "command order", 0).shuffle(std::span<simulator::Slot>(order));
  for (const simulator::Slot slot : order) {
    if (!world_.player(slot).enabled) continue;
    if (recorder != nullptr) record_commands(commands(slot), world_, slot, *recorder);
    for (const PlayerCommand& command : commands(slot)) {
      const std::size_t before = events_.size();
      simulator::apply(world_, slot, command, events_);
      if (recorder != nullptr) record_messages(events_, before, *recorder);
      queue_says(before);
    }
  }
}

// Queues the messages for every player in earshot.
void Episode::queue_says(std::size_t first_event) {
  training::queue_says(*setup_, world_, events_, first_event, others_);
  for (std::size_t i = first_event; i < events_.size() && has_world_models(); ++i) {
    const auto* said = std::get_if<simulator::PlayerSaid>(&events_[i].what);
    for (std::size_t agent = 0; said != nullptr && agent < perceivers_.size(); ++agent) {
      queue_say(world_, *said, setup_->cast.agents[agent], perceivers_[agent].said);
    }
  }
}

void Episode::play_cycle(simulator::MatchRecorder* recorder) {
  if (setup_->task->referee && allows_moves(world_.mode)) return_to_formation();

  const std::array<int, 2> score = memory_.score;
  const soccer::PlayMode mode = world_.mode;
  // A match server does the same after the senses: a catch or a move may give contacts before the
  // step.
  clear_contacts();
  send_commands();
  execute_commands(recorder);

  const std::size_t before = events_.size();
  simulator::step(world_, events_);
  if (recorder != nullptr) recorder->step(world_);
  simulator::finish_step(world_, events_);
  if (recorder != nullptr) record_messages(events_, before, *recorder);

  if (world_.mode != mode) mode_start_ = world_.clock;
  perceive_step();
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

void Episode::clear_contacts() {
  for (simulator::Player& player : world_.players) {
    if (player.enabled) player.contacts = {};
  }
}

void Episode::perceive_step() {
  for (std::size_t agent = 0; agent < perceivers_.size(); ++agent) {
    perceive(*setup_->vision, world_, events_, setup_->cast.agents[agent], perceivers_[agent],
             senses_);
  }
  perceive_others(*setup_, world_, events_, senses_, others_);
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

void Episode::observe(float* out) const {
  std::fill_n(out, setup_->agent_count() * setup_->feature_count(), 0.0F);
  std::optional<Openings> openings;
  const Scene* scene = nullptr;  // of the openings

  for (std::size_t agent = 0; agent < setup_->agent_count();
       ++agent, out += setup_->feature_count()) {
    if (!alive(agent)) continue;
    PointOfView view = view_of(setup_->cast.agents[agent], agents_[agent].last_action_worked);

    // Agents of a team stand together in the cast, and share the scene unless they estimate it.
    if (setup_->features->needs_openings) {
      if (scene != &view.scene) openings.emplace(view.scene, setup_->cast);
      scene = &view.scene;
      view.openings = &*openings;
    }
    setup_->features->fill(view, out);
    if (setup_->senses.any()) {
      const std::size_t first = setup_->feature_count() - setup_->sense_column_count;
      fill_senses(perceivers_[agent], setup_->senses, out + first);
    }
  }
}

int Episode::expert(std::size_t agent) const {
  if (tables_.empty() || !alive(agent)) return -1;
  return planner_option(perceivers_[agent].world, tables_[agent], planner_options());
}

void Episode::mask(std::size_t agent, std::uint8_t* out) const {
  if (alive(agent)) {
    setup_->legality.fill(view_of(setup_->cast.agents[agent], true), out);
  } else {
    std::fill_n(out, setup_->id_count(), std::uint8_t{0});
  }
}

void Episode::state(float* out) const {
  fill_state(world_, setup_->cast, setup_->state_version, time_left(), out);
}

}  // namespace cls::training
