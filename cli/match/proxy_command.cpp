// `cls proxy`: one team for a running soccer server; accepts the options of upstream's start.sh.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/io/whole_file.h"
#include "base/system/socket_address.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "cli/match/start_script_options.h"
#include "cli/support/interrupt.h"
#include "cli/support/match_option.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/support/tls_options.h"
#include "cli/support/troubleshooting.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/progress_line.h"
#include "cli/terminal/terminal.h"
#include "match/sides/playmaker_process.h"
#include "match/standalone_team.h"
#include "match/terms/endpoint.h"
#include "match/terms/host_name.h"
#include "player/formation/formation_set.h"
#include "soccer/side.h"

namespace cls::cli {
namespace {

using match::EndReason;
using match::StandaloneTeamOptions;
using match::StandaloneTeamResult;

constexpr const char* kProxyDescription =
    "run a team of players and their coach on a running soccer server\n"
    "\n"
    "  cls proxy --teamname Blue --rpc-port 50051              11 players and coach\n"
    "  cls proxy --teamname Blue --rpc-port 50051 --unum 5     one player\n"
    "  cls proxy --teamname Blue --rpc-port 50051 --reconnect  after a crash\n"
    "\n"
    "  cls proxy --teamname Blue --rpc-port 50051 --coach        the coach only\n"
    "  cls proxy --teamname Gym --rpc-port 50051 -n 1 --trainer  with a trainer\n"
    "\n"
    "Accepts the options of start.sh of the Cross Language Soccer framework's proxy.";

constexpr const char* kGrpc = "grpc";
constexpr const char* kThrift = "thrift";
constexpr int kCoach = 12;
constexpr int kMaxPort = 65535;
constexpr int kMaxPortStep = 13;
constexpr int kRightPortOffset = 20;

struct ProxyArguments {
  StandaloneTeamOptions options;
  std::string team_name = "SSP";
  int number = soccer::kPlayersPerTeam;
  int unum = 0;
  int timeout_s = 3;
  std::optional<int> deadline_ms;
  std::string on_late = "hold";
  std::string batch = "auto";
  std::string playmaker;
  match::TlsFileNames tls;
  std::string result_file;
  std::string rpc_type = kGrpc;
  bool quiet = false;
  bool json = false;
  std::string formation;
  int coach_port = 0;    // 0: player port + 2
  int trainer_port = 0;  // 0: player port + 1
  bool without_coach = false;
  bool coach_only = false;
  bool trainer = false;
  std::string debug_server;
  std::string debug_server_log;
  std::string debug_log;
  StartScriptValues start_script;
};

void add_playmaker_options(Command& command, ProxyArguments& arguments) {
  StandaloneTeamOptions& options = arguments.options;
  command
      .option("--playmaker SIDE", arguments.playmaker,
              "HOST:PORT, HOST:PORT+step, tls:HOST:PORT or unix:PATH; replaces the next "
              "three options")
      .of_group(kPlaymakersGroup);

  command.setting("--rpc-host HOST", options.playmaker.host, "host of the Playmaker")
      .of_group(kPlaymakersGroup);
  command.setting("--rpc-port", options.playmaker.port, "port of the Playmaker")
      .of_group(kPlaymakersGroup)
      .range(1, kMaxPort);

  command.flag("--rpc-port-step", options.playmaker.port_step, "player n connects to port + n")
      .of_group(kPlaymakersGroup);
  command
      .flag("--rpc-add-20-to-port-for-right", options.add_20_for_right,
            "add 20 to the port for a team on the right")
      .of_group(kPlaymakersGroup);

  command
      .setting("--rpc-timeout", arguments.timeout_s,
               "deadline of an RPC in seconds; in real time at most one cycle")
      .of_group(kPlaymakersGroup)
      .range(1, 3600);

  command.option("--rpc-deadline", arguments.deadline_ms, "deadline of an RPC in ms, if shorter")
      .of_group(kPlaymakersGroup)
      .above(0);

  add_match_option(command, "on_late", arguments.on_late);
  add_match_option(command, "batch", arguments.batch);
  add_tls_options(command, arguments.tls);
  command
      .option("--result FILE", arguments.result_file,
              "write the result as JSON, per player, to FILE")
      .of_group(kOutputGroup);
  command.setting("--rpc-type TYPE", arguments.rpc_type, "RPC framework of the Playmaker")
      .of_group(kPlaymakersGroup)
      .one_of({kGrpc, kThrift});
}

// The coach, the trainer, the formation, and what shows the decisions.
void add_team_options(Command& command, ProxyArguments& arguments) {
  command
      .option("-P,--coach-port", arguments.coach_port,
              "coach port of the soccer server (default: --port + 2)")
      .range(1, kMaxPort);

  command.flag("-C,--without-coach", arguments.without_coach, "connect only the players")
      .of_group(kTeamsGroup);
  command.flag("--coach", arguments.coach_only, "connect only the coach").of_group(kTeamsGroup);
  command.flag("--trainer", arguments.trainer, "connect a trainer instead of the coach")
      .of_group(kTeamsGroup);
  command
      .option("--trainer-port", arguments.trainer_port,
              "trainer port of the soccer server (default: --port + 1)")
      .range(1, kMaxPort);

  command
      .option("-f,--formation DIR", arguments.formation,
              "folder with formations, see docs/formations.md (default: built-in)")
      .of_group(kTeamsGroup);
  add_match_option(command, "debug_server", arguments.debug_server);
  add_match_option(command, "debug_server_log", arguments.debug_server_log);
  add_match_option(command, "debug_log", arguments.debug_log);
}

void add_options(Command& command, ProxyArguments& arguments) {
  StandaloneTeamOptions& options = arguments.options;
  command.options.front().names = "--help";  // -h is the host
  options.playmaker.host = "localhost";
  options.playmaker.port = 50051;

  command.option("-h,--host HOST", options.server_host,
                 "host of the soccer server (default: localhost)");
  command.setting("-p,--port", options.server_port, "player port of the soccer server")
      .range(1, kMaxPort);

  command.setting("-t,--teamname,--team_name NAME", arguments.team_name, "name of the team")
      .of_group(kTeamsGroup);
  command.setting("-n,--number", arguments.number, "number of players, goalie first")
      .of_group(kTeamsGroup)
      .range(1, soccer::kPlayersPerTeam);

  command
      .option("-u,--unum", arguments.unum,
              "only this uniform number; 1 is the goalie, 12 the coach")
      .of_group(kTeamsGroup)
      .range(1, kCoach);
  command
      .setting("-v,--version", options.team.protocol,
               "protocol version, 14 to 19; 19 becomes 18 on older servers")
      .range(soccer::kMinProtocolVersion, soccer::kMaxProtocolVersion);
  command.flag("-r,--reconnect", options.team.reconnect,
               "reconnect as players that lost their connection");

  add_playmaker_options(command, arguments);
  command
      .setting("--start-timeout", options.start_timeout_s,
               "seconds until the first response of server and Playmaker")
      .of_group(kLimitsGroup)
      .above(0);

  command.flag("--quiet", arguments.quiet, "print no progress and no warnings")
      .of_group(kOutputGroup);
  command
      .flag("--json", arguments.json,
            "print side and players as one line of JSON; all else goes to stderr")
      .of_group(kOutputGroup);
  add_team_options(command, arguments);
}

// Reads --playmaker; returns the exit code.
int resolve_playmaker(ProxyArguments& arguments) {
  if (arguments.playmaker.empty()) return kOk;
  auto endpoint = match::parse_endpoint(arguments.playmaker);
  using Kind = match::Endpoint::Kind;
  if (!endpoint || (endpoint->kind != Kind::kAddress && endpoint->kind != Kind::kUnixSocket)) {
    return print_error(kUsage,
                       "--playmaker '{}': must be HOST:PORT, tls:HOST:PORT or unix:PATH; "
                       "planner:FILE= may precede it",
                       arguments.playmaker);
  }

  TRY_STEP(read_tls_files(*endpoint, arguments.tls));
  TRY_STEP(read_side_files(*endpoint));

  arguments.options.playmaker = target_of(*endpoint);
  arguments.options.team.planner = endpoint->planner;
  return kOk;
}

// Ports of coach and trainer.
void resolve_coach_ports(ProxyArguments& arguments, std::vector<std::string>& errors) {
  StandaloneTeamOptions& options = arguments.options;
  if (arguments.unum == kCoach) {
    arguments.coach_only = true;
    arguments.unum = 0;
  }
  if (arguments.coach_only && (arguments.without_coach || arguments.unum != 0)) {
    errors.push_back("--coach excludes --without-coach and --unum");
  }
  if (arguments.coach_only && arguments.trainer) {
    errors.push_back("--trainer excludes --coach");
  }

  // For a single player or a reconnect, the coach is connected already.
  const bool whole_team = arguments.unum == 0 && !options.team.reconnect;
  const bool coach =
      arguments.coach_only || (whole_team && !arguments.without_coach && !arguments.trainer);
  if (coach) {
    options.coach_port = arguments.coach_port != 0 ? arguments.coach_port : options.server_port + 2;
  }

  if (arguments.trainer) {
    options.trainer_port =
        arguments.trainer_port != 0 ? arguments.trainer_port : options.server_port + 1;
  }
}

void check_hosts(StandaloneTeamOptions& options, std::vector<std::string>& errors) {
  using match::host_problem;
  const std::string playmaker = options.playmaker.host;
  const std::string problem = playmaker.empty() ? "" : host_problem(playmaker);
  if (!problem.empty()) errors.push_back(fmt::format("--rpc-host '{}': {}", playmaker, problem));
  options.server_host = base::strip_brackets(options.server_host);
  if (base::parse_ip_address(options.server_host, options.server_port)) return;

  const std::string server = host_problem(options.server_host);
  if (!server.empty())
    errors.push_back(fmt::format("--host '{}': {}", options.server_host, server));
}

// The options of logs that cls match has, too.
void read_debug_options(const ProxyArguments& arguments, proxy::DebugOptions& debug,
                        std::vector<std::string>& errors) {
  match::MatchOptions match;
  match::OptionTexts texts;
  for (const auto& [key, text] : {std::pair("debug_server", arguments.debug_server),
                                  std::pair("debug_server_log", arguments.debug_server_log),
                                  std::pair("debug_log", arguments.debug_log)}) {
    if (!text.empty()) texts.emplace(key, text);
  }
  for (std::string& line : set_options(match, texts)) errors.push_back(std::move(line));
  debug = match.debug;
}

std::vector<std::string> resolve(ProxyArguments& arguments, const Command& command) {
  std::vector<std::string> errors;
  read_debug_options(arguments, arguments.options.debug, errors);
  StandaloneTeamOptions& options = arguments.options;
  const auto name = match::check_team_name(arguments.team_name);
  if (name) {
    options.team.name = soccer::TeamName(*name);
  } else {
    errors.push_back(name.error().message);
  }

  options.thrift = arguments.rpc_type == kThrift;
  if (options.thrift &&
      (options.playmaker.tls != nullptr || !options.playmaker.unix_path.empty())) {
    errors.push_back("--rpc-type thrift: only over TCP, with --rpc-host and --rpc-port");
  }
  if (options.thrift && arguments.batch == "always") {
    errors.push_back("--batch always: Thrift has no call for a team");
  }
  check_hosts(options, errors);
  resolve_coach_ports(arguments, errors);

  if (!arguments.formation.empty()) {
    if (auto set = player::read_formations(arguments.formation)) {
      options.team.formations = std::move(*set);
    } else {
      errors.push_back("--formation: " + set.error().message);
    }
  }

  options.team.shared_playmaker = !options.playmaker.port_step;
  const int highest = options.playmaker.port + (options.playmaker.port_step ? kMaxPortStep : 0) +
                      (options.add_20_for_right ? kRightPortOffset : 0);
  if (highest > 65535) errors.push_back("--rpc-port: port plus step exceeds 65535");

  options.team.players = arguments.coach_only ? 0 : arguments.unum != 0 ? 1 : arguments.number;
  options.team.first_unum = arguments.unum != 0 ? arguments.unum : 1;
  options.team.goalie = options.team.first_unum == 1;

  options.team.decision_timeout = std::chrono::seconds(arguments.timeout_s);
  if (arguments.deadline_ms) {
    options.team.decision_timeout =
        std::min(options.team.decision_timeout, proxy::RpcTimeout(*arguments.deadline_ms));
  }

  options.team.on_late = *proxy::parse_on_late(arguments.on_late);
  options.batch = *proxy::parse_batch_mode(arguments.batch);
  if (options.playmaker.port_step && options.batch == proxy::BatchMode::kRequired) {
    errors.push_back("--batch always: a Playmaker with a port per player gets single calls");
  }
  options.team.start_timeout = std::chrono::duration_cast<proxy::RpcTimeout>(
      std::chrono::duration<double>(options.start_timeout_s));
  for (std::string& line : apply_start_script_options(command, arguments.start_script, options)) {
    errors.push_back(std::move(line));
  }
  if (options.team.graphic != nullptr && options.coach_port == 0) {
    errors.push_back("--team-graphic: the coach shows it, and this command connects none");
  }
  return errors;
}

int exit_code_of(const StandaloneTeamResult& result) {
  if (result.end_reason == EndReason::kInterrupted) return signal_exit_code(result.signal);
  return row_of(result.end_reason).exit_code;
}

// Start scripts wait for this line.
void print_ready(const proxy::Team& team) {
  std::string who;
  if (!team.players().empty()) {
    who = fmt::format("players {} to {}", team.players().front()->unum(),
                      team.players().back()->unum());
  }
  if (team.coach() != nullptr) {
    who += fmt::format("{}{}", who.empty() ? "" : " and the ", team.coach()->role_name());
  }

  fmt::print("{} plays on the {} in {}, {}\n", team.name(), side_name(team.side()),
             team.synchronous() ? "synchronous mode" : "real time", who);
  std::fflush(stdout);
}

std::string json_line(const proxy::Team& team) {
  std::vector<int> unums;
  for (const auto& player : team.players()) unums.push_back(player->unum());

  const base::Json line = {{"schema", "cls.proxy-ready/1"},
                           {"team", std::string(team.name())},
                           {"side", side_name(team.side())},
                           {"synchronous", team.synchronous()},
                           {"players", unums},
                           {"coach", team.coach() != nullptr}};
  return base::json_line(line);
}

// Maximum of each percentile over the players.
match::RpcLatency worst_latency(const StandaloneTeamResult& result) {
  match::RpcLatency worst;
  for (const match::PlayerResult& player : result.players) {
    worst.p50 = std::max(worst.p50, player.rpc_us.p50);
    worst.p95 = std::max(worst.p95, player.rpc_us.p95);
    worst.p99 = std::max(worst.p99, player.rpc_us.p99);
    worst.max = std::max(worst.max, player.rpc_us.max);
  }
  return worst;
}

void print_result(const ProxyArguments& arguments, const StandaloneTeamResult& result) {
  using match::PlayerResult;
  const auto total = [&](std::int64_t PlayerResult::*count) {
    std::int64_t sum = 0;
    for (const PlayerResult& player : result.players) sum += player.*count;
    return sum;
  };
  if (total(&PlayerResult::decisions) == 0) return;

  fmt::print(
      "{} on the {}: {} to {} at cycle {}; {} decisions, {} missed, {} undecided cycles, "
      "{} late commands, {} late wake-ups\n",
      arguments.team_name, result.right_side ? "right" : "left", result.our_score,
      result.their_score, result.cycles, total(&PlayerResult::decisions),
      total(&PlayerResult::missed), total(&PlayerResult::undecided),
      total(&PlayerResult::lost_commands), total(&PlayerResult::late_wakeups));

  const match::RpcLatency worst = worst_latency(result);
  fmt::print(
      "rpc latency of the slowest player: p50 {:.0f} p95 {:.0f} p99 {:.0f} max {:.0f} us; {} "
      "late, {} reconnects\n",
      worst.p50, worst.p95, worst.p99, worst.max, total(&PlayerResult::late),
      total(&PlayerResult::reconnects));
}

int run_proxy(const Command& command, ProxyArguments& arguments) {
  for (const std::string& line : start_script_warnings(command)) {
    if (!arguments.quiet) fmt::print(stderr, "cls: warning: {}\n", line);
  }

  TRY_STEP(resolve_playmaker(arguments));
  const std::vector<std::string> errors = resolve(arguments, command);
  if (!errors.empty()) return print_errors(kUsage, errors);

  const JsonStdout json(arguments.json);
  arguments.options.on_ready = [&json](const proxy::Team& team) {
    if (json.active()) json.print_line(json_line(team));
    print_ready(team);
  };

  ProgressLine progress(stderr_is_terminal() && !arguments.quiet, arguments.quiet);
  const StandaloneTeamResult result =
      run_standalone_team(arguments.options, progress, watch_interrupts());
  progress.clear();
  if (!result.message.empty()) {
    print_error(0, result.message);
    fmt::print(stderr, "  {}\n", troubleshooting_hint(result.end_reason));
  }

  print_result(arguments, result);
  if (!result.write_error.empty()) print_error(0, result.write_error);
  if (!arguments.result_file.empty()) {
    TRY_OR(kCannotCreate,
           base::write_file(arguments.result_file, to_json(arguments.options, result)));
  }
  const int code = exit_code_of(result);
  return code == kOk && !result.write_error.empty() ? kCannotCreate : code;
}

}  // namespace

void add_proxy_command(Command& app) {
  auto [command, arguments] = app.command("proxy", kProxyDescription, run_proxy);
  command.group = kPartCommands;
  add_options(command, arguments);
  add_start_script_options(command, arguments.start_script);
}

}  // namespace cls::cli
