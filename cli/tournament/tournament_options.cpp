// Finding the configuration and putting the command line on top of it.
#include "cli/tournament/tournament_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>

#include "cli/support/exit_code.h"
#include "orchestration/match/options/endpoint.h"
#include "orchestration/tournament/config/config_file.h"
#include "orchestration/tournament/config/config_keys.h"
#include "orchestration/tournament/store/folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace orchestration::tournament;
namespace match = orchestration::match;

std::string option_of(std::string_view key) {
  std::string option = "--" + std::string(key);
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

std::optional<fs::path> config_path(const TournamentOptions& options) {
  if (!options.config_file.empty()) return options.config_file;
  std::error_code code;
  const fs::path inside = fs::path(options.folder) / kConfigFile;
  if (fs::is_regular_file(inside, code)) return inside;
  if (auto above = find_config(fs::current_path(code))) return above;
  const fs::path plan = fs::path(options.folder) / kPlanFile;
  if (fs::is_regular_file(plan, code)) return plan;
  return std::nullopt;
}

std::vector<std::string> apply_teams(TournamentConfig& config, const TournamentOptions& options) {
  std::vector<std::string> mistakes;
  for (const std::string& team : options.teams) {
    const std::size_t equals = team.find('=');
    if (equals == std::string::npos) {
      mistakes.push_back(fmt::format("--team '{}' is not of the form NAME=ENDPOINT", team));
      continue;
    }
    const std::string name = team.substr(0, equals);
    const auto good = match::check_team_name(name);
    if (!good) mistakes.push_back("--team: " + good.error().message);
    const auto endpoint = match::parse_endpoint(team.substr(equals + 1));
    if (!endpoint) mistakes.push_back("--team: " + endpoint.error().message);
    const int known = team_index(config, name);
    if (known < 0) {
      config.teams.push_back({name, team.substr(equals + 1)});
    } else {
      config.teams[static_cast<std::size_t>(known)].endpoint = team.substr(equals + 1);
    }
  }
  return mistakes;
}

std::vector<std::string> apply_overrides(TournamentConfig& config,
                                         const TournamentOptions& options) {
  std::vector<std::string> mistakes = apply_teams(config, options);
  for (const auto& [name, text] : options.overrides) {
    const ConfigKey& key = *find_key(name);
    const auto read = key.read(config, value_from_text(key, text));
    if (!read) {
      mistakes.push_back(fmt::format("{} {}: {}", option_of(name), text, read.error().message));
    }
  }
  for (const std::string& setting : options.settings) {
    const std::size_t equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    std::erase_if(config.settings, [&](const ServerSetting& one) { return one.name == name; });
    config.settings.push_back(
        {name, equals == std::string::npos ? "" : setting.substr(equals + 1)});
  }
  return mistakes;
}

int complain_all(int exit_code, const std::vector<std::string>& messages) {
  for (const std::string& message : messages) complain(exit_code, message);
  return exit_code;
}

void add_shared_options(CLI::App& command, TournamentOptions& options, bool schedule) {
  command.add_option("--config", options.config_file,
                     schedule ? "configuration (DIR/cls.toml, else cls.toml here or above)"
                              : "configuration (cls.toml here or above)");
  command.add_option("--set", options.settings, "server::NAME=VALUE, repeatable")
      ->expected(1)
      ->take_all();
  for (const ConfigKey& key : tournament_keys()) {
    if (!schedule && key.group == KeyGroup::kSchedule && key.name != "seed") continue;
    command.add_option(option_of(key.name), options.overrides[std::string(key.name)],
                       std::string(key.meaning));
  }
}

ChosenConfig read_and_override(TournamentOptions options, const std::optional<fs::path>& path) {
  std::erase_if(options.overrides, [](const auto& one) { return one.second.empty(); });
  ConfigReading reading;
  if (path) {
    std::error_code code;
    if (!fs::is_regular_file(*path, code)) {
      return {complain(kNoInput, fmt::format("no such file: {}", path->string())), {}};
    }
    reading = read_config(*path);
    if (!reading.mistakes.empty()) return {complain_all(kBadConfig, reading.mistakes), {}};
  }
  if (reading.config.folder.empty()) reading.config.folder = fs::current_path();
  const auto usage = apply_overrides(reading.config, options);
  if (!usage.empty()) return {complain_all(kUsage, usage), {}};
  return {kDone, std::move(reading.config)};
}

}  // namespace

int complain(int exit_code, const std::string& message) {
  fmt::print(stderr, "cls: {}\n", message);
  return exit_code;
}

void add_condition_options(CLI::App& command, TournamentOptions& options) {
  add_shared_options(command, options, false);
}

void add_tournament_options(CLI::App& command, TournamentOptions& options) {
  command.add_option("DIR", options.folder, "the tournament's folder")->required();
  command.add_option("--team", options.teams, "NAME=ENDPOINT, repeatable: one more team")
      ->expected(1)
      ->take_all();
  add_shared_options(command, options, true);
}

ChosenConfig choose_conditions(const TournamentOptions& options) {
  return read_and_override(options, config_path(options));
}

ChosenConfig choose_config(const TournamentOptions& options) {
  const auto path = config_path(options);
  if (!path && options.teams.empty()) {
    return {
        complain(kNoInput, fmt::format("no {} in {}, here or above: `cls init` writes one, or give "
                                       "--config FILE or --team NAME=ENDPOINT",
                                       kConfigFile, options.folder)),
        {}};
  }
  ChosenConfig chosen = read_and_override(options, path);
  if (chosen.exit_code != kDone) return chosen;
  auto mistakes = mistakes_in(chosen.config);
  if (mistakes.empty()) return chosen;
  for (std::string& mistake : mistakes) {
    if (path) mistake = path->string() + ": " + mistake;
  }
  const bool overridden =
      !options.settings.empty() || std::any_of(options.overrides.begin(), options.overrides.end(),
                                               [](const auto& one) { return !one.second.empty(); });
  return {complain_all(path && !overridden ? kBadConfig : kUsage, mistakes), {}};
}

}  // namespace cls::cli
