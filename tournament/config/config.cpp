// Validation of a configuration.
#include "tournament/config/config.h"

#include <fmt/format.h>

#include <tuple>

#include "league/schedule/formats.h"
#include "match/terms/endpoint.h"
#include "match/terms/match_settings.h"
#include "match/terms/option_table.h"
#include "match/terms/server_choice.h"
#include "tournament/config/host_list.h"
#include "tournament/config/start_times.h"

namespace cls::tournament {
namespace {

void check_conditions(ErrorList& errors, const Conditions& conditions) {
  match::MatchOptions options;
  for (const ServerSetting& setting : conditions.settings) {
    const auto applied = match::apply_match_setting(options, setting.name + "=" + setting.value);
    errors.require(applied.ok(), applied ? "" : "[server] " + applied.error().message);
  }
  errors.add(match::set_options(options, conditions.options));

  const match::MatchOptions whole = match_options(conditions);
  const std::string length = match::length_problem(whole.server, whole.cycles, "set cycles");
  errors.require(length.empty(), length);
}

// Only teams that reach other hosts as copies of their folders, and built-in mocks, play there.
bool plays_elsewhere(const match::Endpoint& endpoint) {
  if (endpoint.kind == match::Endpoint::Kind::kTeam) return endpoint.parts.empty();
  return endpoint.kind == match::Endpoint::Kind::kMock &&
         endpoint.behavior.find('.') == std::string::npos && endpoint.planner_file.empty() &&
         !endpoint.has_policy_file();
}

void check_hosts(ErrorList& errors, const TournamentConfig& config) {
  const Execution& execution = config.execution;
  if (execution.executor != ExecutorKind::kHosts) return;
  errors.require(!execution.hosts.empty(), "executor = \"hosts\" needs at least one host in hosts");
  errors.require(!config.conditions.options.contains("book"),
                 "executor = \"hosts\": a book of situations is not copied to other hosts");
  const auto hosts = parse_hosts(execution.hosts);
  errors.require(hosts.ok(), hosts ? "" : hosts.error().message);

  const std::string& shell = execution.remote_shell;
  errors.require(shell.empty() || shell.find("{host}") != std::string::npos,
                 "remote_shell: {host} is missing");
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/-";
  errors.require(execution.remote_folder.find_first_not_of(kPlain) == std::string::npos,
                 "remote_folder: only letters, digits and . _ / -");

  for (const TeamEntry& team : config.competition.teams) {
    const auto endpoint = match::parse_endpoint(team.endpoint);
    errors.require(
        !endpoint || plays_elsewhere(*endpoint),
        fmt::format("team {} ({}): on other hosts only team:DIR and built-in mocks play; "
                    "`cls package-team` makes such a folder",
                    team.name, team.endpoint));
  }
}

}  // namespace

match::MatchOptions match_options(const Conditions& conditions) {
  match::MatchOptions options;
  std::ignore = match::set_options(options, conditions.options);
  for (const ServerSetting& setting : conditions.settings) {
    std::ignore = match::apply_setting(options, setting.name + "=" + setting.value);
  }
  return options;
}

std::vector<std::string> validate(const TournamentConfig& config) {
  ErrorList errors;
  errors.add(competition_errors(config.competition));
  check_conditions(errors, config.conditions);
  check_hosts(errors, config);

  const auto times = parse_start_times(config.report.start_times);
  errors.require(times.ok(), times ? "" : times.error().message);
  return errors.take();
}

std::string twin_sides(const TournamentConfig& config) {
  if (!config.competition.swap_sides) return {};
  const std::vector<TeamEntry>& teams = config.competition.teams;
  for (std::size_t i = 0; i < teams.size(); ++i) {
    for (std::size_t k = i + 1; k < teams.size(); ++k) {
      if (teams[i].endpoint != teams[k].endpoint) continue;
      return fmt::format(
          "{} and {} are the same side: the two matches of a pair on one seed are the same frames "
          "with other names, unless their programs draw numbers of their own; use one of them, or "
          "swap_sides = false",
          teams[i].name, teams[k].name);
    }
  }
  return {};
}

}  // namespace cls::tournament
