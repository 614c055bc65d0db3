// One episode: a copyable value that depends on setup, options, seed and actions only.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "player/options/options.h"
#include "simulator/sessions/match_recorder.h"
#include "simulator/world/event.h"
#include "training/episode/others.h"
#include "training/episode/start.h"
#include "training/npc/scripted.h"

namespace cls::training {

/// Actions of the agents of one world: ids [A, id_width()] and values [A, V]; null if the set has
/// none. They have been checked: ids exist and values are finite.
struct AgentActions {
  const std::int32_t* ids = nullptr;
  const float* values = nullptr;
};

/// Copy it to take a snapshot, assign it to restore or fork. Does not allocate after the first
/// step.
class Episode {
 public:
  explicit Episode(std::shared_ptr<const Setup> setup);

  void reset(std::uint64_t seed, const OptionValues& options);
  /// Starts at the last frame of `start` instead, which has one or more.
  void reset_at(std::uint64_t seed, const OptionValues& options, const Start& start);

  /// Plays frame_skip cycles, or until the end. The episode must be running. `recorder` (may be
  /// null) receives every frame.
  void step(const AgentActions& actions, simulator::MatchRecorder* recorder);

  /// The commands of one player for a cycle, instead of its driver's: fills senses.commands. The
  /// player must be one that perceives.
  struct Guest {
    int slot = 0;
    const std::function<void(MatchPlayer&)>& decide;
  };
  /// Plays one cycle without agents, with the guest's decision.
  void step_with(const Guest& guest);

  bool started() const { return started_; }
  bool ended() const { return status_ != Status::kInGame; }
  Status status() const { return status_; }
  std::uint64_t seed() const { return world_.seed; }
  int cycles() const { return memory_.cycles; }
  std::array<int, 2> score() const { return memory_.score; }
  /// Index of the opponents' driver in Setup::opponents; -1 without opponents.
  int opponent() const { return others_.opponent; }
  const simulator::World& world() const { return world_; }

  bool alive(std::size_t agent) const;
  int illegal(std::size_t agent) const { return agents_[agent].illegal; }
  /// The agent's weighted reward of the last step.
  double reward(std::size_t agent) const;
  /// The mean of a term of the reward over the agents, as the left team sees it.
  double reward_term(std::size_t term) const;

  /// The commands of the last cycle of a player in `slot`, in the order of execution: what a client
  /// would have sent.
  std::span<const PlayerCommand> commands(int slot) const;
  /// The estimates of an agent; null with the full state.
  const player::WorldModel* world_model(std::size_t agent) const {
    return has_world_models() ? &perceivers_[agent].world : nullptr;
  }
  /// The player in `slot` if its driver perceives; else null.
  const MatchPlayer* match_player(int slot) const {
    return training::match_player(*setup_, others_, slot);
  }

  /// Writes the features of all agents, one after the other; zeros for those who are not alive.
  void observe(float* out) const;
  /// The id that the planner of cls would choose from the agent's world model; -1 where there is
  /// nothing to choose. For agents with options.
  int expert(std::size_t agent) const;
  /// Writes 1 for each id that has an effect now.
  void mask(std::size_t agent, std::uint8_t* out) const;
  void state(float* out) const;

 private:
  struct Agent {
    bool last_action_worked = true;
    int illegal = 0;
  };

  soccer::RandomStream clear(std::uint64_t seed, const OptionValues& options);
  void begin_at(const Start& start);
  void begin();
  bool has_decision(int holder, soccer::PlayMode mode) const;
  void perceive_frame(const StartFrame& frame);
  void play_cycle(simulator::MatchRecorder* recorder);
  void draw_types(soccer::RandomStream& random);
  bool has_world_models() const { return !perceivers_.empty(); }
  void find_agent_options();
  void play_option(std::size_t agent, int id, bool first);
  /// Index of the agent in `slot`; -1 for other players.
  int agent_in(int slot) const;
  void send_commands();
  void clear_contacts();
  void perceive_step();
  void queue_says(std::size_t first_event);
  PlayerCommand driven_command(int slot, const Guest* guest,
                               std::optional<TeamSituation>& situation);
  PlayerCommand command_of(std::size_t agent, const AgentActions& actions);
  PointOfView view_of(int slot, bool last_action_worked) const;
  void choose_commands(const AgentActions& actions, const Guest* guest, bool first);
  void return_to_formation();
  void execute_commands(simulator::MatchRecorder* recorder);
  void fill_scenes();
  double time_left() const;

  std::shared_ptr<const Setup> setup_;
  simulator::World world_;
  TaskMemory memory_;
  simulator::Clock mode_start_;  ///< when the play mode changed
  RewardMemory reward_memory_;
  OptionValues options_{};
  Status status_ = Status::kInGame;
  bool started_ = false;
  soccer::PerSide<Scene> scenes_;               ///< exact
  std::vector<Perceiver> perceivers_;           ///< of the agents; may be empty
  std::vector<Scene> estimated_;                ///< by agent, from their world models
  std::vector<player::ActionMemory> memories_;  ///< of agents with options, else empty
  std::vector<player::OptionTable> tables_;     ///< what they may choose now
  Others others_;
  std::array<Agent, soccer::kPlayersOnPitch> agents_{};  ///< in the order of the cast
  std::array<RewardValues, soccer::kPlayersOnPitch> rewards_{};
  std::array<PlayerCommand, soccer::kPlayersOnPitch> commands_;  ///< by slot
  simulator::Events events_;
  SenseBuffers senses_;
};

}  // namespace cls::training
