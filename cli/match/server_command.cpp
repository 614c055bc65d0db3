// `cls server`: serves one match over UDP, until time over or a signal.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <future>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/system/socket_address.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "cli/command/help.h"
#include "cli/command/usage_errors.h"
#include "cli/match/server_lines.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "gamelog/rcg/rcg_writer.h"
#include "match/server/client_binding.h"
#include "match/server/server_logs.h"
#include "match/server/server_output.h"
#include "match/server/server_report.h"
#include "match/server/server_teams.h"
#include "match/terms/server_settings.h"
#include "process/ports.h"
#include "process/socket_visibility.h"
#include "simulator/server/udp_server.h"
#include "simulator/sessions/match_recorder.h"

namespace cls::cli {
namespace {

using match::ServerSettings;
using simulator::UdpServer;
using simulator::UdpServerExit;

constexpr const char* kServerDescription =
    "run the embedded soccer server for UDP clients\n"
    "\n"
    "  cls server                     at port 6000, with rcssserver's defaults: real\n"
    "                                 time, a monitor starts the match\n"
    "  cls server server::auto_mode=on server::synch_mode=on server::half_time=100\n"
    "  cls server --port 0 --seed 7             at a free port, which is printed\n"
    "\n"
    "Accepts the settings of rcssserver: server::NAME=VALUE, player::NAME=VALUE,\n"
    "CSVSaver::NAME=VALUE, include=FILE, with or without leading dashes; and\n"
    "sync::max_wait_ms, sync::max_missed. server.conf, player.conf and CSVSaver.conf\n"
    "are read first, from RCSS_CONF_DIR or ~/.rcssserver.";

struct ServerArguments {
  std::string host = "127.0.0.1";
  std::optional<int> port;
  std::optional<std::uint64_t> seed;
  std::optional<int> cycles;
  std::string folder;
  bool json = false;
};

/// Reads configuration files, then arguments; later settings override earlier ones.
base::Result<ServerSettings> read_settings(const ServerArguments& arguments,
                                           const std::vector<std::string>& texts, int& exit_code) {
  ServerSettings settings;
  exit_code = kBadConfig;
  TRY_INIT(const auto files, apply_folder(settings, match::configuration_folder()));
  for (const auto& file : files) fmt::print("configuration: {}\n", file.string());

  exit_code = kUsage;
  TRY(apply_arguments(settings, texts));

  if (arguments.folder.empty()) return settings;
  // --dir: fixed names in that folder.
  soccer::ServerParams& server = settings.server;
  server.game_log_dir = server.text_log_dir = server.keepaway_log_dir = arguments.folder;
  server.game_log_fixed = server.text_log_fixed = server.keepaway_log_fixed = true;
  server.game_log_fixed_name = server.text_log_fixed_name = "match";
  server.keepaway_log_fixed_name = "match";
  return settings;
}

/// Serves on a separate thread, so that a signal is noticed within the poll interval.
UdpServerExit serve(UdpServer& server, const std::atomic<int>& signal) {
  constexpr std::chrono::milliseconds kPollInterval{100};
  std::atomic<bool> stop{false};
  std::promise<UdpServerExit> result;
  std::future<UdpServerExit> end = result.get_future();
  std::thread thread([&] { result.set_value(server.run(stop)); });
  while (end.wait_for(kPollInterval) != std::future_status::ready && signal.load() == 0) {
  }

  stop = true;
  thread.join();
  return end.get();
}

match::ReportedTeam reported(const UdpServer& server, soccer::Side side) {
  const simulator::Team& team = server.world().team(side);
  match::ReportedTeam report;
  report.coach = server.coach_name(side);
  report.name = team.name.view();
  report.score = team.score;
  report.penalties_taken = team.penalty_kicks;
  report.penalties_scored = team.penalty_goals;
  return report;
}

match::ServerReport report_of(const UdpServer& server, std::time_t start) {
  match::ServerReport report;
  report.start = start;
  report.left = reported(server, soccer::Side::kLeft);
  report.right = reported(server, soccer::Side::kRight);
  for (const auto side : {soccer::Side::kLeft, soccer::Side::kRight}) {
    if (server.world().team(side).won_coin_toss) report.coin_toss_winner = side;
  }
  return report;
}

/// Appends a row to the CSV file of results.
base::Result<void> save_csv(const std::string& file, const match::ServerReport& report) {
  std::error_code error;
  const bool is_new = !std::filesystem::exists(file, error);
  std::ofstream out(file, std::ios::app | std::ios::binary);
  if (is_new) out << match::csv_header();
  out << csv_line(report) << std::flush;
  if (!out) return base::Error{fmt::format("{}: cannot write", file)};
  return {};
}

void print_times(const UdpServer& server) {
  const simulator::World& world = server.world();
  fmt::print("{} cycles", world.clock.time);
  if (world.params().synch_mode) {
    fmt::print(", {} of them missed by a client\n", server.missed_cycles());
    return;
  }

  const auto late = server.lateness();
  fmt::print("; step lateness: mean {:.2f} ms, p99 {:.1f} ms, max {:.1f} ms\n", late.mean_ms,
             late.p99_ms, late.worst_ms);
}

/// For the match that has started this server: whose time it was.
void print_awaited(const UdpServer& server) {
  const auto seconds = [&server](soccer::Side side) {
    return std::chrono::duration<double>(server.awaited(side)).count();
  };
  fmt::print("{}{:.3f} {:.3f}\n", match::kAwaitedLine, seconds(soccer::Side::kLeft),
             seconds(soccer::Side::kRight));
}

/// Prints the result and closes the logs. Returns the first error.
base::Result<void> finish(const UdpServer& server, const ServerSettings& settings,
                          match::ServerLogs& logs, std::time_t start) {
  const match::ServerReport report = report_of(server, start);
  base::Result<void> saved;
  if (settings.save_csv) saved = save_csv(settings.csv_file, report);
  fmt::print("{}", console_report(report, settings.save_csv && saved));
  print_times(server);
  if (settings.bound && server.world().params().synch_mode) print_awaited(server);
  gamelog::Frame last;
  simulator::to_frame(server.world(), last);

  // In names of logs the coach name follows the team name.
  for (const auto side : {soccer::Side::kLeft, soccer::Side::kRight}) {
    const std::string& coach = server.coach_name(side);
    if (!coach.empty()) last.teams[side == soccer::Side::kRight ? 1 : 0].name += "_" + coach;
  }

  if (auto closed = logs.finish(last.teams); !closed) return closed;
  for (const auto& path : logs.paths()) fmt::print("log: {}\n", path.string());
  return saved;
}

int exit_code_of(UdpServerExit end, int signal) {
  if (end == UdpServerExit::kUnresponsiveClients) {
    fmt::print(stderr, "Waiting too long for clients! Exiting\n");
    return kFailed;
  }
  if (end == UdpServerExit::kFinished) return kOk;
  return signal_exit_code(signal);
}

// "[::1]" and "localhost" as addresses; what else is none is an error of the server.
std::string numeric_address(const std::string& host) {
  return host == "localhost" ? "127.0.0.1" : base::strip_brackets(host);
}

simulator::UdpConfig config_of(const ServerArguments& arguments, const ServerSettings& settings) {
  simulator::UdpConfig config;
  config.match.server = settings.server;
  config.match.player = settings.player;
  config.match.seed = arguments.seed.value_or(std::random_device()());
  config.match.cycle_limit = arguments.cycles;

  // Clients and logs see the requested ports, as with server::port.
  soccer::ServerParams& params = config.match.server;
  if (arguments.port) {
    params.port = *arguments.port;
    params.coach_port = *arguments.port == 0 ? 0 : *arguments.port + 1;
    params.olcoach_port = *arguments.port == 0 ? 0 : *arguments.port + 2;
  }

  config.address = numeric_address(arguments.host);
  config.port = params.port;
  config.trainer_port = params.coach_port;
  config.coach_port = params.olcoach_port;
  config.max_wait = std::chrono::milliseconds(settings.max_wait_ms);
  config.max_missed = settings.max_missed;
  return config;
}

match::ServerPorts ports_of(const UdpServer& server) {
  return {server.port(), server.port(simulator::ListeningPort::kTrainers),
          server.port(simulator::ListeningPort::kOnlineCoaches)};
}

std::string json_line(const ServerArguments& arguments, const match::ServerPorts& ports,
                      std::uint64_t seed) {
  const base::Json line = {{"schema", "cls.server/1"},  {"host", arguments.host},
                           {"port", ports.player},      {"trainer_port", ports.trainer},
                           {"coach_port", ports.coach}, {"seed", seed}};
  return base::json_line(line);
}

/// A closed terminal ends the match gracefully like Ctrl-C, except under nohup.
void watch_hang_up() {
  struct sigaction now = {};
  sigaction(SIGHUP, nullptr, &now);
  if (now.sa_handler == SIG_IGN) return;
  struct sigaction interrupt = {};
  sigaction(SIGINT, nullptr, &interrupt);
  sigaction(SIGHUP, &interrupt, nullptr);
}

/// A log of an earlier match in the folder of --dir; empty: none.
std::string earlier_log(const std::filesystem::path& folder) {
  if (folder.empty()) return {};
  for (const char* name : {"match.rcg", "match.rcl", "match.kwy"}) {
    for (const char* suffix : {"", ".gz"}) {
      std::error_code error;
      const std::filesystem::path file = folder / (std::string(name) + suffix);
      if (std::filesystem::exists(file, error)) return file.string();
    }
  }
  return {};
}

/// For the match that has started this server.
void print_intrusion(const std::string& line) {
  fmt::print("{}{}\n", match::kIntrusionLine, line);
  std::fflush(stdout);
}

/// The sides of the match that has started this server, and the networks that they have for
/// themselves.
struct ServedSides {
  std::optional<match::ClientBinding> binding;       ///< in the network of the server
  std::optional<match::ClientBinding> side_binding;  ///< in those of sides
  soccer::PerSide<std::optional<process::NetworkDoor>> doors;
};

/// The ports in the networks of sides. `sides` must outlive them.
std::vector<simulator::OtherPorts> other_ports(const ServerSettings& settings, ServedSides& sides) {
  std::vector<simulator::OtherPorts> others;
  if (!settings.bound) return others;
  sides.side_binding.emplace(*settings.bound, std::nullopt);
  for (const soccer::Side side : soccer::kBothSides) {
    const int door = settings.bound->doors[side];
    if (door == 0) continue;
    sides.doors[side].emplace(base::UniqueFd(door));
    const match::ServerPorts ports;
    others.push_back(
        {match::network_of(side, *sides.side_binding, *sides.doors[side], print_intrusion),
         ports.player, ports.coach});
  }
  return others;
}

/// Binds clients to the sides of the match that has started this server, and reports others. False
/// if none has started it.
bool bind_clients(UdpServer& server, const ServerSettings& settings,
                  std::optional<match::ClientBinding>& binding) {
  if (!settings.bound) return true;
  const soccer::ServerParams& params = settings.server;
  const bool has_trainer = params.coach || params.coach_w_referee;
  if (!has_trainer || settings.bound->trainer) server.make_monitors_read_only();
  if (const auto missing = process::missing_socket_owners(); !missing.empty()) {
    print_intrusion(missing);
    return true;
  }

  auto owners = process::SocketOwners::of_programs_beside();
  if (!owners) return false;
  binding.emplace(*settings.bound, *std::move(owners));
  server.bind_clients(
      [&binding](const base::SocketAddress& sender) { return binding->rights_of(sender); },
      [&binding](const base::SocketAddress& sender, std::string_view request) {
        const auto line = binding->intrusion_line(sender, request);
        if (line) print_intrusion(*line);
      });

  return true;
}

/// Opens sockets and logs, serves the match, closes the logs.
int serve_match(const ServerArguments& arguments, const ServerSettings& settings,
                const JsonStdout& json) {
  ServedSides sides;
  simulator::UdpConfig config = config_of(arguments, settings);
  config.others = other_ports(settings, sides);
  const std::atomic<int>& signal = watch_interrupts();
  watch_hang_up();
  const std::time_t start = std::time(nullptr);

  auto server = UdpServer::open(config);
  if (!server) {
    const std::string taken = process::taken_port(
        process::Protocol::kUdp, {config.port, config.trainer_port, config.coach_port});
    return print_error(kTryAgain, taken.empty() ? server.error().message
                                                : taken + "; --port 0 selects free ports");
  }
  if (!bind_clients(**server, settings, sides.binding)) {
    return print_error(kUsage, "match::sides: no match has started this server; omit it");
  }
  if (const std::string log = earlier_log(arguments.folder); !log.empty()) {
    return print_error(kCannotCreate, "{}: exists; give --dir another folder", log);
  }

  TRY_INIT_OR(kCannotCreate, auto logs,
              match::ServerLogs::open(settings.server, start, settings.bound.has_value()));
  (*server)->record(logs.sinks());
  std::optional<simulator::KeepawayRecorder> keepaway;
  if (logs.keepaway() != nullptr) keepaway.emplace(*logs.keepaway());

  const match::ServerPorts ports = ports_of(**server);
  TRY_INIT_OR(kInternalError, auto teams, match::ServerTeams::create(settings.server, ports));

  ServerLines lines(**server);
  (*server)->on_step([&](const simulator::World& world) {
    lines.step(world);
    if (keepaway) keepaway->step(world);
    teams.poll(world.mode == soccer::PlayMode::kPlayOn,
               !world.team(soccer::Side::kLeft).name.empty());
  });
  (*server)->on_event([&lines](const simulator::UdpServerEvent& event) { lines.event(event); });

  if (json.active()) json.print_line(json_line(arguments, ports, config.match.seed));
  fmt::print(
      "listening on {}:{}, trainer {}, coaches {}\nSimulator Random Seed: {}\nHit CTRL-C to exit\n",
      arguments.host, ports.player, ports.trainer, ports.coach, config.match.seed);
  std::fflush(stdout);

  const UdpServerExit end = serve(**server, signal);
  teams.terminate();
  if (end == UdpServerExit::kFinished) {
    (*server)->announce_end();
    fmt::print("\nGame Over. Exiting...\n");
  }
  if (end == UdpServerExit::kStopped) fmt::print("\nServer Killed. Exiting...\n");

  TRY_OR(kWriteFailed, finish(**server, settings, logs, start));
  return exit_code_of(end, signal.load());
}

/// A mistyped cls option. It cannot be a setting of rcssserver: those contain '::' or '='.
std::optional<std::string> mistyped_option(const std::vector<std::string>& texts) {
  const auto is_option = [](const std::string& text) {
    return text.starts_with('-') && text.find("::") == std::string::npos &&
           text.find('=') == std::string::npos && !text.ends_with("help");
  };

  for (std::size_t i = 0; i < texts.size(); ++i) {
    const bool is_value = i > 0 && texts[i - 1].ends_with('=');
    const bool has_value = i + 1 < texts.size() && texts[i + 1].starts_with('=');
    if (is_option(texts[i]) && !is_value && !has_value) return texts[i];
  }
  return std::nullopt;
}

int run_server(const Command& command, const ServerArguments& arguments) {
  int problem = kUsage;
  if (const auto option = mistyped_option(command.words)) {
    return print_error(kUsage, unknown_option(command, *option));
  }

  const JsonStdout json(arguments.json);
  TRY_INIT_OR(problem, const auto settings, read_settings(arguments, command.words, problem));
  if (settings.help) {
    fmt::print("{}", help_text(command));
    return kOk;
  }

  const soccer::ServerParams& server = settings.server;
  if (server.game_logging && !gamelog::rcg_version(server.game_log_version)) {
    return print_error(kUsage, "server::game_log_version={}: must be 1 to 6, or -1 (JSON)",
                       server.game_log_version);
  }

  TRY_OR(kUsage, simulator::MatchServer::create(config_of(arguments, settings).match));
  return serve_match(arguments, settings, json);
}

}  // namespace

void add_server_command(Command& app) {
  auto [command, arguments] = app.command("server", kServerDescription, run_server);
  command.group = kPartCommands;
  command.starts_programs = true;
  command.takes_any_words = true;  // the settings, in order

  command.setting("--host HOST", arguments.host, "address to listen on");
  command
      .option(
          "--port", arguments.port,
          "player port; trainer and coach ports are the next two; 0 selects free ports (default: "
          "server::port, 6000)")
      .range(0, 65533);

  command.option("--seed", arguments.seed, "random seed of the match (default: random, printed)");
  command.option("--cycles", arguments.cycles, "end the match at this game time").above(0);
  command.option(
      "--dir DIR", arguments.folder,
      "folder for match.rcg, match.rcl and match.kwy (default: rcssserver's folders and names)");
  command
      .flag("--json", arguments.json,
            "print host and ports as one line of JSON; all else goes to stderr")
      .of_group(kOutputGroup);
}

}  // namespace cls::cli
