// `cls proxy`: the options of upstream's start script, one call, one line of result.
#include "cli/match/proxy_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/io/whole_file.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/script_options.h"
#include "cli/support/tls_options.h"
#include "cli/terminal/progress_line.h"
#include "cli/terminal/terminal.h"
#include "orchestration/match/lone_team.h"
#include "orchestration/match/options/endpoint.h"
#include "orchestration/match/sides/playmaker_link.h"
#include "proxy/formation/formation_set.h"
#include "soccer/side_name.h"

namespace cls::cli {
namespace {

using orchestration::match::EndReason;
using orchestration::match::LoneTeamOptions;
using orchestration::match::LoneTeamResult;

constexpr const char* kDescription =
    "Runs a team of players and their coach alone, for a soccer server that runs already.\n"
    "\n"
    "  cls proxy --teamname Blue --rpc-port 50051                 all twelve\n"
    "  cls proxy --teamname Blue --rpc-port 50051 --unum 5        one of them\n"
    "  cls proxy --teamname Blue --rpc-port 50051 --reconnect     back after a crash\n"
    "\n"
    "  cls proxy --teamname Blue --rpc-port 50051 --coach         the coach alone\n"
    "  cls proxy --teamname Gym --rpc-port 50051 -n 1 --trainer   a player and a trainer\n"
    "\n"
    "Takes the options of the start.sh of the Cross Language Soccer framework's proxy.";

constexpr int kCoach = 12;
constexpr int kHighestStep = 13;
constexpr int kRightPortOffset = 20;

struct Arguments {
  LoneTeamOptions options;
  std::string team_name = "SSP";
  int number = soccer::kPlayersPerTeam;
  int unum = 0;
  int timeout_s = 3;
  std::optional<int> deadline_ms;
  std::string on_late = "hold";
  std::string playmaker;
  TlsOptions tls;
  std::string result_file;
  std::string rpc_type = "grpc";
  bool quiet = false;
  std::string formation;
  int coach_port = 0;    // 0: two above the players'
  int trainer_port = 0;  // 0: one above the players'
  bool without_coach = false;
  bool coach_alone = false;
  bool trainer = false;
  std::string fullstate;  // accepted because scripts say it
};

void add_playmaker_options(CLI::App& command, Arguments& arguments) {
  LoneTeamOptions& options = arguments.options;
  const CLI::Range port(1, 65535);
  command.add_option("--playmaker", arguments.playmaker,
                     "HOST:PORT, HOST:PORT+step, tls:HOST:PORT or unix:PATH, in place of the next "
                     "three");
  command.add_option("--rpc-host", options.playmaker.host, "of the Playmaker (localhost)");
  command.add_option("--rpc-port", options.playmaker.port, "of the Playmaker (50051)")->check(port);
  command.add_flag("--rpc-port-step", options.playmaker.port_step, "player n asks port + n");
  command.add_flag("--rpc-add-20-to-port-for-right", options.add_20_for_right,
                   "a team on the right asks at ports that are 20 higher");
  command
      .add_option("--rpc-timeout", arguments.timeout_s,
                  "seconds for an answer (3); in real time the cycle is the limit")
      ->check(CLI::Range(1, 3600));
  command
      .add_option("--rpc-deadline", arguments.deadline_ms, "the same in milliseconds, if shorter")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--on-late", arguments.on_late,
                  "commands of a cycle without an answer: hold, last or default (hold)")
      ->check(CLI::IsMember({"hold", "last", "default"}));
  add_tls_options(command, arguments.tls);
  command.add_option("--result", arguments.result_file,
                     "file for the result in JSON, players one by one");
  command.add_option("--rpc-type", arguments.rpc_type, "grpc");
}

void add_options(CLI::App& command, Arguments& arguments) {
  LoneTeamOptions& options = arguments.options;
  command.set_help_flag("--help", "print this help");
  options.playmaker.host = "localhost";
  options.playmaker.port = 50051;
  const CLI::Range port(1, 65535);
  command.add_option("-h,--host", options.server_host, "of the soccer server (localhost)");
  command.add_option("-p,--port", options.server_port, "of the soccer server (6000)")->check(port);
  command.add_option("-t,--teamname,--team_name", arguments.team_name, "name of the team (SSP)");
  command.add_option("-n,--number", arguments.number, "players, goalie first (11)")
      ->check(CLI::Range(1, soccer::kPlayersPerTeam));
  command.add_option("-u,--unum", arguments.unum, "only this one; 1 is the goalie, 12 the coach")
      ->check(CLI::Range(1, kCoach));
  command.add_option("-v,--version", options.team.protocol, "of the text protocol, 14 to 19 (18)")
      ->check(CLI::Range(soccer::kOldestProtocolVersion, soccer::kNewestProtocolVersion));
  command.add_flag("-r,--reconnect", options.team.reconnect,
                   "take over players who lost their connection");
  add_playmaker_options(command, arguments);
  command
      .add_option("--start-timeout", options.start_timeout_s,
                  "seconds until server and Playmaker must answer (20)")
      ->check(CLI::PositiveNumber);
  command.add_flag("--quiet", arguments.quiet, "no progress, no warnings");
  command
      .add_option("-P,--coach-port", arguments.coach_port,
                  "of the soccer server (two above --port)")
      ->check(port);
  command.add_flag("-C,--without-coach", arguments.without_coach, "only the players");
  command.add_flag("--coach", arguments.coach_alone, "only the coach");
  command.add_flag("--trainer", arguments.trainer, "a trainer in place of the coach");
  command
      .add_option("--trainer-port", arguments.trainer_port,
                  "of the soccer server (one above --port)")
      ->check(port);
  command.add_option("-f,--formation", arguments.formation,
                     "folder with formations (built-in ones); see docs/formations.md");
  command.add_option("--debug-log", options.team.debug_log,
                     "folder for what the Playmaker logs, TEAM-NUMBER.log");
  command.add_option("--fullstate", arguments.fullstate, "accepted; senses alone are used");
}

// The Playmaker where one option names it; the exit code.
int read_playmaker(Arguments& arguments) {
  if (arguments.playmaker.empty()) return kDone;
  auto endpoint = orchestration::match::parse_endpoint(arguments.playmaker);
  using Kind = orchestration::match::Endpoint::Kind;
  if (!endpoint || (endpoint->kind != Kind::kAddress && endpoint->kind != Kind::kUnixSocket)) {
    fmt::print(stderr, "cls: --playmaker '{}': must be HOST:PORT, tls:HOST:PORT or unix:PATH\n",
               arguments.playmaker);
    return kUsage;
  }
  if (const int code = read_tls_files(*endpoint, arguments.tls); code != kDone) return code;
  arguments.options.playmaker = target_of(*endpoint);
  return kDone;
}

// Coach and trainer.
void complete_sideline(Arguments& arguments, std::vector<std::string>& mistakes) {
  LoneTeamOptions& options = arguments.options;
  if (arguments.unum == kCoach) {
    arguments.coach_alone = true;
    arguments.unum = 0;
  }
  if (arguments.coach_alone && (arguments.without_coach || arguments.unum != 0)) {
    mistakes.push_back("--coach is the coach alone: no --without-coach, no --unum");
  }
  if (arguments.coach_alone && arguments.trainer) {
    mistakes.push_back("--trainer takes the place of the coach: no --coach");
  }
  // Single players, and those who come back, have their coach already.
  const bool whole = arguments.unum == 0 && !options.team.reconnect;
  const bool coach =
      arguments.coach_alone || (whole && !arguments.without_coach && !arguments.trainer);
  if (coach) {
    options.coach_port = arguments.coach_port != 0 ? arguments.coach_port : options.server_port + 2;
  }
  if (arguments.trainer) {
    options.trainer_port =
        arguments.trainer_port != 0 ? arguments.trainer_port : options.server_port + 1;
  }
}

std::vector<std::string> complete(Arguments& arguments) {
  std::vector<std::string> mistakes;
  LoneTeamOptions& options = arguments.options;
  const auto name = orchestration::match::check_team_name(arguments.team_name);
  if (name) {
    options.team.name = soccer::TeamName(*name);
  } else {
    mistakes.push_back(name.error().message);
  }
  if (arguments.rpc_type != "grpc") {
    mistakes.push_back(fmt::format("--rpc-type '{}': only grpc is spoken", arguments.rpc_type));
  }
  complete_sideline(arguments, mistakes);
  if (!arguments.formation.empty()) {
    if (auto set = proxy::read_formations(arguments.formation)) {
      options.team.formations = std::move(*set);
    } else {
      mistakes.push_back("--formation: " + set.error().message);
    }
  }
  if (!options.team.debug_log.empty() && !std::filesystem::is_directory(options.team.debug_log)) {
    mistakes.push_back(fmt::format("--debug-log '{}': no such folder", options.team.debug_log));
  }
  options.team.one_playmaker = !options.playmaker.port_step;
  const int highest = options.playmaker.port + (options.playmaker.port_step ? kHighestStep : 0) +
                      (options.add_20_for_right ? kRightPortOffset : 0);
  if (highest > 65535) mistakes.push_back("--rpc-port: the steps lead beyond port 65535");
  options.team.players = arguments.coach_alone ? 0 : arguments.unum != 0 ? 1 : arguments.number;
  options.team.first_unum = arguments.unum != 0 ? arguments.unum : 1;
  options.team.goalie = options.team.first_unum == 1;
  options.team.decision_timeout = std::chrono::seconds(arguments.timeout_s);
  if (arguments.deadline_ms) {
    options.team.decision_timeout =
        std::min(options.team.decision_timeout, proxy::RpcTimeout(*arguments.deadline_ms));
  }
  options.team.on_late = *proxy::on_late_from_name(arguments.on_late);
  options.team.start_timeout = std::chrono::duration_cast<proxy::RpcTimeout>(
      std::chrono::duration<double>(options.start_timeout_s));
  return mistakes;
}

int exit_code_of(const LoneTeamResult& result) {
  switch (result.end_reason) {
    case EndReason::kFinished:
      return kDone;
    case EndReason::kRefused:
      return kUnavailable;
    case EndReason::kInterrupted:
      return result.signal == SIGTERM ? kTerminated : kInterrupted;
    default:
      return kAnswerIsNo;
  }
}

// For scripts that wait for it.
void tell_ready(const proxy::Team& team) {
  std::string who;
  if (!team.players().empty()) {
    who = fmt::format("players {} to {}", team.players().front()->unum(),
                      team.players().back()->unum());
  }
  if (team.coach() != nullptr) {
    who += fmt::format("{}{}", who.empty() ? "" : " and the ", team.coach()->word());
  }
  fmt::print("{} plays on the {} in {}, {}\n", team.name(), side_name(team.side()),
             team.synchronous() ? "synchronous mode" : "real time", who);
  std::fflush(stdout);
}

// Of the slowest player, as each of them can lose a match.
orchestration::match::RpcLatency worst_latency(const LoneTeamResult& result) {
  orchestration::match::RpcLatency worst;
  for (const orchestration::match::PlayerResult& player : result.players) {
    worst.p50 = std::max(worst.p50, player.rpc_us.p50);
    worst.p95 = std::max(worst.p95, player.rpc_us.p95);
    worst.p99 = std::max(worst.p99, player.rpc_us.p99);
    worst.max = std::max(worst.max, player.rpc_us.max);
  }
  return worst;
}

void tell_result(const Arguments& arguments, const LoneTeamResult& result) {
  using orchestration::match::PlayerResult;
  const auto total = [&](std::int64_t PlayerResult::*count) {
    std::int64_t sum = 0;
    for (const PlayerResult& player : result.players) sum += player.*count;
    return sum;
  };
  if (total(&PlayerResult::decisions) == 0) return;
  fmt::print(
      "{} on the {}: {} to {} at cycle {}; {} decisions, {} without an answer, {} cycles "
      "missed, {} commands too late, {} late wake-ups of ours\n",
      arguments.team_name, result.right_side ? "right" : "left", result.our_score,
      result.their_score, result.cycles, total(&PlayerResult::decisions),
      total(&PlayerResult::missed), total(&PlayerResult::undecided),
      total(&PlayerResult::lost_commands), total(&PlayerResult::late_wakeups));
  const orchestration::match::RpcLatency worst = worst_latency(result);
  fmt::print(
      "answers of the slowest player: p50 {:.0f} p95 {:.0f} p99 {:.0f} max {:.0f} us; {} "
      "late, {} reconnects\n",
      worst.p50, worst.p95, worst.p99, worst.max, total(&PlayerResult::late),
      total(&PlayerResult::reconnects));
}

int run_proxy(Arguments& arguments) {
  if (const int code = read_playmaker(arguments); code != kDone) return code;
  const std::vector<std::string> mistakes = complete(arguments);
  for (const std::string& mistake : mistakes) fmt::print(stderr, "cls: {}\n", mistake);
  if (!mistakes.empty()) return kUsage;

  arguments.options.on_ready = tell_ready;
  ProgressLine progress(stderr_is_terminal() && !arguments.quiet, arguments.quiet);
  const LoneTeamResult result = run_lone_team(arguments.options, progress, watch_interrupts());
  progress.clear();
  if (!result.message.empty()) fmt::print(stderr, "cls: {}\n", result.message);
  tell_result(arguments, result);
  if (!arguments.result_file.empty()) {
    const auto written =
        base::write_file(arguments.result_file, to_json(arguments.options, result));
    if (!written) {
      fmt::print(stderr, "cls: {}\n", written.error().message);
      return kCannotCreate;
    }
  }
  return exit_code_of(result);
}

}  // namespace

void add_proxy_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("proxy", kDescription);
  add_options(*command, *arguments);
  add_script_options(*command);
  command->callback([arguments, command, &exit_code] {
    for (const std::string& option : given_script_options(*command)) {
      if (!arguments->quiet) fmt::print(stderr, "cls: warning: {} does nothing here\n", option);
    }
    exit_code = run_proxy(*arguments);
  });
}

}  // namespace cls::cli
