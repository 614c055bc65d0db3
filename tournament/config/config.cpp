// Names of configuration values, and validation of a configuration.
#include "tournament/config/config.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/text/suggestion.h"
#include "match/terms/endpoint.h"
#include "match/terms/match_settings.h"
#include "match/terms/option_table.h"
#include "match/terms/server_choice.h"
#include "tournament/config/host_list.h"
#include "tournament/config/start_times.h"

namespace cls::tournament {
namespace {

std::string unknown_team(const TournamentConfig& config, std::string_view key,
                         std::string_view name) {
  std::vector<std::string_view> known;
  for (const TeamEntry& team : config.teams) known.push_back(team.name);
  const std::string_view near = base::nearest_name(name, known);
  return fmt::format("{}: unknown team '{}'{}", key, name,
                     near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
}

constexpr std::size_t kMaxTeams = 1000;
constexpr double kMaxMatches = 1e6;

class ErrorList {
 public:
  void require(bool condition, std::string message) {
    if (!condition) lines_.push_back(std::move(message));
  }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::vector<std::string> lines_;
};

void check_teams(ErrorList& errors, const TournamentConfig& config) {
  errors.require(config.teams.size() >= 2,
                 fmt::format("a tournament requires at least two teams, there {}; add [teams.NAME] "
                             "with an endpoint for each",
                             config.teams.empty() ? "is none" : "is one"));
  errors.require(config.teams.size() <= kMaxTeams,
                 fmt::format("a tournament has at most {} teams, there are {}", kMaxTeams,
                             config.teams.size()));
  std::set<std::string> seen;
  for (const TeamEntry& team : config.teams) {
    errors.require(seen.insert(team.name).second,
                   fmt::format("duplicate team name '{}'", team.name));
  }
}

void check_pairings(ErrorList& errors, const TournamentConfig& config) {
  for (const std::string& subject : config.gauntlet) {
    errors.require(team_index(config, subject) >= 0, unknown_team(config, "gauntlet", subject));
  }
  for (const auto& pairing : config.matches) {
    for (const std::string& team : pairing) {
      errors.require(team_index(config, team) >= 0, unknown_team(config, "matches", team));
    }
    errors.require(
        pairing.size() == 2 && pairing[0] != pairing[1],
        fmt::format("matches: [{}] does not name two different teams", fmt::join(pairing, ", ")));
  }
  errors.require(config.format != Format::kGauntlet || !config.gauntlet.empty(),
                 "format 'gauntlet' requires the key gauntlet with the teams that meet all others");
  errors.require(config.format != Format::kList || !config.matches.empty(),
                 "format 'list' requires the key matches");
}

// Requires that the schedule has a possible number of matches.
void check_size(ErrorList& errors, const TournamentConfig& config) {
  const auto teams = static_cast<double>(config.teams.size());
  const double pairings =
      config.format == Format::kList       ? static_cast<double>(config.matches.size())
      : config.format == Format::kGauntlet ? teams * static_cast<double>(config.gauntlet.size())
                                           : teams * (teams - 1) / 2;
  double matches = pairings * rounds_of(config) * (config.swap_sides ? 2 : 1);
  if (config.format == Format::kStages) {
    matches = 0;
    for (const Stage& stage : config.stages) matches += pairings * stage.legs;
  }
  errors.require(config.format == Format::kSwiss || matches <= kMaxMatches,
                 fmt::format("a schedule of about {:.0f} matches; at most {:.0f} are possible",
                             matches, kMaxMatches));
}

void check_groups(ErrorList& errors, const TournamentConfig& config) {
  if (config.format != Format::kGroups) return;
  const int teams = static_cast<int>(config.teams.size());
  errors.require(teams >= 2 * config.groups,
                 fmt::format("{} groups require at least {} teams, there are {}", config.groups,
                             2 * config.groups, teams));
  errors.require(config.advance <= teams / std::max(1, config.groups),
                 fmt::format("advance = {}: the smallest group has only {} teams", config.advance,
                             teams / std::max(1, config.groups)));
  errors.require(config.groups * config.advance >= 2,
                 "a knockout requires at least two teams; increase groups or advance");
}

void check_stages(ErrorList& errors, const TournamentConfig& config) {
  const bool staged = config.format == Format::kStages;
  errors.require(staged == !config.stages.empty(),
                 staged ? "format 'stages' requires [[stages]], each with a name"
                        : fmt::format("[[stages]] belong to format 'stages', not to '{}'",
                                      name(config.format)));
  if (!staged) return;
  errors.require(!config.rounds, "rounds: a stage has `legs` instead");
  std::vector<std::string> teams;
  for (const TeamEntry& team : config.teams) teams.push_back(team.name);
  for (std::string& error : stage_errors(config.stages, teams)) {
    errors.require(false, std::move(error));
  }
}

void check_conditions(ErrorList& errors, const TournamentConfig& config) {
  match::MatchOptions options;
  for (const ServerSetting& setting : config.settings) {
    const auto applied = match::apply_match_setting(options, setting.name + "=" + setting.value);
    errors.require(applied.ok(), applied ? "" : "[server] " + applied.error().message);
  }
  for (std::string& error : match::set_options(options, config.options)) {
    errors.require(false, std::move(error));
  }
  const match::MatchOptions whole = match_options(config);
  const std::string length = match::length_problem(whole.server, whole.cycles, "set cycles");
  errors.require(length.empty(), length);
}

// Teams reach other hosts as copies of their folders.
void check_hosts(ErrorList& errors, const TournamentConfig& config) {
  if (config.executor != ExecutorKind::kHosts) return;
  errors.require(!config.hosts.empty(), "executor = \"hosts\" needs at least one host in hosts");
  errors.require(!config.options.contains("book"),
                 "executor = \"hosts\": a book of situations is not copied to other hosts");
  const auto hosts = parse_hosts(config.hosts);
  errors.require(hosts.ok(), hosts ? "" : hosts.error().message);
  const std::string& shell = config.remote_shell;
  errors.require(shell.empty() || shell.find("{host}") != std::string::npos,
                 "remote_shell: {host} is missing");
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("._/-").find(c) != std::string_view::npos;
  };
  errors.require(std::all_of(config.remote_folder.begin(), config.remote_folder.end(), plain),
                 "remote_folder: only letters, digits and . _ / -");
  for (const TeamEntry& team : config.teams) {
    const auto endpoint = match::parse_endpoint(team.endpoint);
    if (!endpoint) continue;
    const bool copied = endpoint->kind == match::Endpoint::Kind::kTeam && endpoint->parts.empty();
    const bool built_in = endpoint->kind == match::Endpoint::Kind::kMock &&
                          endpoint->behavior.find('.') == std::string::npos &&
                          endpoint->planner_file.empty();
    errors.require(
        copied || built_in,
        fmt::format("team {} ({}): on other hosts only team:DIR and built-in mocks play; "
                    "`cls package-team` makes such a folder",
                    team.name, team.endpoint));
  }
}

// With more rounds two teams would meet twice.
int max_swiss_rounds(const TournamentConfig& config) {
  const int teams = static_cast<int>(config.teams.size());
  return teams % 2 == 0 ? teams - 1 : teams;
}

}  // namespace

match::MatchOptions match_options(const TournamentConfig& config) {
  match::MatchOptions options;
  static_cast<void>(match::set_options(options, config.options));
  for (const ServerSetting& setting : config.settings) {
    static_cast<void>(match::apply_setting(options, setting.name + "=" + setting.value));
  }
  return options;
}

int rounds_of(const TournamentConfig& config) {
  if (config.rounds) return *config.rounds;
  if (config.format != Format::kSwiss) return 1;
  int rounds = 1;
  for (std::size_t reach = 1; reach < config.teams.size(); reach *= 2) ++rounds;
  return std::min(rounds, max_swiss_rounds(config));
}

int team_index(const TournamentConfig& config, std::string_view name) {
  const auto found = std::find_if(config.teams.begin(), config.teams.end(),
                                  [name](const TeamEntry& team) { return team.name == name; });
  return found == config.teams.end() ? -1 : static_cast<int>(found - config.teams.begin());
}

std::vector<std::string> validate(const TournamentConfig& config) {
  ErrorList errors;
  check_teams(errors, config);
  check_pairings(errors, config);
  check_groups(errors, config);
  check_stages(errors, config);
  check_size(errors, config);
  check_conditions(errors, config);
  check_hosts(errors, config);
  const auto times = parse_start_times(config.start_times);
  errors.require(times.ok(), times ? "" : times.error().message);
  const int teams = static_cast<int>(config.teams.size());
  errors.require(
      config.format != Format::kSwiss || teams < 2 || rounds_of(config) <= max_swiss_rounds(config),
      fmt::format("rounds = {}: {} teams can play at most {} Swiss rounds without "
                  "meeting twice",
                  rounds_of(config), teams, max_swiss_rounds(config)));
  return errors.take();
}

std::string_view name(Format format) {
  switch (format) {
    case Format::kRoundRobin:
      return "round-robin";
    case Format::kGauntlet:
      return "gauntlet";
    case Format::kList:
      return "list";
    case Format::kGroups:
      return "groups";
    case Format::kKnockout:
      return "knockout";
    case Format::kDoubleElimination:
      return "double-elimination";
    case Format::kSwiss:
      return "swiss";
    case Format::kStages:
      return "stages";
  }
  return "";
}

std::string_view name(OnCrash on_crash) {
  switch (on_crash) {
    case OnCrash::kStop:
      return "stop";
    case OnCrash::kForfeit:
      return "forfeit";
    case OnCrash::kRerun:
      return "rerun";
  }
  return "";
}

std::string_view name(ExecutorKind executor) {
  switch (executor) {
    case ExecutorKind::kLocal:
      return "local";
    case ExecutorKind::kSlurm:
      return "slurm";
    case ExecutorKind::kHosts:
      return "hosts";
  }
  return "";
}

std::string_view name(KeepLogs keep) {
  switch (keep) {
    case KeepLogs::kAll:
      return "all";
    case KeepLogs::kFailed:
      return "failed";
    case KeepLogs::kNone:
      return "none";
  }
  return "";
}

std::string_view name(TieBreaker breaker) {
  switch (breaker) {
    case TieBreaker::kHeadToHead:
      return "head-to-head";
    case TieBreaker::kGoalDifference:
      return "goal-difference";
    case TieBreaker::kGoalDifferenceAmong:
      return "goal-difference-among";
    case TieBreaker::kGoals:
      return "goals";
    case TieBreaker::kGoalsAmong:
      return "goals-among";
    case TieBreaker::kWins:
      return "wins";
    case TieBreaker::kBuchholz:
      return "buchholz";
    case TieBreaker::kMedianBuchholz:
      return "median-buchholz";
    case TieBreaker::kSonnebornBerger:
      return "sonneborn-berger";
  }
  return "";
}

}  // namespace cls::tournament
