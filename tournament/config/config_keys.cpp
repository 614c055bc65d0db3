// The rows of the key table.
#include "match/terms/option_table.h"
#include "tournament/config/config_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "base/text/suggestion.h"

namespace cls::tournament {
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

// For members of type int and std::optional<int>.
template <typename Member>
Row integer(std::string_view key, Group group, Member member, std::int64_t min, std::int64_t max,
            std::string_view example, std::string_view help) {
  return {key,
          group,
          help,
          example,
          [=](Config& config, const ConfigValue& value) -> Result<void> {
            const auto* read = std::get_if<std::int64_t>(&value);
            if (read == nullptr || *read < min || *read > max) {
              return Error{fmt::format("must be a whole number from {} to {}", min, max)};
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

Row number(std::string_view key, Group group, std::optional<double> Config::*member,
           std::string_view unit, std::string_view example, std::string_view help) {
  return {key,
          group,
          help,
          example,
          [=](Config& config, const ConfigValue& value) -> Result<void> {
            const auto read = number_in(value);
            if (!read || *read <= 0) {
              return Error{fmt::format("must be a positive number of {}", unit)};
            }
            config.*member = *read;
            return {};
          },
          [=](const Config& config) {
            return config.*member ? fmt::format("{}", *(config.*member)) : std::string();
          }};
}

Row seconds(std::string_view key, Group group, std::optional<double> Config::*member,
            std::string_view example, std::string_view help) {
  return number(key, group, member, "seconds", example, help);
}

Row flag(std::string_view key, Group group, bool Config::*member, std::string_view example,
         std::string_view help) {
  return {key,
          group,
          help,
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
         std::string_view help) {
  return {key,
          group,
          help,
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

std::string toml_list(const std::vector<std::string>& texts) {
  std::vector<std::string> quoted;
  for (const std::string& text : texts) quoted.push_back(toml_quoted(text));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

Row texts(std::string_view key, Group group, std::vector<std::string> Config::*member,
          std::string_view example, std::string_view help) {
  return {key,
          group,
          help,
          example,
          [=](Config& config, const ConfigValue& value) -> Result<void> {
            const auto* read = std::get_if<std::vector<std::string>>(&value);
            const auto* one = std::get_if<std::string>(&value);
            if (read == nullptr && one == nullptr) return Error{"must be a list of strings"};
            config.*member = read != nullptr ? *read : std::vector<std::string>{*one};
            return {};
          },
          [=](const Config& config) {
            return (config.*member).empty() ? std::string() : toml_list(config.*member);
          }};
}

std::string unknown_value(std::string_view value, const std::vector<std::string_view>& names) {
  const std::string_view near = base::nearest_name(value, names);
  if (!near.empty()) return fmt::format("'{}': did you mean '{}'?", value, near);
  return fmt::format("'{}' is not one of {}", value, fmt::join(names, ", "));
}

template <typename Enum, std::size_t count>
Result<Enum> enum_of(const ConfigValue& value, const std::array<Enum, count>& all) {
  std::vector<std::string_view> names;
  for (const Enum one : all) names.push_back(name(one));
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) return Error{fmt::format("must be one of {}", fmt::join(names, ", "))};
  for (const Enum one : all) {
    if (name(one) == *text) return one;
  }
  return Error{unknown_value(*text, names)};
}

template <typename Enum, std::size_t count>
Row choice(std::string_view key, Group group, Enum Config::*member,
           const std::array<Enum, count>& all, std::string_view example, std::string_view help) {
  return {key,
          group,
          help,
          example,
          [=](Config& config, const ConfigValue& value) -> Result<void> {
            TRY_INIT(const auto read, enum_of(value, all));
            config.*member = read;
            return {};
          },
          [=](const Config& config) { return toml_quoted(name(config.*member)); }};
}

constexpr std::array kFormats = {Format::kRoundRobin, Format::kGauntlet, Format::kList,
                                 Format::kGroups,     Format::kKnockout, Format::kDoubleElimination,
                                 Format::kSwiss,      Format::kStages};
constexpr std::array kOnCrash = {OnCrash::kStop, OnCrash::kForfeit, OnCrash::kRerun};
constexpr std::array kExecutors = {ExecutorKind::kLocal, ExecutorKind::kSlurm,
                                   ExecutorKind::kHosts};
constexpr std::array kKeepLogs = {KeepLogs::kAll, KeepLogs::kFailed, KeepLogs::kNone};
constexpr std::array kTieBreakers = {
    TieBreaker::kHeadToHead, TieBreaker::kGoalDifference, TieBreaker::kGoalDifferenceAmong,
    TieBreaker::kGoals,      TieBreaker::kGoalsAmong,     TieBreaker::kWins,
    TieBreaker::kBuchholz,   TieBreaker::kMedianBuchholz, TieBreaker::kSonnebornBerger};

Result<void> parse_seed(Config& config, const ConfigValue& value) {
  const auto* read = std::get_if<std::int64_t>(&value);
  if (read == nullptr || *read < 0) return Error{"must be a whole number from 0"};
  config.seed = static_cast<std::uint64_t>(*read);
  return {};
}

Result<void> parse_gauntlet(Config& config, const ConfigValue& value) {
  if (const auto* one = std::get_if<std::string>(&value)) {
    config.gauntlet = {*one};
  } else if (const auto* several = std::get_if<std::vector<std::string>>(&value)) {
    config.gauntlet = *several;
  } else {
    return Error{"must be a list of team names"};
  }
  return {};
}

Result<void> parse_slurm_options(Config& config, const ConfigValue& value) {
  const auto* options = std::get_if<std::vector<std::string>>(&value);
  if (options == nullptr) return Error{"must be a list of options, [\"--partition=short\", ...]"};
  for (const std::string& option : *options) {
    if (!option.starts_with("-"))
      return Error{fmt::format("'{}': sbatch options must have the form --name=value", option)};
  }
  config.slurm_options = *options;
  return {};
}

Result<void> parse_matches(Config& config, const ConfigValue& value) {
  const auto* pairings = std::get_if<std::vector<std::vector<std::string>>>(&value);
  if (pairings == nullptr) return Error{"must be a list of pairs, [[\"A\", \"B\"], ...]"};
  for (const std::vector<std::string>& pairing : *pairings) {
    if (pairing.size() == 2) continue;
    return Error{
        fmt::format("'{}' is not a pairing of two teams, as A:B in --matches A:B,C:D or "
                    "[\"A\", \"B\"] in cls.toml",
                    fmt::join(pairing, ":"))};
  }
  config.matches = *pairings;
  return {};
}

std::string format_matches(const Config& config) {
  if (config.matches.empty()) return {};
  std::vector<std::string> pairings;
  for (const auto& pairing : config.matches) pairings.push_back(toml_list(pairing));
  return fmt::format("[{}]", fmt::join(pairings, ", "));
}

Result<void> parse_tie_breakers(Config& config, const ConfigValue& value) {
  const auto* names = std::get_if<std::vector<std::string>>(&value);
  if (names == nullptr) return Error{"must be a list of tiebreakers"};
  config.tie_breakers.clear();
  for (const std::string& text : *names) {
    TRY_INIT(const auto one, enum_of(ConfigValue(text), kTieBreakers));
    config.tie_breakers.push_back(one);
  }
  return {};
}

std::string format_tie_breakers(const Config& config) {
  if (config.tie_breakers.empty()) return {};
  std::vector<std::string> names;
  for (const TieBreaker one : config.tie_breakers) names.emplace_back(name(one));
  return toml_list(names);
}

Result<void> parse_concurrency(Config& config, const ConfigValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  const auto* count = std::get_if<std::int64_t>(&value);
  const bool automatic = text != nullptr && *text == "auto";
  if (!automatic && (count == nullptr || *count < 1 || *count > 4096)) {
    return Error{"must be \"auto\" or a whole number from 1 to 4096"};
  }
  config.concurrency = automatic ? 0 : static_cast<int>(*count);
  return {};
}

std::string format_concurrency(const Config& config) {
  return config.concurrency == 0 ? "\"auto\"" : fmt::to_string(config.concurrency);
}

Result<void> parse_folder(Config& config, const ConfigValue& value) {
  const auto* read = std::get_if<std::string>(&value);
  if (read == nullptr) return Error{"must be a string"};
  config.folder = *read;
  return {};
}

// The text of a value; nothing if the option cannot have a value of this type.
std::optional<std::string> text_of(const match::MatchOption& option, const ConfigValue& value) {
  switch (option.form.kind) {
    case base::ValueKind::kFlag:
      if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
      return std::nullopt;
    case base::ValueKind::kWhole:
    case base::ValueKind::kUnsigned:
      if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::to_string(*whole);
      return std::nullopt;
    case base::ValueKind::kNumber:
      if (const auto number = number_in(value)) return fmt::format("{}", *number);
      return std::nullopt;
    case base::ValueKind::kText:
      break;
  }
  const auto* text = std::get_if<std::string>(&value);
  return text == nullptr ? std::nullopt : std::optional<std::string>(*text);
}

Result<void> parse_option(const match::MatchOption& option, Config& config,
                          const ConfigValue& value) {
  const auto text = text_of(option, value);
  const bool is_text = option.form.kind == base::ValueKind::kText;
  if (!text || (!is_text && !base::fits(option.form, *text))) {
    const std::string form = base::phrase_of(option.form);
    return Error{"must be " + (form.empty() ? std::string("a string") : form)};
  }
  match::MatchOptions scratch;
  if (const auto set = option.set(scratch, *text); !set) {
    // The key stands before the error.
    std::string message = set.error().message;
    const std::string name = match::option_name(option.key) + " ";
    if (message.starts_with(name)) message.erase(0, name.size());
    return Error{std::move(message)};
  }
  config.options[std::string(option.key)] = *text;
  return {};
}

// The options of a match that cls.toml may have.
std::vector<Row> option_rows(match::OptionUse use, Group group) {
  std::vector<Row> rows;
  for (const match::MatchOption& option : match::match_options()) {
    if (option.use != use) continue;
    rows.push_back({option.key, group, option.help, option.example,
                    [&option](Config& config, const ConfigValue& value) {
                      return parse_option(option, config, value);
                    },
                    [&option](const Config& config) {
                      const auto text = config.options.find(option.key);
                      if (text == config.options.end()) return std::string();
                      const bool quoted = option.form.kind == base::ValueKind::kText;
                      return quoted ? toml_quoted(text->second) : text->second;
                    }});
  }
  return rows;
}

std::vector<Row> schedule_rows() {
  constexpr Group kGroup = Group::kSchedule;
  return {
      choice("format", kGroup, &Config::format, kFormats, "\"round-robin\"",
             "round-robin, gauntlet, list, groups, knockout, double-elimination, swiss or stages"),
      integer("rounds", kGroup, &Config::rounds, 1, 1'000'000, "1",
              "times each pairing is played (once per side); swiss: number of rounds"),
      Row{"seed", kGroup, "seed of all match seeds and draws", "1", parse_seed,
          [](const Config& config) { return fmt::to_string(config.seed); }},
      flag("swap_sides", kGroup, &Config::swap_sides, "true",
           "play each pairing twice on the same seed, once from each side"),
      flag("draw", kGroup, &Config::draw, "false",
           "random seeding order instead of the order of the teams"),
      Row{"gauntlet", kGroup, "gauntlet: the teams that meet all others", "[\"NEW\"]",
          parse_gauntlet,
          [](const Config& config) {
            return config.gauntlet.empty() ? std::string() : toml_list(config.gauntlet);
          }},
      Row{"matches", kGroup, "list: the pairings; as an option A:B,C:D", "[[\"A\", \"B\"]]",
          parse_matches, format_matches},
      integer("groups", kGroup, &Config::groups, 1, 1000, "2", "groups: number of groups"),
      integer("advance", kGroup, &Config::advance, 1, 1000, "2",
              "groups: teams of each group that advance to the knockout"),
      flag("third_place", kGroup, &Config::third_place, "true",
           "knockout and groups: the losing semi-finalists play for third place"),
      Row{"tie_breakers", kGroup, "criteria that order teams with the same points",
          "[\"head-to-head\", \"goal-difference\", \"goals\"]", parse_tie_breakers,
          format_tie_breakers},
  };
}

std::vector<Row> execution_rows() {
  constexpr Group kGroup = Group::kExecution;
  return {
      Row{"concurrency", kGroup, "parallel matches: a number, or \"auto\" (by cores)", "\"auto\"",
          parse_concurrency, format_concurrency},
      flag("pin", kGroup, &Config::pin, "false", "pin each running match to its own cores"),
      choice("executor", kGroup, &Config::executor, kExecutors, "\"local\"",
             "where matches run: local, slurm or hosts"),
      Row{"slurm_options", kGroup, "slurm: options for sbatch", "[\"--partition=short\"]",
          parse_slurm_options,
          [](const Config& config) {
            return config.slurm_options.empty() ? std::string() : toml_list(config.slurm_options);
          }},
      integer("slurm_tasks", kGroup, &Config::slurm_tasks, 1, 1'000'000, "1000",
              "slurm: maximum of pending and running matches"),
      seconds("slurm_poll", kGroup, &Config::slurm_poll_s, "10",
              "slurm: seconds between squeue polls"),
      choice("on_crash", kGroup, &Config::on_crash, kOnCrash, "\"stop\"",
             "after an invalid match: stop, forfeit (0:3) or rerun"),
      integer("max_reruns", kGroup, &Config::max_reruns, 0, 1000, "2",
              "rerun: maximum reruns of a match"),
      choice("keep_logs", kGroup, &Config::keep_logs, kKeepLogs, "\"all\"",
             "match folders to keep: all, failed or none"),
      Row{"folder", kGroup, "base of relative paths in endpoints (default: folder of this file)",
          "\".\"", parse_folder,
          [](const Config& config) {
            return config.folder.empty() ? std::string() : toml_quoted(config.folder.string());
          }},
      texts("hosts", kGroup, &Config::hosts, "[\"node1\", \"4/node2\"]",
            "hosts: where to play; 4/NAME for four parallel matches"),
      text("remote_shell", kGroup, &Config::remote_shell, "\"ssh -o BatchMode=yes {host}\"",
           "hosts: command that runs a command line on {host}"),
      text("remote_folder", kGroup, &Config::remote_folder, "\".cache/cls\"",
           "hosts: folder there for teams and running matches"),
      text("on_event", kGroup, &Config::on_event, "\"./chat.sh\"",
           "command at start, goal, half time, end and failure of each match"),
      text("on_match_finish", kGroup, &Config::on_match_finish, "\"cat >>matches.jsonl\"",
           "command after each match; gets the match as JSON on stdin"),
      text("on_finish", kGroup, &Config::on_finish, "\"cat >report.json\"",
           "command at the end; gets the report as JSON on stdin"),
      seconds("hook_limit", kGroup, &Config::hook_limit_s, "60",
              "seconds for each of these commands, and for all at the end"),
  };
}

Result<void> parse_columns(Config& config, const ConfigValue& value) {
  const auto* names = std::get_if<std::vector<std::string>>(&value);
  if (names == nullptr) return Error{"must be a list of columns, [\"rank\", \"team\", ...]"};
  for (const std::string& name : *names) {
    if (std::find(kStandingsColumns.begin(), kStandingsColumns.end(), name) ==
        kStandingsColumns.end()) {
      return Error{unknown_value(name, {kStandingsColumns.begin(), kStandingsColumns.end()})};
    }
  }
  config.columns = *names;
  return {};
}

std::vector<Row> report_rows() {
  constexpr Group kGroup = Group::kReport;
  return {
      text("name", kGroup, &Config::name, "\"Autumn cup\"",
           "name of the tournament in reports (default: that of its folder)"),
      Row{"columns", kGroup, "columns of the standings (cls tournament report --help lists them)",
          "[\"rank\", \"team\", \"points\"]", parse_columns,
          [](const Config& config) {
            return config.columns.empty() ? std::string() : toml_list(config.columns);
          }},
      texts("start_times", kGroup, &Config::start_times,
            "[\"2027-07-15 09:00\", \"final day: 2027-07-18 10:00\"]",
            "when the tournament and its stages begin, for the times in the plan"),
      number("slot_minutes", kGroup, &Config::slot_minutes, "minutes", "20",
             "minutes from one match to the next on a server (default: by half_time and mode)"),
  };
}

}  // namespace

const std::vector<ConfigKey>& tournament_keys() {
  static const std::vector<ConfigKey> keys = [] {
    std::vector<ConfigKey> all = schedule_rows();
    for (auto rows :
         {option_rows(match::OptionUse::kConditions, Group::kConditions), execution_rows(),
          option_rows(match::OptionUse::kExecution, Group::kExecution), report_rows()}) {
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

ConfigValue parse_config_value(const ConfigKey& key, std::string_view text) {
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
  if (key.name == "gauntlet" || key.name == "tie_breakers" || key.name == "columns" ||
      key.name == "hosts" || key.name == "start_times")
    return split(text, ',');
  if (key.name == "matches") {
    std::vector<std::vector<std::string>> pairings;
    for (const std::string& one : split(text, ',')) pairings.push_back(split(one, ':'));
    return pairings;
  }
  if (text == "true" || text == "false") return text == "true";
  std::int64_t whole = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, whole);
  if (read.ptr == end && read.ec == std::errc() && !text.empty()) return whole;
  double real = 0.0;
  if (std::from_chars(text.data(), end, real).ptr == end && !text.empty()) return real;
  return std::string(text);
}

std::string unknown_key(std::string_view what, std::string_view name,
                        const std::vector<std::string_view>& known) {
  const std::string_view near = base::nearest_name(name, known);
  return fmt::format("unknown {} '{}'{}", what, name,
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

}  // namespace cls::tournament
