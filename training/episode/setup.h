// Everything that is the same in all episodes of a pool.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "simulator/world/world.h"
#include "soccer/per_side.h"
#include "training/actions/action_set.h"
#include "training/episode/reward.h"
#include "training/features/feature_set.h"
#include "training/npc/driver.h"
#include "training/senses/perceiver.h"
#include "training/tasks/task.h"

namespace cls::analysis {
struct Book;
}

namespace cls::training {

/// The knowledge of agents. Never mixed in a pool; players of matches do not know the full state.
enum class Fidelity : unsigned char {
  kFullState,   ///< the exact world, without messages
  kWorldModel,  ///< the estimates of cls agents, from the messages of the server
};
constexpr auto kFidelityNames = base::enum_names<Fidelity>("full_state", "world_model");

/// When a step ends.
enum class Until : unsigned char {
  kCycles,    ///< after frame_skip cycles
  kDecision,  ///< or earlier, when there is something to decide
};
constexpr auto kUntilNames = base::enum_names<Until>("cycles", "decision");

/// Who says in each step what it would choose for an agent.
enum class Expert : unsigned char { kNone, kPlanner };
constexpr auto kExpertNames = base::enum_names<Expert>("none", "planner");

/// From which the player types of all pools are drawn.
constexpr std::uint64_t kTypesSeed = 1;

/// Choices of the caller. Counts of -1 and empty names mean the task's defaults.
struct SetupChoices {
  std::string task;
  std::string features;
  std::string actions;
  std::string start = "task";  ///< or "book:FILE"
  int offense = -1;
  int defense = -1;
  int num_agents = -1;
  bool goalie_agent = false;               ///< with num_agents below the size of the team
  int agents = -1;                         ///< an Agents, or -1
  DriverPool teammates = {DriverShare{}};  ///< not empty
  DriverPool opponents = {DriverShare{}};  ///< empty: there are none
  Fidelity fidelity = Fidelity::kFullState;
  int state = 1;  ///< version of the full state
  int frame_skip = 1;
  Until until = Until::kCycles;
  int max_cycles = 0;
  std::array<double, kRewardTerms> weights{};
  bool random_types = false;
  SenseOptions senses;
  Expert expert = Expert::kNone;
};

/// Immutable; shared by the episodes of a pool and by their copies.
struct Setup {
  const Task* task = nullptr;
  Cast cast;
  DriverPool teammates;  ///< of players of the agents' team that are not agents; empty: none
  DriverPool opponents;  ///< empty: none
  std::array<bool, soccer::kPlayersOnPitch> is_agent{};
  soccer::PerSide<bool> observes;  ///< agents of the team read the exact scene
  std::array<bool, soccer::kPlayersOnPitch> is_opponent{};  ///< of the agents; none with both teams
  const FeatureSet* features = nullptr;
  const ActionSet* actions = nullptr;
  Columns feature_columns;  ///< of an agent; the widest if the teams differ in size
  SenseOptions senses;
  bool expert = false;  ///< Episode::expert() is asked in each step
  std::vector<SenseHead> sense_heads;
  std::size_t sense_column_count = 0;  ///< the last of feature_columns
  Columns value_columns;
  std::vector<int> offsets;  ///< first value of each action
  Legality legality;
  int state_version = 1;
  Columns state_columns;
  std::array<double, kRewardTerms> weights{};
  int frame_skip = 1;
  Until until = Until::kCycles;
  int max_cycles = 0;
  bool random_types = false;
  OptionValues options{};                      ///< defaults of the task
  std::string start;                           ///< as chosen
  std::shared_ptr<const analysis::Book> book;  ///< from which episodes start; null: not
  simulator::World prepared;                   ///< all players of the cast on the pitch, at rest
  Fidelity fidelity = Fidelity::kFullState;
  std::vector<Perceiver> perceivers;  ///< of the agents, connected; empty with the full state
  /// Connected players that drivers may play who perceive; by match_player_of.
  std::vector<MatchPlayer> match_players;
  std::array<int, soccer::kPlayersOnPitch> match_player_of{};  ///< by slot; -1: none
  std::shared_ptr<const simulator::VisionModel> vision;        ///< null if no player perceives

  std::size_t agent_count() const { return cast.agents.size(); }
  std::size_t feature_count() const { return feature_columns.size(); }
  std::size_t value_count() const { return value_columns.size(); }
  std::size_t id_count() const { return actions->actions.size(); }
  /// Numbers of an agent's row of ids: the action, then one for each of sense_heads.
  std::size_t id_width() const { return id_count() == 0 ? 0 : 1 + sense_heads.size(); }
};

/// The error names the choice that does not fit the task.
base::Result<std::shared_ptr<const Setup>> make_setup(const SetupChoices& choices);

/// Eleven against eleven without agents, by the rules of a match: the drivers play both teams, and
/// the players in `goalies` (slots) keep goal.
std::shared_ptr<const Setup> make_watched_setup(std::shared_ptr<const simulator::Rules> rules,
                                                soccer::PerSide<Driver> drivers,
                                                soccer::PerSide<int> goalies);

/// "left_7"
std::string agent_name(int slot);

/// The full state of an episode as numbers, for critics that may see everything: in version 1 where
/// everything is, from version 2 on also what decides the future besides.
Columns state_columns(const Cast& cast, int version);
constexpr int kStateVersions = 2;

/// Writes as many numbers as there are columns, from the left team's view.
void fill_state(const simulator::World& world, const Cast& cast, int version, double time_left,
                float* out);

}  // namespace cls::training
