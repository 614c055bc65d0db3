// The rows of the key table.
#include "tournament/config/config_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "base/text/split.h"
#include "base/text/suggestion.h"
#include "league/schedule/formats.h"
#include "match/terms/match_options.h"
#include "match/terms/option_table.h"

namespace cls::tournament {
namespace {

using base::Error;
using base::Result;
using Config = TournamentConfig;

// The block of a configuration that a member belongs to, and its group.
template <class Whole>
auto& block(Whole& config, const Competition* /*type*/) {
  return config.competition;
}
template <class Whole>
auto& block(Whole& config, const Execution* /*type*/) {
  return config.execution;
}
template <class Whole>
auto& block(Whole& config, const Presentation* /*type*/) {
  return config.report;
}
constexpr KeyGroup group_of(const Competition* /*type*/) { return KeyGroup::kSchedule; }
constexpr KeyGroup group_of(const Execution* /*type*/) { return KeyGroup::kExecution; }
constexpr KeyGroup group_of(const Presentation* /*type*/) { return KeyGroup::kReport; }

// The placeholder of values that are read like this.
std::string_view placeholder_of(ReadText read) {
  const std::pair<ReadText, std::string_view> placeholders[] = {{read_flag, "true|false"},
                                                                {read_whole, "N"},
                                                                {read_number, "X"},
                                                                {read_list, "A,B,..."},
                                                                {read_pairings, "A:B,..."}};
  const auto* found =
      std::ranges::find(placeholders, read, &std::pair<ReadText, std::string_view>::first);
  return found == std::end(placeholders) ? "TEXT" : found->second;
}

// `name`: the key, and the placeholder of its value where the type does not say it: "folder DIR".
template <class Block, class Value>
ConfigKey row(std::string_view name, Value Block::*member, ValueType<Value> type,
              std::string_view example, std::string_view help) {
  constexpr const Block* kType = nullptr;
  const std::vector<std::string_view> words = base::split(name, ' ');
  return {
      .name = words.front(),
      .group = group_of(kType),
      .help = help,
      .example = example,
      .placeholder = words.size() > 1 ? words[1] : placeholder_of(type.read),
      .read = type.read,
      .parse = [=](Config& config, const ConfigValue& value) -> Result<void> {
        TRY_INIT(block(config, kType).*member, type.parse(value));
        return {};
      },
      .format = [=](const Config& config) { return type.format(block(config, kType).*member); }};
}

std::vector<std::string_view> format_names() {
  std::vector<std::string_view> names;
  std::ranges::transform(formats(), std::back_inserter(names), &FormatRules::name);
  return names;
}

// "round-robin, gauntlet or list".
std::string format_help() {
  std::vector<std::string_view> names = format_names();
  const std::string_view last = names.back();
  names.pop_back();
  return fmt::format("{} or {}", fmt::join(names, ", "), last);
}

ValueType<std::uint64_t> seed_type() {
  return {read_whole,
          [](const ConfigValue& value) -> Result<std::uint64_t> {
            const auto* read = std::get_if<std::int64_t>(&value);
            if (read == nullptr || *read < 0) return Error{"must be a whole number from 0"};
            return static_cast<std::uint64_t>(*read);
          },
          [](std::uint64_t seed) { return fmt::to_string(seed); }};
}

ValueType<std::vector<Texts>> matches_type() {
  return {read_pairings,
          [](const ConfigValue& value) -> Result<std::vector<Texts>> {
            const auto* pairings = std::get_if<std::vector<Texts>>(&value);
            if (pairings == nullptr) return Error{"must be a list of pairs, [[\"A\", \"B\"], ...]"};
            for (const Texts& pairing : *pairings) {
              if (pairing.size() == 2) continue;
              return Error{
                  fmt::format("'{}' is not a pairing of two teams, as A:B in --matches A:B,C:D or "
                              "[\"A\", \"B\"] in cls.toml",
                              fmt::join(pairing, ":"))};
            }
            return *pairings;
          },
          [](const std::vector<Texts>& pairings) {
            return pairings.empty() ? std::string() : toml_list(pairings);
          }};
}

ValueType<std::vector<TieBreaker>> tie_breakers_type() {
  const ValueType<TieBreaker> one = choice<TieBreaker>(list_of(kTieBreakers));
  return {read_list,
          [one](const ConfigValue& value) -> Result<std::vector<TieBreaker>> {
            const auto* names = std::get_if<Texts>(&value);
            if (names == nullptr) return Error{"must be a list of tiebreakers"};
            std::vector<TieBreaker> breakers;
            for (const std::string& text : *names) {
              TRY_INIT(const TieBreaker breaker, one.parse(text));
              breakers.push_back(breaker);
            }
            return breakers;
          },
          [](const std::vector<TieBreaker>& breakers) {
            Texts names;
            for (const TieBreaker breaker : breakers) names.emplace_back(name(breaker));
            return names.empty() ? std::string() : toml_list(names);
          }};
}

constexpr int kMaxConcurrency = 4096;

ValueType<int> concurrency_type() {
  return {read_whole,
          [](const ConfigValue& value) -> Result<int> {
            if (value == ConfigValue("auto")) return 0;
            const auto* count = std::get_if<std::int64_t>(&value);
            if (count != nullptr && *count >= 1 && *count <= kMaxConcurrency) {
              return static_cast<int>(*count);
            }
            return Error{
                fmt::format("must be \"auto\" or a whole number from 1 to {}", kMaxConcurrency)};
          },
          [](int count) { return count == 0 ? toml_quoted("auto") : fmt::to_string(count); }};
}

ValueType<std::filesystem::path> path_type() {
  const ValueType<std::string> path = text();
  return {path.read,
          [path](const ConfigValue& value) -> Result<std::filesystem::path> {
            TRY_INIT(std::string read, path.parse(value));
            return std::filesystem::path(std::move(read));
          },
          [path](const std::filesystem::path& value) { return path.format(value.string()); }};
}

ValueType<Texts> slurm_options_type() {
  ValueType<Texts> type = texts(
      "must be a list of options, [\"--partition=short\", ...]", [](const std::string& option) {
        if (option.starts_with("-")) return std::string();
        return fmt::format("'{}': sbatch options must have the form --name=value", option);
      });
  type.read = read_shell_words;
  return type;
}

std::string column_error(const std::string& name) {
  if (std::ranges::find(kStandingsColumns, name) != kStandingsColumns.end()) return "";
  return unknown_value(name, {kStandingsColumns.begin(), kStandingsColumns.end()});
}

ReadText reader_of(base::ValueKind kind) {
  switch (kind) {
    case base::ValueKind::kFlag:
      return read_flag;
    case base::ValueKind::kWhole:
    case base::ValueKind::kUnsigned:
      return read_whole;
    case base::ValueKind::kNumber:
      return read_number;
    case base::ValueKind::kText:
      break;
  }
  return read_text;
}

// The text of a value; nothing if the option cannot have a value of this type.
std::optional<std::string> text_of(base::ValueKind kind, const ConfigValue& value) {
  const ReadText read = reader_of(kind);
  if (const auto* whole = std::get_if<std::int64_t>(&value); whole && read == read_whole) {
    return fmt::to_string(*whole);
  }
  if (const auto number = number_in(value); number && read == read_number) {
    return fmt::format("{}", *number);
  }
  if (const auto* flag = std::get_if<bool>(&value); flag && read == read_flag) {
    return *flag ? "true" : "false";
  }
  const bool takes_text = read == read_text || read == read_flag;  // a flag may have words
  if (const auto* text = std::get_if<std::string>(&value); text && takes_text) return *text;
  return std::nullopt;
}

Result<void> parse_option(const match::MatchOption& option, Config& config,
                          const ConfigValue& value) {
  const auto text = text_of(option.form.kind, value);
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
  config.conditions.options[std::string(option.key)] = *text;
  return {};
}

// A flag may have words, which TOML knows as strings only.
bool is_string(const base::ValueForm& form, const std::string& text) {
  return form.kind == base::ValueKind::kText ||
         std::ranges::find(form.words, text) != form.words.end();
}

// The options of a match that cls.toml may have.
std::vector<ConfigKey> option_rows(match::OptionUse use, KeyGroup group) {
  std::vector<ConfigKey> rows;
  for (const match::MatchOption& option : match::match_options()) {
    if (option.use != use) continue;
    const ReadText read = reader_of(option.form.kind);
    const std::string_view placeholder =
        option.placeholder.empty() ? placeholder_of(read) : option.placeholder;
    rows.push_back({option.key, group, option.help, option.example, placeholder, read,
                    [&option](Config& config, const ConfigValue& value) {
                      return parse_option(option, config, value);
                    },
                    [&option](const Config& config) {
                      const auto text = config.conditions.options.find(option.key);
                      if (text == config.conditions.options.end()) return std::string();
                      return is_string(option.form, text->second) ? toml_quoted(text->second)
                                                                  : text->second;
                    }});
  }
  return rows;
}

std::vector<ConfigKey> schedule_rows() {
  static const std::string help = format_help();
  return {
      row("format FORMAT", &Competition::format, choice<Format>(format_names()), "\"round-robin\"",
          help),
      row("rounds", &Competition::rounds, optional(whole(1, 1'000'000)), "1",
          "times each pairing is played (once per side); swiss: number of rounds"),
      row("seed", &Competition::seed, seed_type(), "1", "seed of all match seeds and draws"),
      row("swap_sides", &Competition::swap_sides, flag(), "true",
          "play each pairing twice on the same seed, once from each side"),
      row("draw", &Competition::draw, flag(), "false",
          "random seeding order instead of the order of the teams"),
      row("gauntlet", &Competition::gauntlet, text_or_texts("must be a list of team names"),
          "[\"NEW\"]", "gauntlet: the teams that meet all others"),
      row("matches", &Competition::matches, matches_type(), "[[\"A\", \"B\"]]",
          "list: the pairings; as an option A:B,C:D"),
      row("groups", &Competition::groups, whole(1, 1000), "2", "groups: number of groups"),
      row("advance", &Competition::advance, whole(1, 1000), "2",
          "groups: teams of each group that advance to the knockout"),
      row("third_place", &Competition::third_place, flag(), "true",
          "knockout and groups: the losing semi-finalists play for third place"),
      row("tie_breakers", &Competition::tie_breakers, tie_breakers_type(),
          "[\"head-to-head\", \"goal-difference\", \"goals\"]",
          "criteria that order teams with the same points"),
  };
}

std::vector<ConfigKey> execution_rows() {
  return {
      row("concurrency N|auto", &Execution::concurrency, concurrency_type(), "\"auto\"",
          "parallel matches: a number, or \"auto\" (by cores)"),
      row("pin", &Execution::pin, flag(), "false", "pin each running match to its own cores"),
      row("executor WHERE", &Execution::executor, choice<ExecutorKind>(list_of(kExecutorNames)),
          "\"local\"", "where matches run: local, slurm or hosts"),
      row("slurm_options OPTIONS", &Execution::slurm_options, slurm_options_type(),
          "[\"--partition=short\"]", "slurm: options for sbatch"),
      row("slurm_tasks", &Execution::slurm_tasks, whole(1, 1'000'000), "1000",
          "slurm: maximum of pending and running matches"),
      row("slurm_poll", &Execution::slurm_poll_s, optional(positive("seconds")), "10",
          "slurm: seconds between squeue polls"),
      row("on_crash WHAT", &Execution::on_crash, choice<OnCrash>(list_of(kOnCrashNames)),
          "\"stop\"", "after an invalid match: stop, forfeit (0:3) or rerun"),
      row("max_reruns", &Execution::max_reruns, whole(0, 1000), "2",
          "rerun: maximum reruns of a match"),
      row("keep_logs WHICH", &Execution::keep_logs, choice<KeepLogs>(list_of(kKeepLogsNames)),
          "\"all\"", "match folders to keep: all, failed or none"),
      row("folder DIR", &Execution::folder, path_type(), "\".\"",
          "base of relative paths in endpoints (default: folder of this file)"),
      row("hosts", &Execution::hosts, text_or_texts("must be a list of strings"),
          "[\"node1\", \"4/node2\"]", "hosts: where to play; 4/NAME for four parallel matches"),
      row("remote_shell COMMAND", &Execution::remote_shell, text(),
          "\"ssh -o BatchMode=yes {host}\"", "hosts: command that runs a command line on {host}"),
      row("remote_folder DIR", &Execution::remote_folder, text(), "\".cache/cls\"",
          "hosts: folder there for teams and running matches"),
      row("on_event COMMAND", &Execution::on_event, text(), "\"./chat.sh\"",
          "command at start, goal, half time, end and failure of each match"),
      row("on_match_finish COMMAND", &Execution::on_match_finish, text(), "\"cat >>matches.jsonl\"",
          "command after each match; gets the match as JSON on stdin"),
      row("on_finish COMMAND", &Execution::on_finish, text(), "\"cat >report.json\"",
          "command at the end; gets the report as JSON on stdin"),
      row("hook_limit", &Execution::hook_limit_s, optional(positive("seconds")), "60",
          "seconds for each of these commands, and for all at the end"),
  };
}

std::vector<ConfigKey> report_rows() {
  return {
      row("name NAME", &Presentation::name, text(), "\"Autumn cup\"",
          "name of the tournament in reports (default: that of its folder)"),
      row("columns", &Presentation::columns,
          texts("must be a list of columns, [\"rank\", \"team\", ...]", column_error),
          "[\"rank\", \"team\", \"points\"]",
          "columns of the standings (cls tournament report --help lists them)"),
      row("start_times", &Presentation::start_times, text_or_texts("must be a list of strings"),
          "[\"2027-07-15 09:00\", \"final day: 2027-07-18 10:00\"]",
          "when the tournament and its stages begin, for the times in the plan"),
      row("slot_minutes", &Presentation::slot_minutes, optional(positive("minutes")), "20",
          "minutes from one match to the next on a server (default: by half_time and mode)"),
  };
}

}  // namespace

const std::vector<ConfigKey>& tournament_keys() {
  static const std::vector<ConfigKey> keys = [] {
    std::vector<ConfigKey> all = schedule_rows();
    for (auto rows :
         {option_rows(match::OptionUse::kConditions, KeyGroup::kConditions), execution_rows(),
          option_rows(match::OptionUse::kExecution, KeyGroup::kExecution), report_rows()}) {
      std::ranges::move(rows, std::back_inserter(all));
    }
    return all;
  }();
  return keys;
}

const ConfigKey* find_key(std::string_view name) {
  const auto found = std::ranges::find(tournament_keys(), name, &ConfigKey::name);
  return found == tournament_keys().end() ? nullptr : &*found;
}

std::string unknown_key(std::string_view what, std::string_view name,
                        const std::vector<std::string_view>& known) {
  const std::string_view near = base::nearest_name(name, known);
  return fmt::format("unknown {} '{}'{}", what, name,
                     near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
}

}  // namespace cls::tournament
