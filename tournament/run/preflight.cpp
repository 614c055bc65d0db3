// Estimates from the configuration, the host and the matches played so far.
#include "tournament/run/preflight.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <utility>

#include "base/system/host.h"
#include "base/system/version.h"
#include "match/programs/team_sandbox.h"
#include "match/terms/endpoint.h"
#include "match/terms/match_options.h"
#include "match/terms/server_choice.h"
#include "process/command_plan.h"
#include "tournament/config/config_file.h"
#include "tournament/slots/concurrency.h"
#include "tournament/slots/timetable.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;

// Game log and text log of bundled teams, measured, compressed as tournaments do.
constexpr double kLogBytesPerCycle = 2000.0;
constexpr double kMegabyte = 1e6;

std::optional<StartProblem> check_team(const TournamentConfig& config, const TeamEntry& team,
                                       std::chrono::milliseconds patience) {
  const auto endpoint =
      match::parse_endpoint(endpoint_from(config.execution.folder, team.endpoint));
  if (!endpoint) {
    return StartProblem{match::EndpointProblem::Kind::kUnknown, endpoint.error().message};
  }
  // Elsewhere addresses, programs and start scripts may differ.
  const bool elsewhere = config.execution.executor == ExecutorKind::kSlurm;
  if (elsewhere && endpoint->kind != match::Endpoint::Kind::kMock) return std::nullopt;
  const auto problem = match::check_endpoint(*endpoint, patience);
  if (!problem) return std::nullopt;
  return StartProblem{problem->kind,
                      fmt::format("team {} ({}): {}", team.name, team.endpoint, problem->text)};
}

std::optional<StartProblem> check_server(const TournamentConfig& config) {
  const match::ServerChoice server = match_options(config.conditions).server_choice;
  const bool started = server.kind == match::ServerChoice::Kind::kProgram;
  if (!started || config.execution.executor != ExecutorKind::kLocal) return std::nullopt;
  const auto program = process::find_program(server.program);
  if (program) return std::nullopt;
  return StartProblem{match::EndpointProblem::Kind::kMissing,
                      "soccer server " + program.error().message};
}

// Cycles of normal time.
int cycles_of(const TournamentConfig& config) {
  const match::MatchOptions options = match_options(config.conditions);
  const int whole = options.server.normal_time_cycles();
  if (!options.cycles) return whole;
  return whole > 0 ? std::min(whole, *options.cycles) : *options.cycles;
}

int parallel_matches(const TournamentConfig& config) {
  return Concurrency(config, base::usable_cores()).current();
}

double bytes_of_logs(const TournamentConfig& config, double to_play) {
  const double stored = config.execution.keep_logs == KeepLogs::kAll
                            ? to_play
                            : std::min<double>(to_play, parallel_matches(config));
  return stored * cycles_of(config) * kLogBytesPerCycle;
}

bool has_external_team(const TournamentConfig& config) {
  return std::ranges::any_of(config.competition.teams, [](const TeamEntry& team) {
    const auto endpoint = match::parse_endpoint(team.endpoint);
    return endpoint && !endpoint->has_playmaker();
  });
}

}  // namespace

std::vector<StartProblem> check_start(const TournamentConfig& config,
                                      std::chrono::milliseconds patience) {
  std::vector<std::future<std::optional<StartProblem>>> checks;
  for (const TeamEntry& team : config.competition.teams) {
    checks.push_back(
        std::async(std::launch::async, check_team, std::cref(config), std::cref(team), patience));
  }

  std::vector<StartProblem> problems;
  for (auto& check : checks) {
    if (auto problem = check.get()) problems.push_back(*std::move(problem));
  }
  if (auto problem = check_server(config)) problems.push_back(*std::move(problem));
  return problems;
}

std::vector<std::string> host_warnings(const TournamentConfig& config,
                                       std::span<const ScheduledMatch> matches, double to_play,
                                       const fs::path& folder) {
  std::vector<std::string> lines;
  const int cores = base::usable_cores();
  if (config.execution.executor == ExecutorKind::kLocal && config.execution.concurrency > cores) {
    lines.push_back(fmt::format(
        "{} parallel matches on {} cores: they slow each other down and may miss cycles; "
        "--concurrency auto chooses {}",
        config.execution.concurrency, cores, cores));
  }

  std::error_code code;
  const fs::space_info space = fs::space(folder, code);
  const double needed = bytes_of_logs(config, to_play);
  if (!code && needed > static_cast<double>(space.available)) {
    lines.push_back(fmt::format(
        "the logs of {:.0f} matches need about {:.0f} MB, {} has {:.0f} MB left; --keep-logs "
        "failed keeps those of invalid matches only",
        to_play, needed / kMegabyte, folder.string(),
        static_cast<double>(space.available) / kMegabyte));
  }

  const bool local = config.execution.executor == ExecutorKind::kLocal;
  const match::MatchOptions options = match_options(config.conditions);
  if (local && has_external_team(config)) {
    if (std::string missing = missing_sandbox(options); !missing.empty()) {
      lines.push_back(std::move(missing));
    }
  }

  for (const ScheduledMatch& match : matches) {
    if (!match.outcome || match.outcome->version.empty()) continue;
    if (match.outcome->version == base::kVersion) continue;
    lines.push_back(fmt::format("cls {} played match {}, this is cls {}: results may differ",
                                match.outcome->version, match.fixture.index, base::kVersion));
    break;
  }
  return lines;
}

std::optional<double> expected_seconds(const TournamentConfig& config,
                                       std::span<const ScheduledMatch> matches, double to_play) {
  constexpr double kSecondsPerCycle = 0.1;
  if (config.execution.executor == ExecutorKind::kSlurm) return std::nullopt;
  const double rounds = to_play / parallel_matches(config);
  const PlayTime spent = play_time(matches);
  if (spent.matches > 0) return rounds * spent.seconds / spent.matches;
  if (mode_of(match_options(config.conditions)) != match::MatchMode::kRealtime) return std::nullopt;
  return rounds * cycles_of(config) * kSecondsPerCycle;
}

}  // namespace cls::tournament
