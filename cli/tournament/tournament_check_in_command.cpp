// `cls tournament check-in DIR`: starts every team once, before the first match.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "base/io/whole_file.h"
#include "base/system/own_program.h"
#include "base/text/counted.h"
#include "base/text/json.h"
#include "base/text/suggestion.h"
#include "base/text/table.h"
#include "cli/logs/analyzed_match.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/terminal.h"
#include "cli/tournament/tournament_options.h"
#include "gamelog/files/log_files.h"
#include "match/result/match_folder.h"
#include "match/result/match_result.h"
#include "soccer/side.h"
#include "tournament/slots/concurrency.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_attempt.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;

constexpr const char* kCheckInDescription =
    "start every team of a tournament once, under its conditions and limits\n"
    "\n"
    "  cls tournament check-in cup         a table of what each team did\n"
    "  cls tournament check-in cup RED     one team, after it was mended\n"
    "  cls tournament check-in cup --json  for scripts\n"
    "\n"
    "Each team plays 100 cycles against a team that stands still; nothing of the\n"
    "tournament changes. The logs are in DIR/check-in. Exit code 1: a team did not\n"
    "play to the end.";

constexpr const char* kCheckInFolder = "check-in";

struct CheckInArguments {
  TournamentOptions tournament;
  std::vector<std::string> teams;  // empty: all
  int cycles = 100;
  bool json = false;
};

// The progress of a team's check-in.
struct CheckIn {
  std::string team;      // in cls.toml
  std::string own_name;  // on the server
  bool played = false;
  std::string problem;
  int players = 0;  // that were connected
  int steps = 0;    // of all players
  int silent = 0;   // of these, without a command
  double cpu_seconds = 0.0;
  bool fixed_ports = false;  // starts on the ports 6000 to 6002 only
  fs::path logs;
};

// The match of one team: left, against a mock that holds its positions.
TournamentConfig config_of(const TournamentConfig& config, const TeamEntry& team, int cycles) {
  TournamentConfig one = config;
  one.competition.teams = {team, {team.name == "CHECK" ? "CHECKED" : "CHECK", "mock:hold"}};
  one.conditions.options["cycles"] = fmt::to_string(cycles);
  return one;
}

// Adds what result and logs say.
void read_logs(CheckIn& check) {
  const auto text = base::read_file(check.logs / match::kResultFile);
  if (!text) return;
  const auto result = match::parse_match_result(*text);
  if (!result) return;

  check.own_name = result->left.name;
  check.cpu_seconds = result->left.cpu_seconds;
  for (const auto& process : result->processes) {
    if (process.name.starts_with("left ")) check.cpu_seconds += process.cpu_seconds;
  }
  if (result->cycles == 0) return;  // without a frame in the log
  AnalyzedMatch match;
  if (read_match(check.logs.string(), match) != kOk || !match.statistics.responsiveness) return;

  for (std::size_t slot = 0; slot < soccer::kPlayersPerTeam; ++slot) {
    const analysis::Responsiveness& player = (*match.statistics.responsiveness)[slot];
    check.players += player.steps > 0;
    check.steps += player.steps;
    check.silent += player.silent;
  }
}

// Nothing when a signal interrupted it.
base::Result<std::optional<CheckIn>> check_in(process::ProcessHost& host,
                                              const TournamentConfig& config,
                                              const fs::path& folder, const fs::path& program,
                                              const std::atomic<int>& signal) {
  constexpr std::chrono::milliseconds kPollInterval{5};
  const TeamEntry& team = config.competition.teams.front();
  Fixture fixture;
  fixture.index = 1;
  fixture.right = 1;
  fixture.seed = 1;
  const fs::path logs = fs::path(kCheckInFolder) / team.name;
  TRY_INIT(auto attempt,
           MatchAttempt::start(host, config, fixture, 1, {folder, logs, program, {}}));

  while (!attempt.exited()) {
    std::this_thread::sleep_for(kPollInterval);
    attempt.end_overdue();
    if (signal != 0) attempt.interrupt();
  }

  CheckIn check;
  check.team = team.name;
  check.logs = folder / logs;
  check.fixed_ports = !fixed_port_team(config).empty();
  const auto outcome = attempt.outcome();
  if (!outcome) {
    check.problem = outcome.error().message;
    return std::optional(check);
  }
  if (!*outcome) return std::optional<CheckIn>();

  check.played = (*outcome)->played();
  check.problem = (*outcome)->message;
  if (check.problem.empty() && !(*outcome)->warnings.empty()) {
    check.problem = (*outcome)->warnings.front();
  }

  read_logs(check);
  return std::optional(check);
}

std::string share(int part, int whole) {
  return whole == 0 ? "-" : fmt::format("{:.1f} %", 100.0 * part / whole);
}

void print_table(const std::vector<CheckIn>& checks) {
  using Align = base::Table::Align;
  base::Table table;
  table.add_columns({"team", "name"});
  table.add_columns({"players", "missed", "CPU s"}, Align::kRight);
  table.add_columns({"ports", "result"});
  table.allow_folds(6);
  for (const CheckIn& check : checks) {
    std::string result = check.played ? "ok" : "FAILED";
    if (!check.problem.empty()) result += ": " + check.problem;
    table.add_row({check.team, check.own_name,
                   fmt::format("{}/{}", check.players, soccer::kPlayersPerTeam),
                   share(check.silent, check.steps), fmt::format("{:.1f}", check.cpu_seconds),
                   check.fixed_ports ? "6000-6002" : "any", result});
  }
  fmt::print("{}", table.format_text({0, stdout_width(), 1}));
}

void print_check_ins(const TournamentConfig& config, const std::vector<CheckIn>& checks) {
  using base::Json;
  Json teams = Json::array();

  for (const CheckIn& check : checks) {
    teams.push_back({{"team", check.team},
                     {"name", check.own_name},
                     {"played", check.played},
                     {"problem", check.problem.empty() ? Json(nullptr) : Json(check.problem)},
                     {"players", check.players},
                     {"player_cycles", check.steps},
                     {"missed", check.silent},
                     {"cpu_seconds", check.cpu_seconds},
                     {"fixed_ports", check.fixed_ports},
                     {"logs", check.logs.string()}});
  }

  const auto limit = [&config](const char* key) {
    const auto found = config.conditions.options.find(key);
    return found == config.conditions.options.end() ? Json(nullptr) : Json(found->second);
  };
  print_json({{"schema", "cls.check-in/1"},
              {"limits", {{"memory", limit("max_memory")}, {"cpu", limit("max_cpu")}}},
              {"teams", std::move(teams)}});
}

// Keeps the teams that are asked for. Returns an error if one of them does not exist.
std::optional<std::string> select_teams(const std::vector<std::string>& wanted,
                                        std::vector<TeamEntry>& teams) {
  if (wanted.empty()) return std::nullopt;
  std::vector<std::string_view> names;
  for (const TeamEntry& team : teams) names.push_back(team.name);
  for (const std::string& name : wanted) {
    if (std::ranges::find(names, name) != names.end()) continue;
    return fmt::format("unknown team '{}'{}", name, base::did_you_mean(name, names));
  }

  std::erase_if(teams, [&wanted](const TeamEntry& team) {
    return std::ranges::find(wanted, team.name) == wanted.end();
  });
  return std::nullopt;
}

int run_check_in(const CheckInArguments& arguments) {
  const ChosenConfig chosen = choose_config(arguments.tournament);
  if (chosen.exit_code != kOk) return chosen.exit_code;
  std::vector<TeamEntry> teams = chosen.config.competition.teams;
  if (const auto error = select_teams(arguments.teams, teams)) return print_error(kUsage, *error);
  const fs::path folder = arguments.tournament.folder;
  TRY_OR(kCannotCreate, gamelog::set_apart(folder / kCheckInFolder));
  TRY_INIT_OR(kUnavailable, const auto program, base::own_program());
  TRY_INIT_OR(kUnavailable, auto host, process::ProcessHost::create());

  const std::atomic<int>& signal = watch_interrupts();
  std::vector<CheckIn> checks;
  for (const TeamEntry& team : teams) {
    const TournamentConfig one = config_of(chosen.config, team, arguments.cycles);
    TRY_INIT_OR(kUnavailable, const auto check, check_in(host, one, folder, program, signal));
    if (!check) return signal_exit_code(signal);
    checks.push_back(*check);
    if (!arguments.json) {
      fmt::print(stderr, "cls: {}: {}\n", team.name, check->played ? "ok" : "FAILED");
    }
  }

  if (arguments.json) {
    print_check_ins(chosen.config, checks);
  } else {
    print_table(checks);
  }

  const auto failed =
      std::ranges::count_if(checks, [](const CheckIn& check) { return !check.played; });
  if (failed == 0) return kOk;

  return print_error(kFailed, "{} of {} did not play to the end; logs: {}", failed,
                     base::counted(checks.size(), "team"), (folder / kCheckInFolder).string());
}

}  // namespace

void add_tournament_check_in_command(Command& app) {
  auto [command, arguments] = app.command("check-in", kCheckInDescription, run_check_in);
  add_tournament_options(command, arguments.tournament);
  command.option("TEAM", arguments.teams, "names of teams (default: all)");
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli
