// Finds the configuration and applies overrides from the command line.
#include "cli/tournament/tournament_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "match/terms/endpoint.h"
#include "match/terms/option_table.h"
#include "tournament/config/config_file.h"
#include "tournament/config/config_keys.h"
#include "tournament/store/folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;
namespace match = match;

std::string option_of(std::string_view key) {
  std::string option = "--" + std::string(key);
  std::ranges::replace(option, '_', '-');
  return option;
}

const char* group_title(KeyGroup group) {
  switch (group) {
    case KeyGroup::kSchedule:
      return "Schedule";
    case KeyGroup::kConditions:
      return "Matches";
    case KeyGroup::kExecution:
      return "Execution";
    case KeyGroup::kReport:
      return "Presentation";
  }
  return "";
}

// A configuration file, and whether it is that of the tournament and not of the working directory.
struct FoundConfig {
  std::optional<fs::path> path;
  bool own = true;
};

FoundConfig config_path(const TournamentOptions& options) {
  if (!options.config_file.empty()) return {options.config_file};
  std::error_code code;
  const fs::path inside = fs::path(options.folder) / kConfigFile;
  if (fs::is_regular_file(inside, code)) return {inside};
  if (auto above = find_config(fs::current_path(code))) return {std::move(above), false};

  const fs::path plan = fs::path(options.folder) / kPlanFile;
  if (fs::is_regular_file(plan, code)) return {plan};
  return {};
}

std::vector<std::string> apply_teams(TournamentConfig& config, const TournamentOptions& options) {
  std::vector<std::string> errors;
  for (const std::string& team : options.teams) {
    const std::size_t equals = team.find('=');
    if (equals == std::string::npos) {
      errors.push_back(fmt::format("--team '{}': must be NAME=ENDPOINT", team));
      continue;
    }

    const std::string name = team.substr(0, equals);
    const auto good = match::check_team_name(name);
    if (!good) errors.push_back("--team: " + good.error().message);
    const auto endpoint = match::parse_endpoint(team.substr(equals + 1));
    if (!endpoint) errors.push_back("--team: " + endpoint.error().message);

    const int known = team_index(config.competition, name);
    if (known < 0) {
      config.competition.teams.push_back({name, team.substr(equals + 1)});
    } else {
      config.competition.teams[base::index(known)].endpoint = team.substr(equals + 1);
    }
  }
  return errors;
}

std::vector<std::string> apply_overrides(TournamentConfig& config,
                                         const TournamentOptions& options) {
  std::vector<std::string> errors = apply_teams(config, options);
  for (const auto& [name, text] : options.overrides) {
    const ConfigKey& key = *find_key(name);
    const auto read = key.parse(config, key.read(text));
    if (!read) {
      errors.push_back(fmt::format("{} {}: {}", option_of(name), text, read.error().message));
    }
  }

  for (const std::string& setting : options.settings) {
    const std::size_t equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    std::erase_if(config.conditions.settings,
                  [&](const ServerSetting& one) { return one.name == name; });
    config.conditions.settings.push_back(
        {name, equals == std::string::npos ? "" : setting.substr(equals + 1)});
  }
  return errors;
}

void add_key_options(Command& command, TournamentOptions& options, bool schedule) {
  command.option("--set NAME=VALUE", options.settings, "server::NAME=VALUE, repeatable")
      .repeatable();
  for (const ConfigKey& key : tournament_keys()) {
    const bool of_tournament =
        key.group == KeyGroup::kReport || (key.group == KeyGroup::kSchedule && key.name != "seed");
    if (!schedule && of_tournament) continue;
    Option& option = command.option(option_of(key.name), options.overrides[std::string(key.name)],
                                    std::string(key.help));
    option.placeholder(std::string(key.placeholder)).of_group(group_title(key.group));
    if (key.read == tournament::read_flag) option.min_values = 0;
    const match::MatchOption* row = match::find_match_option(key.name);
    if (row != nullptr) option.form.phrase = row->form.phrase;
  }
}

void add_shared_options(Command& command, TournamentOptions& options, bool schedule) {
  command.option(
      "--config FILE", options.config_file,
      schedule ? "configuration file (default: DIR/cls.toml, or cls.toml in or above the working "
                 "directory)"
               : "configuration file (default: cls.toml in or above the working directory)");
  add_key_options(command, options, schedule);
}

void add_team_option(Command& command, TournamentOptions& options) {
  command
      .option("--team NAME=SIDE", options.teams,
              "a team: NAME=ENDPOINT, repeatable; added to those of DIR/cls.toml")
      .of_group(kTeamsGroup)
      .repeatable();
}

// The book of an option is looked for in the working directory, that of a file beside the file.
void resolve_book(TournamentConfig& config, bool option) {
  const auto book = config.conditions.options.find("book");
  if (book == config.conditions.options.end()) return;
  const fs::path folder = option ? fs::current_path() : fs::absolute(config.execution.folder);
  book->second = (folder / book->second).lexically_normal().string();
}

ChosenConfig read_and_override(TournamentOptions options, const FoundConfig& found) {
  const std::optional<fs::path>& path = found.path;
  std::erase_if(options.overrides, [](const auto& one) { return one.second.empty(); });
  ParsedConfig reading;
  if (path) {
    if (const int code = read_project(*path, reading); code != kOk) return {code, {}};
  }

  if (reading.config.execution.folder.empty()) reading.config.execution.folder = fs::current_path();
  // The teams of a project are not those of a tournament that names its own.
  if (!found.own && !options.teams.empty()) reading.config.competition.teams.clear();
  const auto usage = apply_overrides(reading.config, options);
  if (!usage.empty()) return {print_errors(kUsage, usage), {}};
  resolve_book(reading.config, is_given(options, "book"));
  return {kOk, std::move(reading.config)};
}

}  // namespace

bool is_given(const TournamentOptions& options, const std::string& key) {
  const auto found = options.overrides.find(key);
  return found != options.overrides.end() && !found->second.empty();
}

void add_condition_options(Command& command, TournamentOptions& options) {
  add_shared_options(command, options, false);
}

void add_tournament_options(Command& command, TournamentOptions& options) {
  command.option("DIR", options.folder, "folder of the tournament").required();
  add_team_option(command, options);
  add_shared_options(command, options, true);
}

void add_override_options(Command& command, TournamentOptions& options) {
  add_team_option(command, options);
  add_key_options(command, options, true);
}

ChosenConfig choose_conditions(const TournamentOptions& options) {
  return read_and_override(options, config_path(options));
}

ChosenConfig choose_config(const TournamentOptions& options) {
  const FoundConfig found = config_path(options);
  const std::optional<fs::path>& path = found.path;
  if (!path && options.teams.empty()) {
    return {print_error(kNoInput,
                        "no {} in {} or in or above the working directory; run `cls init`, "
                        "or use --config FILE or --team NAME=ENDPOINT",
                        kConfigFile, options.folder),
            {}};
  }

  ChosenConfig chosen = read_and_override(options, found);
  if (chosen.exit_code != kOk) return chosen;
  auto errors = validate(chosen.config);
  if (errors.empty()) return chosen;
  for (std::string& error : errors) {
    if (path) error = path->string() + ": " + error;
  }

  const bool overridden =
      !options.settings.empty() ||
      std::ranges::any_of(options.overrides, [](const auto& one) { return !one.second.empty(); });
  return {print_errors(path && !overridden ? kBadConfig : kUsage, errors), {}};
}

}  // namespace cls::cli
