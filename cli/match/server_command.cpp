// `cls server`: serves one match over UDP until it is over or a signal comes.
#include "cli/match/server_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/match/server_lines.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "gamelog/rcg/rcg_writer.h"
#include "orchestration/match/options/server_settings.h"
#include "orchestration/match/server/server_logs.h"
#include "orchestration/match/server/server_report.h"
#include "orchestration/match/server/server_teams.h"
#include "simulator/server/udp_server.h"
#include "simulator/sessions/keepaway_recorder.h"

namespace cls::cli {
namespace {

using orchestration::match::ServerSettings;
using simulator::UdpEnd;
using simulator::UdpServer;

constexpr const char* kDescription =
    "Runs the embedded soccer server alone, for clients that connect over UDP.\n"
    "\n"
    "  cls server                               at port 6000, with rcssserver's defaults: real\n"
    "                                           time, a monitor kicks off\n"
    "  cls server server::auto_mode=on server::synch_mode=on server::half_time=100\n"
    "  cls server --port 0 --seed 7             at a free port, which is printed\n"
    "\n"
    "A SETTING is a word of rcssserver's: server::NAME=VALUE, player::NAME=VALUE,\n"
    "CSVSaver::NAME=VALUE, include=FILE, with or without dashes before it; and sync::max_wait_ms,\n"
    "sync::max_missed. server.conf, player.conf and CSVSaver.conf are read first, from "
    "RCSS_CONF_DIR or\n"
    "~/.rcssserver.";

struct Arguments {
  std::string host = "127.0.0.1";
  std::optional<int> port;
  std::optional<std::uint64_t> seed;
  std::optional<int> cycles;
  std::string folder;
};

/// All that was asked for, in the order in which later words win.
base::Result<ServerSettings> read_settings(const Arguments& arguments,
                                           const std::vector<std::string>& words, int& exit_code) {
  ServerSettings settings;
  exit_code = kBadConfig;
  const auto files = apply_folder(settings, orchestration::match::configuration_folder());
  if (!files) return files.error();
  for (const auto& file : *files) fmt::print("configuration: {}\n", file.string());
  exit_code = kUsage;
  const auto applied = apply_arguments(settings, words);
  if (!applied) return applied.error();
  if (arguments.folder.empty()) return settings;
  // A folder of its own needs no other names.
  soccer::ServerParams& server = settings.server;
  server.game_log_dir = server.text_log_dir = server.keepaway_log_dir = arguments.folder;
  server.game_log_fixed = server.text_log_fixed = server.keepaway_log_fixed = true;
  server.game_log_fixed_name = server.text_log_fixed_name = "match";
  server.keepaway_log_fixed_name = "match";
  return settings;
}

/// Serves on a thread of its own, so that a signal is noticed soon. The match costs little: what is
/// not needed does not wake up either.
UdpEnd serve(UdpServer& server, const std::atomic<int>& signal) {
  constexpr std::chrono::milliseconds kLook{100};
  std::atomic<bool> stop{false};
  std::promise<UdpEnd> result;
  std::future<UdpEnd> end = result.get_future();
  std::thread thread([&] { result.set_value(server.run(stop)); });
  while (end.wait_for(kLook) != std::future_status::ready && signal.load() == 0) {
  }
  stop = true;
  thread.join();
  return end.get();
}

orchestration::match::ReportedTeam reported(const UdpServer& server, soccer::Side side) {
  const simulator::Team& team = server.world().team(side);
  orchestration::match::ReportedTeam report;
  report.coach = server.coach_name(side);
  report.name = team.name.view();
  report.score = team.score;
  report.penalties_taken = team.penalty_kicks;
  report.penalties_scored = team.penalty_goals;
  return report;
}

orchestration::match::ServerReport report_of(const UdpServer& server, std::time_t start) {
  orchestration::match::ServerReport report;
  report.start = start;
  report.left = reported(server, soccer::Side::kLeft);
  report.right = reported(server, soccer::Side::kRight);
  for (const auto side : {soccer::Side::kLeft, soccer::Side::kRight}) {
    if (server.world().team(side).won_coin_toss) report.coin_toss_winner = side;
  }
  return report;
}

/// Adds a line to the table of results.
base::Result<void> save_csv(const std::string& file,
                            const orchestration::match::ServerReport& report) {
  std::error_code error;
  const bool is_new = !std::filesystem::exists(file, error);
  std::ofstream out(file, std::ios::app | std::ios::binary);
  if (is_new) out << orchestration::match::csv_header();
  out << csv_line(report) << std::flush;
  if (!out) return base::Error{fmt::format("cannot write {}", file)};
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
  fmt::print(
      "; steps late by {:.2f} ms on average, 99 % of them within {:.1f} ms, worst {:.1f} ms\n",
      late.mean_ms, late.p99_ms, late.worst_ms);
}

/// Prints and writes how it ended. The first problem on the way.
base::Result<void> finish(const UdpServer& server, const ServerSettings& settings,
                          orchestration::match::ServerLogs& logs, std::time_t start) {
  const orchestration::match::ServerReport report = report_of(server, start);
  base::Result<void> saved;
  if (settings.save_csv) saved = save_csv(settings.csv_file, report);
  fmt::print("{}", console_report(report, settings.save_csv && saved));
  print_times(server);
  gamelog::Frame last;
  simulator::describe(server.world(), last);
  // Names of logs have the coach's behind the team's.
  for (const auto side : {soccer::Side::kLeft, soccer::Side::kRight}) {
    const std::string& coach = server.coach_name(side);
    if (!coach.empty()) last.teams[side == soccer::Side::kRight ? 1 : 0].name += "_" + coach;
  }
  if (auto closed = logs.finish(last.teams); !closed) return closed;
  for (const auto& path : logs.paths()) fmt::print("log: {}\n", path.string());
  return saved;
}

int exit_code_of(UdpEnd end, int signal) {
  if (end == UdpEnd::kUnanswered) {
    fmt::print(stderr, "Waiting too long for clients! Exiting\n");
    return kAnswerIsNo;
  }
  if (end == UdpEnd::kFinished) return kDone;
  return signal == SIGTERM ? kTerminated : kInterrupted;
}

int report_mistakes(const std::vector<std::string>& mistakes, int exit_code = kUsage) {
  for (const std::string& mistake : mistakes) fmt::print(stderr, "cls: {}\n", mistake);
  return exit_code;
}

simulator::UdpConfig config_of(const Arguments& arguments, const ServerSettings& settings) {
  simulator::UdpConfig config;
  config.match.server = settings.server;
  config.match.player = settings.player;
  config.match.seed = arguments.seed.value_or(std::random_device()());
  config.match.cycle_limit = arguments.cycles;
  // Clients and logs are told the ports that were asked for, as by server::port.
  soccer::ServerParams& told = config.match.server;
  if (arguments.port) {
    told.port = *arguments.port;
    told.coach_port = *arguments.port == 0 ? 0 : *arguments.port + 1;
    told.olcoach_port = *arguments.port == 0 ? 0 : *arguments.port + 2;
  }
  config.address = arguments.host;
  config.port = told.port;
  config.trainer_port = told.coach_port;
  config.coach_port = told.olcoach_port;
  config.max_wait = std::chrono::milliseconds(settings.max_wait_ms);
  config.max_missed = settings.max_missed;
  return config;
}

orchestration::match::ServerPorts ports_of(const UdpServer& server) {
  return {server.port(), server.port(simulator::Door::kOfflineCoach),
          server.port(simulator::Door::kOnlineCoach)};
}

/// A closed terminal ends the match in order, as Ctrl-C does; not under nohup.
void watch_hang_up() {
  struct sigaction now = {};
  sigaction(SIGHUP, nullptr, &now);
  if (now.sa_handler == SIG_IGN) return;
  struct sigaction interrupt = {};
  sigaction(SIGINT, nullptr, &interrupt);
  sigaction(SIGHUP, &interrupt, nullptr);
}

/// Everything from open doors to closed logs.
int serve_match(const Arguments& arguments, const ServerSettings& settings) {
  const simulator::UdpConfig config = config_of(arguments, settings);
  const std::atomic<int>& signal = watch_interrupts();
  watch_hang_up();
  const std::time_t start = std::time(nullptr);
  auto server = UdpServer::open(config);
  if (!server) return report_mistakes({server.error().message}, kTryAgain);
  auto logs = orchestration::match::ServerLogs::open(settings.server, start);
  if (!logs) return report_mistakes({logs.error().message}, kCannotCreate);
  (*server)->record(logs->sinks());
  std::optional<simulator::KeepawayRecorder> keepaway;
  if (logs->keepaway() != nullptr) keepaway.emplace(*logs->keepaway());
  const orchestration::match::ServerPorts ports = ports_of(**server);
  auto teams = orchestration::match::ServerTeams::create(settings.server, ports);
  if (!teams) return report_mistakes({teams.error().message}, kInternalError);
  ServerLines lines(**server);
  (*server)->on_step([&](const simulator::World& world) {
    lines.step(world);
    if (keepaway) keepaway->step(world);
    teams->look(world.mode == soccer::PlayMode::kPlayOn,
                !world.team(soccer::Side::kLeft).name.empty());
  });
  (*server)->on_notice([&lines](const simulator::UdpNotice& notice) { lines.notice(notice); });
  fmt::print(
      "listening on {}:{}, trainer {}, coaches {}\nSimulator Random Seed: {}\nHit CTRL-C to exit\n",
      arguments.host, ports.player, ports.trainer, ports.coach, config.match.seed);
  std::fflush(stdout);

  const UdpEnd end = serve(**server, signal);
  teams->end();
  if (end == UdpEnd::kFinished) fmt::print("\nGame Over. Exiting...\n");
  if (end == UdpEnd::kStopped) fmt::print("\nServer Killed. Exiting...\n");
  const auto finished = finish(**server, settings, *logs, start);
  if (!finished) return report_mistakes({finished.error().message}, kWriteFailed);
  return exit_code_of(end, signal.load());
}

/// A mistyped option of ours, which cannot be meant for rcssserver: there dashes stand before
/// settings.
std::optional<std::string> unknown_option(const std::vector<std::string>& words) {
  const auto is_option = [](const std::string& word) {
    return word.starts_with('-') && word.find("::") == std::string::npos &&
           word.find('=') == std::string::npos && !word.ends_with("help");
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool is_value = i > 0 && words[i - 1].ends_with('=');
    const bool has_value = i + 1 < words.size() && words[i + 1].starts_with('=');
    if (is_option(words[i]) && !is_value && !has_value) return words[i];
  }
  return std::nullopt;
}

int run_server(const Arguments& arguments, const CLI::App& command) {
  int problem = kUsage;
  if (const auto option = unknown_option(command.remaining())) {
    return report_mistakes({fmt::format("unknown option '{}' (see cls server --help)", *option)});
  }
  const auto settings = read_settings(arguments, command.remaining(), problem);
  if (!settings) return report_mistakes({settings.error().message}, problem);
  if (settings->help) {
    fmt::print("{}", command.help());
    return kDone;
  }
  const soccer::ServerParams& server = settings->server;
  if (server.game_logging && !gamelog::rcg_version(server.game_log_version)) {
    return report_mistakes({fmt::format("server::game_log_version={}: must be 1 to 6, or -1 (JSON)",
                                        server.game_log_version)});
  }
  const auto made = simulator::MatchServer::create(config_of(arguments, *settings).match);
  if (!made) return report_mistakes({made.error().message});
  return serve_match(arguments, *settings);
}

}  // namespace

void add_server_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("server", kDescription);
  command->allow_extras();  // the settings, in their order
  command->add_option("--host", arguments->host, "address to listen on (127.0.0.1)");
  command
      ->add_option(
          "--port", arguments->port,
          "of players; trainer and coaches have the next two; 0: free ones (server::port, 6000)")
      ->check(CLI::Range(0, 65533));
  command->add_option("--seed", arguments->seed, "of the match (else drawn and told)");
  command->add_option("--cycles", arguments->cycles, "end when game time reaches this");
  command->add_option("--dir", arguments->folder,
                      "for match.rcg, match.rcl, match.kwy (else rcssserver's folders and names)");
  command->callback(
      [arguments, command, &exit_code] { exit_code = run_server(*arguments, *command); });
}

}  // namespace cls::cli
