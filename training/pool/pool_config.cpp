// Parses configurations.
#include "training/pool/pool_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/text/json_document.h"

namespace cls::training {
namespace {

using base::Error;
using base::JsonDocument;
using base::JsonValue;
using base::Result;
using Names = std::vector<std::string_view>;

const Names kKeys = {"task",       "num_envs", "threads",      "obs",       "features",
                     "actions",    "offense",  "defense",      "agents",    "num_agents",
                     "teammates",  "opponent", "goalie_agent", "autoreset", "frame_skip",
                     "max_cycles", "reward",   "options",      "types"};
const Names kAutoresets = {"disabled", "next_step", "same_step"};
const Names kObservations = {"full_state", "world_model"};
const Names kAgents = {"offense", "defense", "both"};
const Names kTypes = {"default", "random"};

constexpr int kMaxEnvs = 65536;
constexpr int kMaxThreads = 256;
constexpr int kMaxFrameSkip = 100;
constexpr int kMaxCycles = 1000000;
constexpr double kMaxWeight = 1e6;

Result<DriverPool> parse_drivers(const JsonValue& value, bool or_none) {
  Names names(kDriverNames.begin(), kDriverNames.end());
  DriverPool pool;
  if (!value.is_object()) {
    if (or_none) names.push_back("none");
    const Result<std::string> name = value.one_of(names);
    if (!name) return name.error();
    const auto at =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), *name) - names.begin());
    if (at < kDriverNames.size()) pool.push_back({static_cast<Driver>(at), 1.0});
    return pool;
  }

  if (Result<void> known = value.expect_keys(names); !known) return known.error();
  double sum = 0.0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!value.has(names[i])) continue;
    const Result<double> weight = value[names[i]].number(0.0, kMaxWeight);
    if (!weight) return weight.error();
    pool.push_back({static_cast<Driver>(i), *weight});
    sum += *weight;
  }

  if (sum > 0.0) return pool;
  return value.error(fmt::format("needs a weight above 0 for one of {}", fmt::join(names, ", ")));
}

/// Reads members of an object; remembers the first error.
class Reader {
 public:
  explicit Reader(const JsonValue& object) : object_(object) {}

  void integer(std::string_view key, int low, int high, int& out) {
    if (wanted(key)) take(object_[key].integer(low, high), out);
  }
  void text(std::string_view key, std::string& out) {
    if (wanted(key)) take(object_[key].string(), out);
  }
  /// Index of the value in `names`.
  template <typename Enum>
  void choice(std::string_view key, const Names& names, Enum& out) {
    if (!wanted(key)) return;
    std::string name;
    take(object_[key].one_of(names), name);
    if (error.message.empty()) {
      out = static_cast<Enum>(std::find(names.begin(), names.end(), name) - names.begin());
    }
  }
  void flag(std::string_view key, bool& out) {
    if (wanted(key)) take(object_[key].boolean(), out);
  }
  /// The name of a driver, or an object of weights by name.
  void drivers(std::string_view key, bool or_none, DriverPool& out) {
    if (wanted(key)) take(parse_drivers(object_[key], or_none), out);
  }
  bool wanted(std::string_view key) const { return error.message.empty() && object_.has(key); }

  Error error;

 private:
  template <typename T>
  void take(Result<T> result, T& out) {
    if (result) {
      out = std::move(*result);
    } else {
      error = result.error();
    }
  }

  const JsonValue& object_;
};

Result<std::array<double, kRewardTerms>> parse_weights(const JsonValue& object) {
  Names names;
  for (const RewardTerm& term : reward_terms()) names.push_back(term.name);
  if (Result<void> known = object.expect_keys(names); !known) return known.error();

  std::array<double, kRewardTerms> weights = {};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!object.has(names[i])) continue;
    const Result<double> weight = object[names[i]].number(-kMaxWeight, kMaxWeight);
    if (!weight) return weight.error();
    weights[i] = *weight;
  }
  return weights;
}

Result<OptionValues> parse_options(const Task& task, const JsonValue& object, OptionValues values) {
  Names names;
  for (const TaskOption& option : task.options) names.push_back(option.name);
  if (Result<void> known = object.expect_keys(names); !known) return known.error();

  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!object.has(names[i])) continue;
    const TaskOption& option = task.options[i];
    const Result<double> value = object[names[i]].number(option.low, option.high);
    if (!value) return value.error();
    values[i] = *value;
  }
  return values;
}

SetupChoices usual_choices() {
  SetupChoices choices;
  for (std::size_t i = 0; i < kRewardTerms; ++i) choices.weights[i] = reward_terms()[i].weight;
  return choices;
}

void read_choices(Reader& in, SetupChoices& choices) {
  in.text("task", choices.task);
  in.text("features", choices.features);
  in.text("actions", choices.actions);
  in.integer("offense", 0, soccer::kPlayersPerTeam, choices.offense);
  in.integer("defense", 0, soccer::kPlayersPerTeam, choices.defense);
  in.choice("agents", kAgents, choices.agents);
  in.integer("num_agents", 1, soccer::kPlayersPerTeam, choices.num_agents);
  in.flag("goalie_agent", choices.goalie_agent);
  in.drivers("teammates", false, choices.teammates);
  in.drivers("opponent", true, choices.opponents);
  in.integer("frame_skip", 1, kMaxFrameSkip, choices.frame_skip);
  in.integer("max_cycles", 0, kMaxCycles, choices.max_cycles);
  in.choice("obs", kObservations, choices.fidelity);

  int types = 0;
  in.choice("types", kTypes, types);
  choices.random_types = types == 1;
}

}  // namespace

std::string_view fidelity_name(Fidelity fidelity) {
  return kObservations[static_cast<std::size_t>(fidelity)];
}

std::string_view autoreset_name(Autoreset mode) {
  return kAutoresets[static_cast<std::size_t>(mode)];
}

Result<PoolConfig> parse_pool_config(const std::string& json) {
  const Result<JsonDocument> document = JsonDocument::parse("configuration", json);
  if (!document) return document.error();
  const JsonValue root(*document);
  if (Result<void> known = root.expect_keys(kKeys); !known) return known.error();
  if (!root.has("task")) return root.error("the key 'task' is missing");

  PoolConfig config;
  SetupChoices choices = usual_choices();
  Reader in(root);
  read_choices(in, choices);
  in.integer("num_envs", 1, kMaxEnvs, config.num_envs);
  in.integer("threads", 1, kMaxThreads, config.threads);
  in.choice("autoreset", kAutoresets, config.autoreset);
  if (!in.error.message.empty()) return in.error;

  if (root.has("reward")) {
    TRY_INIT(auto weights, parse_weights(root["reward"]));
    choices.weights = weights;
  }

  auto setup = make_setup(choices);
  if (!setup) return Error{"configuration: " + setup.error().message};
  config.setup = std::move(*setup);
  config.options = config.setup->options;

  if (root.has("options")) {
    TRY_INIT(auto options, parse_options(*config.setup->task, root["options"], config.options));
    config.options = options;
  }
  return config;
}

Result<OptionValues> parse_options(const Task& task, const std::string& json, OptionValues values) {
  const Result<JsonDocument> document = JsonDocument::parse("options", json);
  if (!document) return document.error();
  return parse_options(task, JsonValue(*document), values);
}

}  // namespace cls::training
