// `cls server`: serves one match over UDP until it is over or a signal comes.
#include "cli/server_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "orchestration/match_folder.h"
#include "orchestration/match_options.h"
#include "simulator/server/udp_server.h"

namespace cls::cli {
namespace {

using simulator::UdpEnd;
using simulator::UdpServer;

constexpr const char* kDescription =
    "Runs the embedded soccer server alone, for clients that connect over UDP.\n"
    "\n"
    "  cls server                               at port 6000, as rcssserver\n"
    "  cls server --port 0                      at a free port, which is printed\n"
    "  cls server server::half_time=100         with rcssserver's parameters\n"
    "\n"
    "So far it serves players, in synchronous mode (server::synch_mode=on, its default) or in "
    "real\n"
    "time, and whistles by itself (server::auto_mode=on); coaches, trainers and monitors are "
    "refused.";

struct Arguments {
  std::vector<std::string> settings;
  std::string host = "127.0.0.1";
  std::optional<int> port;
  std::optional<std::uint64_t> seed;
  std::optional<int> cycles;
  std::string folder = ".";
};

/// The parameters that were asked for, beginning with those that this server always needs.
orchestration::MatchOptions base_options() {
  orchestration::MatchOptions options;
  options.server = soccer::ServerParams();
  options.server.synch_mode = true;
  options.server.auto_mode = true;
  return options;
}

// rcssserver reads its words as one text, where blanks may stand around the '='.
std::vector<std::string> whole_settings(const std::vector<std::string>& words) {
  std::vector<std::string> settings;
  for (const std::string& word : words) {
    const bool goes_on =
        word.starts_with('=') || (!settings.empty() && settings.back().ends_with('='));
    if (goes_on && !settings.empty()) {
      settings.back() += word;
    } else {
      settings.push_back(word);
    }
  }
  return settings;
}

// What was asked for and cannot be had yet.
std::vector<std::string> refusals(const soccer::ServerParams& server) {
  std::vector<std::string> lines;
  const auto refuse = [&lines](bool asked, const char* what) {
    if (asked) lines.push_back(fmt::format("{}: not in this server yet", what));
  };
  refuse(server.coach || server.coach_w_referee, "a trainer (server::coach, coach_w_referee)");
  refuse(!server.team_l_start.empty() || !server.team_r_start.empty(),
         "starting teams (server::team_l_start, team_r_start)");
  return lines;
}

/// The logs of the match, as far as the parameters want them.
struct Logs {
  std::unique_ptr<gamelog::FileSink> game;
  std::unique_ptr<gamelog::FileSink> text;

  std::string close() {
    std::string problem;
    for (gamelog::FileSink* sink : {game.get(), text.get()}) {
      if (sink == nullptr) continue;
      const auto closed = sink->close();
      if (!closed && problem.empty()) problem = closed.error().message;
    }
    return problem;
  }
};

soccer::Result<Logs> open_logs(const std::string& folder, const soccer::ServerParams& server) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return soccer::Error{fmt::format("cannot create the folder {}: {}", folder, error.message())};
  }
  Logs logs;
  const auto open = [&](bool wanted, const char* name, std::unique_ptr<gamelog::FileSink>& sink) {
    if (!wanted) return soccer::Result<void>();
    auto opened = gamelog::FileSink::create((std::filesystem::path(folder) / name).string());
    if (!opened) return soccer::Result<void>(opened.error());
    sink = std::move(*opened);
    return soccer::Result<void>();
  };
  const auto game = open(server.game_logging, orchestration::kGameLogFile, logs.game);
  if (!game) return game.error();
  const auto text = open(server.text_logging, orchestration::kTextLogFile, logs.text);
  if (!text) return text.error();
  return logs;
}

/// What rcssserver writes too, so that scripts that wait for its lines find them here.
void print_notice(const UdpServer& server, const simulator::UdpNotice& notice) {
  const simulator::World& world = server.world();
  if (notice.kind == simulator::UdpNotice::Kind::kMissedCycle) {
    fmt::print(stderr, "Someone missed a cycle at {}\n", world.clock.time);
    return;
  }
  const bool connected = notice.kind == simulator::UdpNotice::Kind::kConnected;
  if (!simulator::is_player(notice.client)) {
    const std::string line = connected
                                 ? fmt::format("A new (v{}) monitor connected.", notice.version)
                                 : "A monitor disconnected";
    fmt::print("{}\n", line);
    std::fflush(stdout);
    return;
  }
  const soccer::Side side = soccer::side_of_slot(notice.client);
  const std::string who =
      fmt::format("({} {})", world.team(side).name.view(), soccer::unum_of_slot(notice.client));
  if (connected) {
    fmt::print("A new (v{}) player {} connected.\n", notice.version, who);
  } else {
    fmt::print("A player disconnected : {}\n", who);
  }
  std::fflush(stdout);
}

/// Serves on a thread of its own, so that a signal is noticed at once.
UdpEnd serve(UdpServer& server, const std::atomic<int>& signal) {
  std::atomic<bool> stop{false};
  std::atomic<bool> ended{false};
  UdpEnd end = UdpEnd::kStopped;
  std::thread thread([&] {
    end = server.run(stop);
    ended = true;
  });
  while (!ended && signal.load() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  stop = true;
  thread.join();
  return end;
}

void print_result(const UdpServer& server) {
  const simulator::World& world = server.world();
  const simulator::Team& left = world.team(soccer::Side::kLeft);
  const simulator::Team& right = world.team(soccer::Side::kRight);
  const auto name = [](const simulator::Team& team) {
    return team.name.empty() ? std::string("nobody") : std::string(team.name.view());
  };
  fmt::print("{} {} - {} {}", name(left), left.score, right.score, name(right));
  if (left.penalty_kicks > 0 || right.penalty_kicks > 0) {
    fmt::print(" (penalties {} - {})", left.penalty_goals, right.penalty_goals);
  }
  fmt::print(", {} cycles", world.clock.time);
  if (world.params().synch_mode) {
    fmt::print(", {} of them missed by a client\n", server.missed_cycles());
    return;
  }
  const auto late = server.lateness();
  fmt::print(
      "; steps late by {:.2f} ms on average, 99 % of them within {:.1f} ms, worst {:.1f} ms\n",
      late.mean_ms, late.p99_ms, late.worst_ms);
}

int exit_code_of(UdpEnd end, int signal) {
  if (end == UdpEnd::kUnanswered) {
    fmt::print(stderr, "Waiting too long for clients! Exiting\n");
    return kAnswerIsNo;
  }
  if (end == UdpEnd::kFinished) return kDone;
  return signal == SIGTERM ? kTerminated : kInterrupted;
}

int report_mistakes(const std::vector<std::string>& mistakes) {
  for (const std::string& mistake : mistakes) fmt::print(stderr, "cls: {}\n", mistake);
  return kUsage;
}

int run_server(const Arguments& arguments) {
  orchestration::MatchOptions options = base_options();
  std::vector<std::string> mistakes;
  for (const std::string& word : whole_settings(arguments.settings)) {
    const auto applied = apply_setting(options, word);
    if (!applied) mistakes.push_back(applied.error().message);
  }
  if (mistakes.empty()) mistakes = refusals(options.server);
  if (!mistakes.empty()) return report_mistakes(mistakes);

  simulator::UdpConfig config;
  config.match.server = options.server;
  config.match.player = options.player;
  config.match.seed = arguments.seed.value_or(std::random_device()());
  config.match.cycle_limit = arguments.cycles;
  config.address = arguments.host;
  config.port = arguments.port.value_or(options.server.port);
  const auto made = simulator::MatchServer::create(config.match);
  if (!made) return report_mistakes({made.error().message});
  const std::atomic<int>& signal = watch_interrupts();
  auto server = UdpServer::open(config);
  if (!server) {
    fmt::print(stderr, "cls: {}\n", server.error().message);
    return kTryAgain;
  }
  auto logs = open_logs(arguments.folder, options.server);
  if (!logs) {
    fmt::print(stderr, "cls: {}\n", logs.error().message);
    return kCannotCreate;
  }
  (*server)->record(logs->game.get(), logs->text.get());
  (*server)->on_notice([&](const simulator::UdpNotice& notice) { print_notice(**server, notice); });
  fmt::print("listening on {}:{}\nSimulator Random Seed: {}\nHit CTRL-C to exit\n", arguments.host,
             (*server)->port(), config.match.seed);
  std::fflush(stdout);

  const UdpEnd end = serve(**server, signal);
  if (end == UdpEnd::kFinished) fmt::print("Game Over. Exiting...\n");
  print_result(**server);
  if (const std::string problem = logs->close(); !problem.empty()) {
    fmt::print(stderr, "cls: {}\n", problem);
    return kWriteFailed;
  }
  return exit_code_of(end, signal.load());
}

}  // namespace

void add_server_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("server", kDescription);
  command->add_option("SETTING", arguments->settings, "server::NAME=VALUE or player::NAME=VALUE");
  command->add_option("--host", arguments->host, "address to listen on (127.0.0.1)");
  command->add_option("--port", arguments->port, "0: a free one (server::port, 6000)")
      ->check(CLI::Range(0, 65535));
  command->add_option("--seed", arguments->seed, "of the match (else drawn and told)");
  command->add_option("--cycles", arguments->cycles, "end when game time reaches this");
  command->add_option("--dir", arguments->folder, "for match.rcg and match.rcl (.)");
  command->callback([arguments, &exit_code] { exit_code = run_server(*arguments); });
}

}  // namespace cls::cli
