// One row a key.
#include "orchestration/tournament/config/config_keys.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>

#include "base/text/suggestion.h"

namespace cls::orchestration::tournament {
namespace {

using base::Error;
using base::Result;
using Config = TournamentConfig;
using Row = ConfigKey;
using Group = KeyGroup;

std::optional<double> number_in(const ConfigValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&value)) return *real;
  return std::nullopt;
}

// Members that are a T or an optional T are read alike.
template <typename Member>
Row whole(std::string_view key, Group group, Member member, std::int64_t least, std::int64_t most,
          std::string_view example, std::string_view meaning) {
  return {key,
          group,
          meaning,
          example,
          [=](Config& config, const ConfigValue& value) -> Result<void> {
            const auto* read = std::get_if<std::int64_t>(&value);
            if (read == nullptr || *read < least || *read > most) {
              return Error{fmt::format("must be a whole number from {} to {}", least, most)};
            }
            config.*member = static_cast<int>(*read);
            return {};
          },
          [=](const Config& config) {
            if constexpr (std::is_same_v<decltype(member), int Config::*>) {
              return fmt::to_string(config.*member);
            } else {
              return config.*member ? fmt::to_string(*(config.*member)) : std::string();
            }
          }};
}

Row seconds(std::string_view key, Group group, std::optional<double> Config::*member,
            std::string_view example, std::string_view meaning) {
  return {key,
          group,
          meaning,
          example,
          [=](Config& config, const ConfigValue& value) -> Result<void> {
            const auto read = number_in(value);
            if (!read || *read <= 0) return Error{"must be a positive number of seconds"};
            config.*member = *read;
            return {};
          },
          [=](const Config& config) {
            return config.*member ? fmt::format("{}", *(config.*member)) : std::string();
          }};
}

Row flag(std::string_view key, Group group, bool Config::*member, std::string_view example,
         std::string_view meaning) {
  return {key,
          group,
          meaning,
          example,
          [=](Config& config, const ConfigValue& value) -> Result<void> {
            const auto* read = std::get_if<bool>(&value);
            if (read == nullptr) return Error{"must be true or false"};
            config.*member = *read;
            return {};
          },
          [=](const Config& config) { return std::string(config.*member ? "true" : "false"); }};
}

Row text(std::string_view key, Group group, std::string Config::*member, std::string_view example,
         std::string_view meaning) {
  return {key,
          group,
          meaning,
          example,
          [=](Config& config, const ConfigValue& value) -> Result<void> {
            const auto* read = std::get_if<std::string>(&value);
            if (read == nullptr) return Error{"must be a string"};
            config.*member = *read;
            return {};
          },
          [=](const Config& config) {
            return (config.*member).empty() ? std::string() : toml_quoted(config.*member);
          }};
}

std::string wrong_word(std::string_view word, const std::vector<std::string_view>& words) {
  const std::string_view near = base::nearest_name(word, words);
  if (!near.empty()) return fmt::format("'{}': did you mean '{}'?", word, near);
  return fmt::format("'{}' is not one of {}", word, fmt::join(words, ", "));
}

template <typename Enum, std::size_t count>
Result<Enum> enum_of(const ConfigValue& value, const std::array<Enum, count>& all) {
  std::vector<std::string_view> words;
  for (const Enum one : all) words.push_back(name(one));
  const auto* word = std::get_if<std::string>(&value);
  if (word == nullptr) return Error{fmt::format("must be one of {}", fmt::join(words, ", "))};
  for (const Enum one : all) {
    if (name(one) == *word) return one;
  }
  return Error{wrong_word(*word, words)};
}

template <typename Enum, std::size_t count>
Row choice(std::string_view key, Group group, Enum Config::*member,
           const std::array<Enum, count>& all, std::string_view example, std::string_view meaning) {
  return {key,
          group,
          meaning,
          example,
          [=](Config& config, const ConfigValue& value) -> Result<void> {
            const auto read = enum_of(value, all);
            if (!read) return read.error();
            config.*member = *read;
            return {};
          },
          [=](const Config& config) { return toml_quoted(name(config.*member)); }};
}

constexpr std::array kFormats = {Format::kRoundRobin, Format::kGauntlet, Format::kList,
                                 Format::kGroups,     Format::kKnockout, Format::kDoubleElimination,
                                 Format::kSwiss};
constexpr std::array kOnCrash = {OnCrash::kStop, OnCrash::kForfeit, OnCrash::kRerun};
constexpr std::array kExecutors = {ExecutorKind::kLocal, ExecutorKind::kSlurm};
constexpr std::array kKeepLogs = {KeepLogs::kAll, KeepLogs::kFailed, KeepLogs::kNone};
constexpr std::array kTieBreakers = {
    TieBreaker::kHeadToHead, TieBreaker::kGoalDifference, TieBreaker::kGoalDifferenceAmong,
    TieBreaker::kGoals,      TieBreaker::kGoalsAmong,     TieBreaker::kWins,
    TieBreaker::kBuchholz,   TieBreaker::kMedianBuchholz, TieBreaker::kSonnebornBerger};

std::string toml_list(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back(toml_quoted(word));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

Result<void> read_seed(Config& config, const ConfigValue& value) {
  const auto* read = std::get_if<std::int64_t>(&value);
  if (read == nullptr || *read < 0) return Error{"must be a whole number from 0"};
  config.seed = static_cast<std::uint64_t>(*read);
  return {};
}

Result<void> read_gauntlet(Config& config, const ConfigValue& value) {
  if (const auto* one = std::get_if<std::string>(&value)) {
    config.gauntlet = {*one};
  } else if (const auto* several = std::get_if<std::vector<std::string>>(&value)) {
    config.gauntlet = *several;
  } else {
    return Error{"must be a list of team names"};
  }
  return {};
}

Result<void> read_slurm_options(Config& config, const ConfigValue& value) {
  const auto* words = std::get_if<std::vector<std::string>>(&value);
  if (words == nullptr) return Error{"must be a list of options, [\"--partition=short\", ...]"};
  for (const std::string& word : *words) {
    if (!word.starts_with("-"))
      return Error{fmt::format("'{}': write options of sbatch as --name=value", word)};
  }
  config.slurm_options = *words;
  return {};
}

Result<void> read_matches(Config& config, const ConfigValue& value) {
  const auto* pairings = std::get_if<std::vector<std::vector<std::string>>>(&value);
  if (pairings == nullptr) return Error{"must be a list of pairs, [[\"A\", \"B\"], ...]"};
  config.matches = *pairings;
  return {};
}

std::string write_matches(const Config& config) {
  if (config.matches.empty()) return {};
  std::vector<std::string> pairings;
  for (const auto& pairing : config.matches) pairings.push_back(toml_list(pairing));
  return fmt::format("[{}]", fmt::join(pairings, ", "));
}

Result<void> read_tie_breakers(Config& config, const ConfigValue& value) {
  const auto* words = std::get_if<std::vector<std::string>>(&value);
  if (words == nullptr) return Error{"must be a list of criteria"};
  config.tie_breakers.clear();
  for (const std::string& word : *words) {
    const auto one = enum_of(ConfigValue(word), kTieBreakers);
    if (!one) return one.error();
    config.tie_breakers.push_back(*one);
  }
  return {};
}

std::string write_tie_breakers(const Config& config) {
  if (config.tie_breakers.empty()) return {};
  std::vector<std::string> words;
  for (const TieBreaker one : config.tie_breakers) words.emplace_back(name(one));
  return toml_list(words);
}

Result<void> read_concurrency(Config& config, const ConfigValue& value) {
  const auto* word = std::get_if<std::string>(&value);
  const auto* count = std::get_if<std::int64_t>(&value);
  const bool automatic = word != nullptr && *word == "auto";
  if (!automatic && (count == nullptr || *count < 1 || *count > 4096)) {
    return Error{"must be \"auto\" or a whole number from 1 to 4096"};
  }
  config.concurrency = automatic ? 0 : static_cast<int>(*count);
  return {};
}

std::string write_concurrency(const Config& config) {
  return config.concurrency == 0 ? "\"auto\"" : fmt::to_string(config.concurrency);
}

Result<void> read_folder(Config& config, const ConfigValue& value) {
  const auto* read = std::get_if<std::string>(&value);
  if (read == nullptr) return Error{"must be a string"};
  config.folder = *read;
  return {};
}

std::vector<Row> schedule_rows() {
  constexpr Group kGroup = Group::kSchedule;
  return {
      choice("format", kGroup, &Config::format, kFormats, "\"round-robin\"",
             "round-robin, gauntlet, list, groups, knockout, double-elimination or swiss"),
      whole("rounds", kGroup, &Config::rounds, 1, 1'000'000, "1",
            "how often every pairing is played (once per side); swiss: rounds in all"),
      Row{"seed", kGroup, "all seeds and draws follow from it", "1", read_seed,
          [](const Config& config) { return fmt::to_string(config.seed); }},
      flag("swap_sides", kGroup, &Config::swap_sides, "true",
           "every pairing twice on the same seed, once from each side"),
      flag("draw", kGroup, &Config::draw, "false",
           "seeding order by lot instead of the order of the teams below"),
      Row{"gauntlet", kGroup, "gauntlet: the teams that meet all others", "[\"NEW\"]",
          read_gauntlet,
          [](const Config& config) {
            return config.gauntlet.empty() ? std::string() : toml_list(config.gauntlet);
          }},
      Row{"matches", kGroup, "list: the pairings", "[[\"A\", \"B\"]]", read_matches, write_matches},
      whole("groups", kGroup, &Config::groups, 1, 1000, "2", "groups: how many"),
      whole("advance", kGroup, &Config::advance, 1, 1000, "2",
            "groups: how many of each go on to the knock-out"),
      flag("third_place", kGroup, &Config::third_place, "true",
           "knockout and groups: the losing semi-finalists play for the third place"),
      Row{"tie_breakers", kGroup, "criteria between teams with the same points, in order",
          "[\"head-to-head\", \"goal-difference\", \"goals\"]", read_tie_breakers,
          write_tie_breakers},
  };
}

std::vector<Row> condition_rows() {
  constexpr Group kGroup = Group::kConditions;
  return {
      whole("cycles", kGroup, &Config::cycles, 1, 1'000'000'000, "6000",
            "a match ends when game time reaches this"),
      whole("half_time", kGroup, &Config::half_time, 0, 1'000'000'000, "300",
            "length of a half in seconds; 10 cycles a second"),
      text("mode", kGroup, &Config::mode, "\"lockstep\"", "how time runs, as --mode of cls match"),
      text("server", kGroup, &Config::server, "\"embedded\"", "as --server of cls match"),
      whole("rpc_deadline", kGroup, &Config::rpc_deadline_ms, 1, 1'000'000'000, "10000",
            "milliseconds a Playmaker has for an answer"),
      whole("max_missed", kGroup, &Config::max_missed, 0, 1'000'000'000, "20",
            "missed answers in a row that end a match"),
  };
}

std::vector<Row> execution_rows() {
  constexpr Group kGroup = Group::kExecution;
  return {
      Row{"concurrency", kGroup, "matches at once: a number, or \"auto\" (by processors)",
          "\"auto\"", read_concurrency, write_concurrency},
      flag("pin", kGroup, &Config::pin, "false", "each running match on processors of its own"),
      choice("executor", kGroup, &Config::executor, kExecutors, "\"local\"",
             "where matches are played: local or slurm"),
      Row{"slurm_options", kGroup, "slurm: options for sbatch", "[\"--partition=short\"]",
          read_slurm_options,
          [](const Config& config) {
            return config.slurm_options.empty() ? std::string() : toml_list(config.slurm_options);
          }},
      whole("slurm_tasks", kGroup, &Config::slurm_tasks, 1, 1'000'000, "1000",
            "slurm: matches that wait or run there at once"),
      seconds("slurm_poll", kGroup, &Config::slurm_poll_s, "10",
              "slurm: seconds between questions to squeue"),
      choice("on_crash", kGroup, &Config::on_crash, kOnCrash, "\"stop\"",
             "after a fault: stop, forfeit (0:3) or rerun"),
      whole("max_reruns", kGroup, &Config::max_reruns, 0, 1000, "2",
            "rerun: how often a match is tried again"),
      choice("keep_logs", kGroup, &Config::keep_logs, kKeepLogs, "\"all\"",
             "match folders to keep: all, failed or none"),
      seconds("start_timeout", kGroup, &Config::start_timeout_s, "20",
              "seconds until a Playmaker must answer first"),
      seconds("stall_after", kGroup, &Config::stall_after_s, "10",
              "seconds without a new cycle that end a match"),
      seconds("time_limit", kGroup, &Config::time_limit_s, "600", "seconds for a whole match"),
      Row{"folder", kGroup, "relative paths in endpoints start here (the folder of this file)",
          "\".\"", read_folder,
          [](const Config& config) {
            return config.folder.empty() ? std::string() : toml_quoted(config.folder.string());
          }},
      text("on_match_finish", kGroup, &Config::on_match_finish, "\"cat >>matches.jsonl\"",
           "command after every match; the match as JSON on its standard input"),
      text("on_finish", kGroup, &Config::on_finish, "\"cat >report.json\"",
           "command at the end; the report as JSON on its standard input"),
  };
}

}  // namespace

const std::vector<ConfigKey>& tournament_keys() {
  static const std::vector<ConfigKey> keys = [] {
    std::vector<ConfigKey> all = schedule_rows();
    for (auto rows : {condition_rows(), execution_rows()}) {
      all.insert(all.end(), rows.begin(), rows.end());
    }
    return all;
  }();
  return keys;
}

const ConfigKey* find_key(std::string_view name) {
  for (const ConfigKey& key : tournament_keys()) {
    if (key.name == name) return &key;
  }
  return nullptr;
}

ConfigValue value_from_text(const ConfigKey& key, std::string_view text) {
  const auto split = [](std::string_view whole, char at) {
    std::vector<std::string> parts;
    for (std::size_t end = 0; end != std::string_view::npos; whole.remove_prefix(end + 1)) {
      end = whole.find(at);
      parts.emplace_back(whole.substr(0, end));
      if (end == std::string_view::npos) break;
    }
    return parts;
  };
  if (key.name == "slurm_options") return split(text, ' ');
  if (key.name == "gauntlet" || key.name == "tie_breakers") return split(text, ',');
  if (key.name == "matches") {
    std::vector<std::vector<std::string>> pairings;
    for (const std::string& one : split(text, ',')) pairings.push_back(split(one, ':'));
    return pairings;
  }
  if (text == "true" || text == "false") return text == "true";
  std::int64_t whole = 0;
  const char* end = text.data() + text.size();
  if (std::from_chars(text.data(), end, whole).ptr == end && !text.empty()) return whole;
  double real = 0.0;
  if (std::from_chars(text.data(), end, real).ptr == end && !text.empty()) return real;
  return std::string(text);
}

std::string unknown_key(std::string_view what, std::string_view word,
                        const std::vector<std::string_view>& known) {
  const std::string_view near = base::nearest_name(word, known);
  return fmt::format("unknown {} '{}'{}", what, word,
                     near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
}

std::string toml_quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      quoted += fmt::format("\\u{:04X}", static_cast<int>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

}  // namespace cls::orchestration::tournament
