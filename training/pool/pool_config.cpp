// Parses configurations.
#include "training/pool/pool_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/text/json.h"
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
                     "max_cycles", "reward",   "options",      "types",     "state",
                     "start",      "until",    "look",         "say",       "expert"};
constexpr auto kRandomTypesNames = base::enum_names<bool>("default", "random");

constexpr int kMaxEnvs = 65536;
constexpr int kMaxThreads = 256;
constexpr int kMaxFrameSkip = 100;
constexpr int kMaxCycles = 1000000;
constexpr double kMaxWeight = 1e6;

/// Calls `take` with the index and the value of each of `names` that the object has; it must not
/// have others. `range_of` gives the limits of the value of an index.
template <typename RangeOf, typename Take>
Result<void> read_numbers(const JsonValue& object, const Names& names, RangeOf range_of,
                          Take take) {
  TRY(object.expect_keys(names));
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!object.has(names[i])) continue;
    const auto [low, high] = range_of(i);
    TRY_INIT(const double number, object[names[i]].number(low, high));
    take(i, number);
  }
  return {};
}

Result<DriverPool> parse_drivers(const JsonValue& value, bool or_none) {
  Names names(kDriverNames.texts.begin(), kDriverNames.texts.end());
  DriverPool pool;
  if (!value.is_object()) {
    if (or_none) names.push_back("none");
    TRY_INIT(const std::string name, value.one_of(names));
    if (const auto driver = kDriverNames.parse(name)) pool.push_back({*driver, 1.0});
    return pool;
  }

  double sum = 0.0;
  TRY(read_numbers(
      value, names,
      [](std::size_t) {
        return std::pair{0.0, kMaxWeight};
      },
      [&](std::size_t i, double weight) {
        pool.push_back({static_cast<Driver>(i), weight});
        sum += weight;
      }));
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
  /// The value with one of `names`, in its own type or as a number.
  template <typename Enum, std::size_t kCount, typename Out>
  void choice(std::string_view key, const base::EnumNames<Enum, kCount>& names, Out& out) {
    if (!wanted(key)) return;
    std::string name;
    take(object_[key].one_of({names.texts.begin(), names.texts.end()}), name);
    if (const auto value = names.parse(name)) out = static_cast<Out>(*value);
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
  std::array<double, kRewardTerms> weights = {};
  TRY(read_numbers(
      object, names,
      [](std::size_t) {
        return std::pair{-kMaxWeight, kMaxWeight};
      },
      [&](std::size_t i, double weight) { weights[i] = weight; }));
  return weights;
}

Result<OptionValues> parse_options(const Task& task, const JsonValue& object, OptionValues values) {
  Names names;
  for (const TaskOption& option : task.options) names.push_back(option.name);
  TRY(read_numbers(
      object, names,
      [&](std::size_t i) {
        return std::pair{task.options[i].low, task.options[i].high};
      },
      [&](std::size_t i, double value) { values[i] = value; }));
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
  in.text("start", choices.start);
  in.integer("offense", 0, soccer::kPlayersPerTeam, choices.offense);
  in.integer("defense", 0, soccer::kPlayersPerTeam, choices.defense);
  in.choice("agents", kAgentsNames, choices.agents);
  in.integer("num_agents", 1, soccer::kPlayersPerTeam, choices.num_agents);
  in.flag("goalie_agent", choices.goalie_agent);
  in.drivers("teammates", false, choices.teammates);
  in.drivers("opponent", true, choices.opponents);
  in.integer("frame_skip", 1, kMaxFrameSkip, choices.frame_skip);
  in.integer("max_cycles", 0, kMaxCycles, choices.max_cycles);
  in.choice("until", kUntilNames, choices.until);
  in.choice("obs", kFidelityNames, choices.fidelity);
  in.integer("state", 1, kStateVersions, choices.state);
  in.flag("look", choices.senses.look);
  in.flag("say", choices.senses.say);
  in.choice("expert", kExpertNames, choices.expert);
  in.choice("types", kRandomTypesNames, choices.random_types);
}

}  // namespace

Result<PoolConfig> parse_pool_config(const std::string& json) {
  TRY_INIT(const JsonDocument document, JsonDocument::parse("configuration", json));
  const JsonValue root(document);
  TRY(root.expect_keys(kKeys));
  if (!root.has("task")) return root.error("the key 'task' is missing");

  PoolConfig config;
  SetupChoices choices = usual_choices();
  Reader in(root);
  read_choices(in, choices);
  in.integer("num_envs", 1, kMaxEnvs, config.num_envs);
  in.integer("threads", 1, kMaxThreads, config.threads);
  in.choice("autoreset", kAutoresetNames, config.autoreset);
  if (!in.error.message.empty()) return in.error;

  if (root.has("reward")) {
    TRY_INIT(choices.weights, parse_weights(root["reward"]));
  }

  auto setup = make_setup(choices);
  if (!setup) return Error{"configuration: " + setup.error().message};
  config.setup = std::move(*setup);
  config.options = config.setup->options;

  if (root.has("options")) {
    TRY_INIT(config.options, parse_options(*config.setup->task, root["options"], config.options));
  }
  return config;
}

Result<OptionValues> parse_options(const Task& task, const std::string& json, OptionValues values) {
  TRY_INIT(const JsonDocument document, JsonDocument::parse("options", json));
  return parse_options(task, JsonValue(document), values);
}

}  // namespace cls::training
