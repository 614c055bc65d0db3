// Builds what all episodes of a pool share.
#include "training/episode/setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "analysis/situations/book_file.h"
#include "base/index.h"
#include "base/text/suggestion.h"
#include "simulator/actions/actions.h"
#include "simulator/world/rules.h"
#include "training/features/sense_features.h"

namespace cls::training {
namespace {

using base::Error;
using base::Result;

constexpr int kClientVersion = 18;

template <typename Item, typename Name>
Error unknown(std::string_view what, std::string_view word, const std::vector<Item>& items,
              Name name) {
  std::vector<std::string_view> names;
  for (const Item& item : items) names.push_back(name(item));
  return {fmt::format("unknown {} '{}'{}", what, word, base::did_you_mean(word, names))};
}

Result<const Task*> choose_task(const std::string& id) {
  if (const Task* task = find_task(id)) return task;
  return unknown("task", id, tasks(), [](const Task& task) { return task.id; });
}

Result<const FeatureSet*> choose_features(const std::string& name) {
  if (const FeatureSet* set = find_feature_set(name)) return set;
  return unknown("feature set", name, feature_sets(), [](const auto* set) { return set->name; });
}

Result<const ActionSet*> choose_actions(const std::string& name) {
  if (const ActionSet* set = find_action_set(name)) return set;
  return unknown("action set", name, action_sets(), [](const auto* set) { return set->name; });
}

Result<int> choose_count(std::string_view key, int wanted, const Task& task, const Range& range) {
  const int count = wanted < 0 ? range.usual : wanted;
  if (count >= range.low && count <= range.high) return count;
  return Error{fmt::format("'{}' must be {}..{} for the task {}, not {}", key, range.low,
                           range.high, task.id, count)};
}

bool plays(Agents agents, Side side) {
  return agents == Agents::kBoth || (agents == Agents::kLeft) == (side == Side::kLeft);
}

// Chooses the drivers of all players that are not agents.
void choose_drivers(const SetupChoices& choices, Agents agents, Setup& setup) {
  for (const Side side : soccer::kBothSides) {
    const bool own = plays(agents, side);
    for (const int slot : setup.cast.team(side)) {
      const auto i = base::index(slot);
      setup.is_opponent[i] = !own;
      if (!own) setup.opponents = choices.opponents;
      if (own && !setup.is_agent[i]) setup.teammates = choices.teammates;
    }
  }
}

Result<void> choose_cast(const SetupChoices& choices, Setup& setup) {
  const Task& task = *setup.task;
  TRY_INIT(int left, choose_count("offense", choices.offense, task, task.offense));
  TRY_INIT(int right, choose_count("defense", choices.defense, task, task.defense));

  const Agents agents = choices.agents < 0 ? task.agents : static_cast<Agents>(choices.agents);
  if (choices.opponents.empty() && !plays(agents, Side::kLeft)) left = 0;
  if (choices.opponents.empty() && !plays(agents, Side::kRight)) right = 0;

  setup.cast.left = team_slots(task, Side::kLeft, left);
  setup.cast.right = team_slots(task, Side::kRight, right);
  for (const Side side : soccer::kBothSides) {
    const std::vector<int>& team = setup.cast.team(side);
    const int most = static_cast<int>(team.size());
    const int wanted = choices.num_agents < 0 ? most : choices.num_agents;

    if (!plays(agents, side)) continue;
    if (wanted < 1 || wanted > most) {
      return Error{
          fmt::format("'num_agents' must be 1..{}, the size of the team, not {}", most, wanted)};
    }

    const bool has_goalie = side == Side::kRight ? task.right_goalie : task.referee;
    const int first = has_goalie && !choices.goalie_agent && wanted < most ? 1 : 0;
    setup.cast.agents.insert(setup.cast.agents.end(), team.begin() + first,
                             team.begin() + first + wanted);
  }

  for (const int slot : setup.cast.agents) setup.is_agent[base::index(slot)] = true;
  choose_drivers(choices, agents, setup);
  return {};
}

// Choices of senses are messages to a server, and numbers beside an id.
Result<void> choose_senses(const SetupChoices& choices, Setup& setup) {
  setup.senses = choices.senses;
  setup.expert = choices.expert == Expert::kPlanner;
  setup.sense_heads = sense_heads(choices.senses);
  if (!choices.senses.any()) return {};

  const std::string_view name = choices.senses.look ? "look" : "say";
  if (choices.fidelity != Fidelity::kWorldModel) {
    return Error{
        fmt::format("'{}' needs 'obs' = 'world_model': who knows the full state neither "
                    "looks nor hears",
                    name)};
  }
  if (setup.actions->actions.empty()) {
    return Error{
        fmt::format("'{}' needs actions with ids, which '{}' has not; use 'low_discrete' "
                    "or 'skills'",
                    name, setup.actions->name)};
  }
  return {};
}

// Options are what a player of a match chooses, from its own world model.
Result<void> choose_options(const SetupChoices& choices, const Setup& setup) {
  if (setup.features->needs_options && !setup.actions->options) {
    return Error{fmt::format("the feature set '{}' needs the actions 'options', not '{}'",
                             setup.features->name, setup.actions->name)};
  }
  if (setup.expert && !setup.actions->options) {
    return Error{fmt::format("'expert' = 'planner' needs the actions 'options', not '{}'",
                             setup.actions->name)};
  }
  if (!setup.actions->options) return {};
  if (choices.fidelity != Fidelity::kWorldModel) {
    return Error{"the actions 'options' need 'obs' = 'world_model'"};
  }
  if (setup.senses.any()) return Error{"the actions 'options' look and speak by themselves"};
  return {};
}

Result<void> choose_sets(const SetupChoices& choices, Setup& setup) {
  const Task& task = *setup.task;
  const auto or_usual = [](const std::string& name, std::string_view usual) {
    return name.empty() ? std::string(usual) : name;
  };

  TRY_INIT(setup.features, choose_features(or_usual(choices.features, task.features)));
  TRY_INIT(setup.actions, choose_actions(or_usual(choices.actions, task.actions)));
  TRY(choose_senses(choices, setup));
  TRY(choose_options(choices, setup));

  const auto has_agents = [&](Side side) {
    return std::ranges::find(setup.cast.agents, side, soccer::side_of_slot) !=
           setup.cast.agents.end();
  };
  if (setup.features->left_only && has_agents(Side::kRight)) {
    return Error{fmt::format("the feature set '{}' is for attackers only; use hfo_high or ego",
                             setup.features->name)};
  }

  // All rows are equally wide: each team's own columns come first, zeros fill the rest.
  for (const Side side : soccer::kBothSides) {
    const int own = static_cast<int>(setup.cast.team(side).size());
    const int others = static_cast<int>(setup.cast.others(side).size());
    if (!has_agents(side)) continue;
    Columns columns = setup.features->columns(own - 1, others);
    if (columns.size() > setup.feature_columns.size()) setup.feature_columns = std::move(columns);
  }

  const Columns own_senses = sense_columns(setup.senses);
  setup.sense_column_count = own_senses.size();
  setup.feature_columns.insert(setup.feature_columns.end(), own_senses.begin(), own_senses.end());

  setup.value_columns = setup.actions->values();
  setup.offsets = setup.actions->offsets();
  setup.legality = Legality(*setup.actions);
  setup.state_version = choices.state;
  setup.state_columns = state_columns(setup.cast, setup.state_version);
  return {};
}

soccer::ServerParams server_params(const Task& task) {
  soccer::ServerParams server;
  server.synch_mode = true;
  if (task.referee) {
    server.auto_mode = true;
    server.kick_off_wait = 10;
    server.connect_wait = 10;
    server.penalty_shoot_outs = false;
    server.nr_extra_halfs = 0;
  } else {
    // A trainer's match: no rule but the task's, and no end.
    server.coach = true;
    server.coach_w_referee = false;
  }
  return server;
}

// Connects the players of the cast, of whom those in `goalies` (slots, or -1) keep goal.
void prepare_world(std::shared_ptr<const simulator::Rules> rules, soccer::PerSide<int> goalies,
                   Setup& setup) {
  simulator::World& world = setup.prepared;
  world = simulator::make_world(std::move(rules), kTypesSeed);

  for (const Side side : soccer::kBothSides) {
    simulator::Team& team = world.team(side);
    team.name = soccer::TeamName(side == Side::kLeft ? "left" : "right");
    team.connected = true;
    for (const int slot : setup.cast.team(side)) {
      simulator::Player& player = world.player(slot);
      player.joined = player.enabled = true;
      player.goalie = slot == goalies[side];
      player.client_version = kClientVersion;
      player.view.synchronous = true;
      player.state = simulator::state::kStand | (player.goalie ? simulator::state::kGoalie : 0);
    }
  }

  if (!setup.task->referee) world.mode = soccer::PlayMode::kPlayOn;
}

// The slots of the goalies of a task.
soccer::PerSide<int> goalies_of(const Task& task, const Cast& cast) {
  const auto first = [](bool keeps, const std::vector<int>& team) {
    return keeps && !team.empty() ? team.front() : -1;
  };
  return {first(task.referee, cast.left), first(task.right_goalie, cast.right)};
}

// Books have eleven players of each team and set plays, so that only tasks with a referee play
// them.
Result<void> choose_start(const SetupChoices& choices, Setup& setup) {
  constexpr std::string_view kBook = "book:";
  setup.start = choices.start;
  if (choices.start == "task") return {};

  if (!choices.start.starts_with(kBook)) {
    return Error{fmt::format("'start' must be 'task' or 'book:FILE', not '{}'", choices.start)};
  }
  if (!setup.task->referee) {
    return Error{fmt::format("'start': the task {} has places of its own; a book is for Match",
                             setup.task->id)};
  }

  auto book = analysis::read_book(choices.start.substr(kBook.size()));
  if (!book) return Error{"'start': " + book.error().message};
  setup.book = std::make_shared<const analysis::Book>(std::move(*book));
  return {};
}

bool may_perceive(const DriverPool& pool) {
  return std::ranges::any_of(
      pool, [](const DriverShare& share) { return share.weight > 0.0 && perceives(share.driver); });
}

// The agents of cls do not listen to opponents.
void stop_ears(Setup& setup) {
  const soccer::Ear off{
      false, soccer::TeamReference{soccer::TeamReference::Kind::kOpponent, ""}, {}};
  simulator::Events none;
  for (simulator::Player& player : setup.prepared.players) {
    if (player.enabled) simulator::apply(setup.prepared, player.slot(), off, none);
  }
}

void prepare_senses(Setup& setup) {
  setup.match_player_of.fill(-1);
  for (const int slot : setup.cast.agents) {
    if (setup.fidelity == Fidelity::kWorldModel) {
      setup.perceivers.push_back(make_perceiver(setup.prepared, slot));
      setup.perceivers.back().decides = setup.actions->options;
    } else {
      setup.observes[soccer::side_of_slot(slot)] = true;
    }
  }

  for (const Side side : soccer::kBothSides) {
    for (const int slot : setup.cast.team(side)) {
      const auto i = base::index(slot);
      if (setup.is_agent[i]) continue;
      if (!may_perceive(setup.is_opponent[i] ? setup.opponents : setup.teammates)) continue;
      setup.match_player_of[i] = static_cast<int>(setup.match_players.size());
      setup.match_players.push_back({make_perceiver(setup.prepared, slot), {}});
    }
  }

  if (setup.perceivers.empty() && setup.match_players.empty()) return;
  stop_ears(setup);
  setup.vision = std::make_shared<simulator::VisionModel>(setup.prepared.params());
}

}  // namespace

std::string agent_name(int slot) {
  return fmt::format("{}_{}", soccer::side_name(soccer::side_of_slot(slot)),
                     soccer::unum_of_slot(slot));
}

Result<std::shared_ptr<const Setup>> make_setup(const SetupChoices& choices) {
  auto setup = std::make_shared<Setup>();
  TRY_INIT(setup->task, choose_task(choices.task));
  TRY(choose_cast(choices, *setup));
  TRY(choose_sets(choices, *setup));
  TRY(choose_start(choices, *setup));

  setup->weights = choices.weights;
  setup->frame_skip = choices.frame_skip;
  setup->until = choices.until;
  if (setup->until == Until::kDecision && setup->frame_skip < 2) {
    return Error{"'until' = 'decision' needs 'frame_skip' from 2 on, the most cycles of a step"};
  }
  setup->max_cycles = choices.max_cycles > 0 ? choices.max_cycles : setup->task->max_cycles;
  setup->random_types = choices.random_types;
  setup->options = setup->task->usual_options();

  TRY_INIT(auto rules, simulator::make_rules(server_params(*setup->task), {}, kTypesSeed));
  prepare_world(std::move(rules), goalies_of(*setup->task, setup->cast), *setup);
  setup->fidelity = choices.fidelity;
  prepare_senses(*setup);

  return std::shared_ptr<const Setup>(std::move(setup));
}

std::shared_ptr<const Setup> make_watched_setup(std::shared_ptr<const simulator::Rules> rules,
                                                soccer::PerSide<Driver> drivers,
                                                soccer::PerSide<int> goalies) {
  auto setup = std::make_shared<Setup>();
  setup->task = find_task("Match");
  setup->cast.left = team_slots(*setup->task, Side::kLeft, soccer::kPlayersPerTeam);
  setup->cast.right = team_slots(*setup->task, Side::kRight, soccer::kPlayersPerTeam);
  setup->teammates = {{drivers.left}};
  setup->opponents = {{drivers.right}};
  for (const int slot : setup->cast.right) setup->is_opponent[base::index(slot)] = true;

  setup->features = find_feature_set(setup->task->features);
  setup->actions = find_action_set(setup->task->actions);
  setup->max_cycles = setup->task->max_cycles;
  setup->options = setup->task->usual_options();
  prepare_world(std::move(rules), goalies, *setup);
  prepare_senses(*setup);

  return setup;
}

}  // namespace cls::training
