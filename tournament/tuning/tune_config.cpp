// Parses tune.toml with toml++.
#include "tournament/tuning/tune_config.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/text/stored_formats.h"
#include "match/terms/toml_schema.h"
#include "tournament/config/config_keys.h"

namespace cls::tournament {
namespace {

// Reads the keys of a table; every key must be read.
class TableReader {
 public:
  TableReader(const toml::table& table, std::string file, std::vector<std::string>& errors)
      : table_(table), file_(std::move(file)), errors_(errors) {}

  void error(const toml::node& node, const std::string& what) {
    errors_.push_back(fmt::format("{}:{}: {}", file_, node.source().begin.line, what));
  }
  void error(const std::string& what) { error(table_, what); }

  bool has(std::string_view key) const { return table_.contains(key); }

  /// nullptr if there is no such key.
  const toml::node* take(std::string_view key) {
    known_.push_back(key);
    return table_.get(key);
  }
  void read(std::string_view key, std::string& value) {
    read_as<std::string>(key, "a string", [&](std::string found) { value = std::move(found); });
  }
  void read(std::string_view key, bool& value) {
    read_as<bool>(key, "true or false", [&](bool found) { value = found; });
  }
  void read(std::string_view key, double& value) {
    read_as<double>(key, "a number", [&](double found) { value = found; });
  }
  void read(std::string_view key, int& value, int low, int high) {
    const toml::node* node = take(key);
    if (node == nullptr) return;
    const auto found = node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
    if (!found || *found < low || *found > high) {
      error(*node, fmt::format("{}: must be a whole number from {} to {}", key, low, high));
      return;
    }
    value = static_cast<int>(*found);
  }
  void read(std::string_view key, std::vector<std::string>& value) {
    const toml::node* node = take(key);
    if (node == nullptr) return;
    const toml::array* array = node->as_array();
    value.clear();
    for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
      if (const auto text = array->get(i)->value<std::string>()) value.push_back(*text);
    }
    if (array == nullptr || value.size() != array->size()) {
      error(*node, fmt::format("{}: must be a list of strings", key));
    }
  }
  /// One of `names`; the position of the one that was found.
  std::optional<std::size_t> read_choice(std::string_view key,
                                         const std::vector<std::string_view>& names) {
    std::string text;
    const toml::node* node = table_.get(key);
    read(key, text);
    if (text.empty()) return std::nullopt;
    const auto found = std::ranges::find(names, text);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    error(*node, fmt::format("{}: must be {}", key, fmt::join(names, " or ")));
    return std::nullopt;
  }
  const toml::table* read_table(std::string_view key) {
    const toml::node* node = take(key);
    if (node == nullptr) return nullptr;
    const toml::table* table = node->as_table();
    if (table == nullptr) error(*node, fmt::format("'{}' must be a table", key));
    return table;
  }

  /// Reports the keys that were not read.
  void finish() {
    for (const auto& [key, node] : table_) {
      if (std::ranges::find(known_, key.str()) == known_.end()) {
        error(node, unknown_key("key", key.str(), known_));
      }
    }
  }

 private:
  template <typename T, typename Store>
  void read_as(std::string_view key, std::string_view form, const Store& store) {
    const toml::node* node = take(key);
    if (node == nullptr) return;
    if (auto found = node->value<T>()) {
      store(*std::move(found));
    } else {
      error(*node, fmt::format("{}: must be {}", key, form));
    }
  }

  const toml::table& table_;
  std::string file_;
  std::vector<std::string>& errors_;
  std::vector<std::string_view> known_;
};

class TuneParser {
 public:
  explicit TuneParser(std::string file) : file_(std::move(file)) {}

  ParsedTuneConfig parse(std::string_view text) {
    try {
      parse_top(toml::parse(text, file_));
    } catch (const toml::parse_error& error) {
      parsed_.errors.push_back(
          fmt::format("{}:{}: {}", file_, error.source().begin.line, error.description()));
    }
    return std::move(parsed_);
  }

 private:
  TableReader reader(const toml::table& table) { return {table, file_, parsed_.errors}; }

  // The keys of a newer file may have other meanings.
  static bool read_schema(TableReader& read) {
    const toml::node* node = read.take("schema");
    if (node == nullptr) return true;
    const auto error = match::schema_error(*node, base::kTuneSchema);
    if (error) read.error(*node, *error);
    return !error;
  }

  void parse_top(const toml::table& top) {
    TableReader read = reader(top);
    if (!read_schema(read)) return;
    const toml::table* parameters = read.read_table("parameters");
    const toml::table* tune = read.read_table("tune");
    if (parameters != nullptr) parse_parameters(*parameters);
    if (parameters == nullptr || parsed_.config.parameters.empty()) {
      read.error("no parameters: [parameters.NAME] with min, max and start");
    }

    if (tune != nullptr) {
      parse_tune(*tune);
    } else {
      read.error("no table [tune]");
    }
    read.finish();
  }

  void parse_tune(const toml::table& table) {
    TuneConfig& config = parsed_.config;
    TableReader read = reader(table);
    read.read("team", config.team);
    if (config.team.empty()) read.error("team: a side with placeholders is missing");
    read.read("opponents", config.opponents);

    if (const auto method = read.read_choice("method", {"cma-es", "spsa"})) {
      config.method = *method == 0 ? TuneMethod::kCmaEs : TuneMethod::kSpsa;
    }
    if (const auto measure = read.read_choice("measure", {"points", "goals", "value"})) {
      config.measure = static_cast<Measure>(*measure);
    }

    if (config.measure == Measure::kValue) config.max_goals = kMaxValue;
    read.read("max_goals", config.max_goals, 1, 100);
    read.read("generations", config.generations, 1, 100'000);
    read.read("population", config.population, 0, 1000);
    read.read("pairs", config.pairs, 1, 10'000);
    read.read("stop", config.stop);
    read.read("verdict_pairs", config.verdict_pairs, 0, 1'000'000);

    int seed = static_cast<int>(config.seed);
    read.read("seed", seed, 0, 2'000'000'000);
    config.seed = static_cast<std::uint64_t>(seed);

    read.read("file", config.file);
    read.read("template", config.file_template);

    std::vector<std::string> constraints;
    read.read("constraints", constraints);
    for (const std::string& text : constraints) {
      auto constraint = parse_constraint(text, config.parameters);
      if (constraint) {
        config.constraints.push_back(*std::move(constraint));
      } else {
        read.error(fmt::format("constraints: '{}': {}", text, constraint.error().message));
      }
    }

    if (const toml::table* environment = read.read_table("environment")) {
      parse_environment(*environment);
    }
    read.finish();
    check(read);
  }

  void parse_environment(const toml::table& table) {
    TableReader read = reader(table);
    for (const auto& [key, node] : table) {
      std::string text;
      read.read(key.str(), text);
      parsed_.config.environment.emplace_back(std::string(key.str()), text);
    }
  }

  // In the order of the file.
  void parse_parameters(const toml::table& table) {
    std::vector<std::pair<toml::source_index, const toml::key*>> keys;
    for (const auto& [key, node] : table) keys.emplace_back(node.source().begin.line, &key);
    std::ranges::stable_sort(keys, {}, [](const auto& key) { return key.first; });

    for (const auto& [line, key] : keys) {
      const toml::node* node = table.get(key->str());
      if (const toml::table* parameter = node->as_table()) {
        parse_parameter(std::string(key->str()), *parameter);
      } else {
        parsed_.errors.push_back(fmt::format("{}:{}: '{}' must be a table with min, max and start",
                                             file_, line, key->str()));
      }
    }
  }

  void parse_parameter(const std::string& name, const toml::table& table) {
    TableReader read = reader(table);
    Parameter parameter;
    parameter.name = name;
    parameter.step = 0.2;
    read.read("min", parameter.min);
    read.read("max", parameter.max);
    read.read("start", parameter.start);
    read.read("step", parameter.step);
    read.read("integer", parameter.integer);

    if (const auto scale = read.read_choice("scale", {"linear", "log"})) {
      parameter.scale = *scale == 0 ? Scale::kLinear : Scale::kLog;
    }

    for (const std::string_view key : {"min", "max", "start"}) {
      if (!read.has(key)) read.error(fmt::format("{}: {} is missing", name, key));
    }
    check(read, parameter);
    read.finish();
    parsed_.config.parameters.push_back(std::move(parameter));
  }

  static void check(TableReader& read, const Parameter& parameter) {
    const auto error = [&](const std::string& what) {
      read.error(fmt::format("{}: {}", parameter.name, what));
    };
    const bool is_name = std::ranges::all_of(parameter.name, [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
    });
    if (!is_name) error("a name has letters, digits, '_', '-' and '.' only");
    if (parameter.name == "file" || parameter.name == "port" || parameter.name == "seed" ||
        parameter.name == "side" || parameter.name == "name") {
      error("the placeholder has another meaning; choose another name");
    }

    if (!(parameter.min < parameter.max)) error("min must be below max");
    if (!(parameter.min <= parameter.start && parameter.start <= parameter.max)) {
      error("start must be from min to max");
    }
    if (!(parameter.step > 0 && parameter.step <= 1)) {
      error("step must be a share of the range, above 0 and at most 1");
    }
    if (parameter.scale == Scale::kLog && parameter.min <= 0)
      error("a log scale needs min above 0");

    const auto whole = [](double value) { return value == std::floor(value); };
    if (parameter.integer &&
        !(whole(parameter.min) && whole(parameter.max) && whole(parameter.start))) {
      error("min, max and start must be whole numbers");
    }
  }

  void check(TableReader& read) {
    TuneConfig& config = parsed_.config;
    if (config.stop < 0 || config.stop >= 0.5) read.error("stop: must be from 0 to below 0.5");
    if (config.opponents.empty() && config.method == TuneMethod::kCmaEs) {
      read.error(
          "opponents: cma-es needs at least one; with spsa two candidates may play each other");
    }
    if (config.method == TuneMethod::kSpsa && config.population != 0 && config.population != 2) {
      read.error("population: spsa has two candidates");
    }
    if (config.method == TuneMethod::kCmaEs && config.population != 0 && config.population < 4) {
      read.error("population: cma-es needs at least 4 candidates");
    }

    if (!config.file_template.empty() && config.file.empty()) {
      config.file = config.file_template.substr(config.file_template.find_last_of('/') + 1);
      if (config.file.ends_with(".in")) config.file.resize(config.file.size() - 3);
    }

    const bool plain = config.file_template.empty() && !config.file.empty();
    if (plain && !config.file.ends_with(".json") && !config.file.ends_with(".toml")) {
      read.error("file: must end in .json or .toml; other formats need a template");
    }
    if (config.file.find('/') != std::string::npos) read.error("file: must be a name, not a path");
    if (!config.environment.empty() && !config.team.starts_with("run:")) {
      read.error("environment: needs a team run:COMMAND");
    }

    Values start;
    for (const Parameter& parameter : config.parameters) start.push_back(parameter.start);
    for (const Constraint& constraint : config.constraints) {
      if (!satisfies(start, {constraint})) {
        read.error(fmt::format("constraints: '{}': the start values violate it", constraint.text));
      }
    }
    check_placeholders(read);
  }

  // A parameter that nothing uses would be tuned in vain.
  void check_placeholders(TableReader& read) {
    const TuneConfig& config = parsed_.config;
    const bool has_file = config.team.find("{file}") != std::string::npos;
    if (has_file && config.file.empty()) read.error("team: {file} needs the key file or template");
    if (!has_file && !config.file.empty()) read.error("team: does not use {file}");
    if (!config.file.empty()) return;  // it holds all parameters, or its template decides
    std::string text = config.team;
    for (const auto& [name, value] : config.environment) text += value;
    for (const Parameter& parameter : config.parameters) {
      if (text.find("{" + parameter.name + "}") != std::string::npos) continue;
      read.error(fmt::format("team: does not use {{{}}}; name it in team, environment or a file",
                             parameter.name));
    }
  }

  std::string file_;
  ParsedTuneConfig parsed_;
};

}  // namespace

ParsedTuneConfig parse_tune_config(std::string_view text, const std::string& file) {
  return TuneParser(file).parse(text);
}

std::vector<std::string> plan_lines(const TuneConfig& config) {
  std::vector<std::string> lines = {
      fmt::format("team = {}", config.team),
      fmt::format("opponents = {}", fmt::join(config.opponents, ", ")),
      fmt::format("method = {}", config.method == TuneMethod::kCmaEs ? "cma-es" : "spsa"),
      fmt::format("measure = {}", name(config.measure)),
      fmt::format("max_goals = {}", config.max_goals),
      fmt::format("population = {}", config.population),
      fmt::format("pairs = {}", config.pairs),
      fmt::format("stop = {:g}", config.stop),
      fmt::format("seed = {}", config.seed),
      fmt::format("file = {}", config.file),
      fmt::format("template = {}", config.file_template)};

  for (const auto& [name, value] : config.environment) {
    lines.push_back(fmt::format("environment.{} = {}", name, value));
  }
  for (const Parameter& one : config.parameters) {
    lines.push_back(fmt::format("parameters.{} = {} to {} from {}, step {}{}{}", one.name, one.min,
                                one.max, one.start, one.step, one.integer ? ", integer" : "",
                                one.scale == Scale::kLog ? ", log" : ""));
  }

  for (const Constraint& one : config.constraints) lines.push_back("constraint = " + one.text);
  // SPSA plans its gains by the number of generations.
  if (config.method == TuneMethod::kSpsa) {
    lines.push_back(fmt::format("generations = {}", config.generations));
  }
  return lines;
}

std::string commented_tune_config() {
  return R"(# A search for better parameters. `cls tune run DIR` plays it, `cls tune report DIR` shows the
# result. Lines that start with # show defaults and examples.

schema = 1  # version of the format of this file

[tune]
# A side of `cls match` with a placeholder {NAME} for each parameter, such as
# "run:./run --port {port} --press {press}"; {file} is the file of the key file or template.
team = "mock:{file}"

# Sides, or teams of cls.toml. They take turns.
opponents = ["mock:hold"]

#method = "cma-es"    # or "spsa"
#measure = "goals"    # or "points"; "value" with a book in cls.toml
max_goals = 6         # a larger goal difference counts as this (3)
generations = 6
#population = 0       # candidates of a generation; 0: 4 + 3 ln(parameters); spsa: 2
pairs = 3             # pairs of matches of each candidate
#stop = 0.1           # worse candidates stop early with this error probability; 0: never
#verdict_pairs = 200  # maximum of the final comparison of best and start; 0: none
#seed = 1
#constraints = ["near + 2 * far <= 10"]

# A file with the values, JSON or TOML: {"speed": 2, "y": 28}. A template has placeholders instead.
#file = "parameters.json"
template = "striker.json.in"

# Environment variables of a Playmaker that cls starts (run:COMMAND).
#[tune.environment]
#PRESS = "{press}"

# step is the first standard deviation as a share of the range (0.2); scale = "log" for factors.
[parameters.y]
min = -34
max = 34
start = 28

[parameters.speed]
min = 0.5
max = 3.0
start = 2.0
)";
}

}  // namespace cls::tournament
