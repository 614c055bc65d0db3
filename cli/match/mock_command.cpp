// `cls mock`: serves until a signal comes.
#include "cli/match/mock_command.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "mock-server/mock.h"
#include "mock-server/server.h"
#include "soccer/parameters/parameter.h"

namespace cls::cli {
namespace {

using mock_server::Faults;
using mock_server::Mock;
using mock_server::Server;
using std::chrono::milliseconds;

constexpr int kHighestNumber = 13;  // the trainer's

constexpr const char* kDescription =
    "Runs the mock Playmaker alone, for agents that ask over the network.\n"
    "\n"
    "  cls mock                             on a free port, which is printed\n"
    "  cls mock hold --port 50051           the behaviour that only watches\n"
    "  cls mock script.json                 what your script says (docs/mock.md)\n"
    "  cls mock --delay 40 --jitter 60      slow answers\n"
    "  cls mock --crash-at-cycle 200        dies in play";

struct Arguments {
  std::string behaviour = "simple";
  std::string host = "127.0.0.1";
  int port = 0;
  Faults faults;
  std::vector<std::string> unimplemented;
  std::vector<int> only_cycles;
  double slow_start_s = 0.0;
  int restart_after_ms = 500;
};

void add_fault_options(CLI::App& command, Arguments& arguments) {
  Faults& faults = arguments.faults;
  const auto share = CLI::Range(0.0, 1.0);
  const auto any = CLI::NonNegativeNumber;
  const auto add = [&command](const std::string& name, auto& member, const std::string& help) {
    return command.add_option(name, member, help)->group("Faults");
  };
  add("--delay", faults.delay_ms, "ms before each decision")->check(any);
  add("--jitter", faults.jitter_ms, "up to so many ms more, drawn")->check(any);
  add("--drop", faults.drop, "share of decisions without an answer")->check(share);
  add("--error", faults.error, "share answered with an error")->check(share);
  add("--status", faults.status, "the gRPC status of --error (UNKNOWN)");
  add("--garbage", faults.garbage, "share answered with bytes that are no message")->check(share);
  add("--oversize", faults.oversize, "share answered with 5 MiB")->check(share);
  add("--crash-at-cycle", faults.crash_at_cycle, "killed when asked about that cycle")->check(any);
  add("--hang-at-cycle", faults.hang_at_cycle, "no answers from that cycle on")->check(any);
  add("--restart-at-cycle", faults.restart_at_cycle, "gone, then back without its memory")
      ->check(any);
  add("--restart-after", arguments.restart_after_ms, "ms it is gone then (500)")->check(any);
  command.add_flag("--wrong-client-id", faults.wrong_client_id, "everybody gets the same identity")
      ->group("Faults");
  add("--unimplemented", arguments.unimplemented, "rpcs it does not have, by commas")
      ->delimiter(',');
  add("--slow-start", arguments.slow_start_s, "seconds before it listens")->check(any);
  add("--fault-cycles", arguments.only_cycles, "FROM TO: delays and shares only there")
      ->expected(2);
  add("--fault-unum", faults.unums, "delays and shares only for these players")->delimiter(',');
  add("--fault-seed", faults.seed, "of the draws (1)");
}

// Flags win over what a script says about the same fault.
std::optional<std::string> complete(const Arguments& arguments, Faults& faults) {
  const Faults stock;
  const Faults& flags = arguments.faults;
  const auto take = [&](auto member) {
    if (flags.*member != stock.*member) faults.*member = flags.*member;
  };
  for (const auto member : {&Faults::delay_ms, &Faults::jitter_ms}) take(member);
  for (const auto member : {&Faults::drop, &Faults::error, &Faults::garbage, &Faults::oversize}) {
    take(member);
  }
  for (const auto member :
       {&Faults::crash_at_cycle, &Faults::hang_at_cycle, &Faults::restart_at_cycle}) {
    take(member);
  }
  take(&Faults::status);
  take(&Faults::wrong_client_id);
  take(&Faults::unums);
  take(&Faults::seed);
  if (const auto code = mock_server::status_code(faults.status); !code) {
    return "--status: " + code.error().message;
  }
  for (const std::string& word : arguments.unimplemented) {
    const auto rpc = proto::rpc_from_name(word);
    if (!rpc) {
      return fmt::format("--unimplemented: no rpc '{}'{}", word,
                         base::did_you_mean(word, proto::rpc_names()));
    }
    faults.unimplemented.push_back(*rpc);
  }
  for (const int unum : flags.unums) {
    if (unum >= 1 && unum <= kHighestNumber) continue;
    return fmt::format("--fault-unum: {} is no uniform number (1 to 11, 12 coach, 13 trainer)",
                       unum);
  }
  if (!arguments.only_cycles.empty()) {
    if (arguments.only_cycles[0] > arguments.only_cycles[1]) {
      return fmt::format("--fault-cycles: {} is after {}", arguments.only_cycles[0],
                         arguments.only_cycles[1]);
    }
    faults.cycles = {arguments.only_cycles[0], arguments.only_cycles[1], 1};
  }
  return std::nullopt;
}

// Waits for `time` or a signal.
void wait(milliseconds time, const std::atomic<int>& signal) {
  const auto until = std::chrono::steady_clock::now() + time;
  while (signal.load() == 0 && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(milliseconds(10));
  }
}

// The faults of a process: a crash is a real one, and a restart closes the port.
class ServingProcess {
 public:
  explicit ServingProcess(const Arguments& arguments) : arguments_(arguments) {}

  base::Result<void> start(Mock mock) {
    const bool restarts = mock.faults.restart_at_cycle.has_value();
    if (restarts) {
      mock.faults.crash_at_cycle = mock.faults.restart_at_cycle;
      mock.faults.restart_at_cycle.reset();
    }
    mock.die = [this, restarts] {
      if (!restarts) kill(getpid(), SIGKILL);
      const std::lock_guard lock(mutex_);
      restart_due_ = true;
      due_.notify_one();
    };
    auto server = Server::start(std::move(mock), arguments_.host, port());
    if (!server) return server.error();
    server_ = *std::move(server);
    port_ = server_->port();
    return {};
  }

  // Waits until a restart is due, as short as it may be: every call before it is refused.
  bool wait_restart_due(milliseconds longest) {
    std::unique_lock lock(mutex_);
    return due_.wait_for(lock, longest, [this] { return restart_due_; });
  }

  // Back on the same port, without faults of its own end, knowing nobody.
  base::Result<void> restart(Mock mock, const std::atomic<int>& signal) {
    server_.reset();
    wait(milliseconds(arguments_.restart_after_ms), signal);
    mock.faults.crash_at_cycle.reset();
    mock.faults.restart_at_cycle = 0;
    mock.faults.restart_cycles = 0;
    auto server = Server::start(std::move(mock), arguments_.host, port());
    if (!server) return server.error();
    server_ = *std::move(server);
    const std::lock_guard lock(mutex_);
    restart_due_ = false;
    return {};
  }

  int port() const { return port_ == 0 ? arguments_.port : port_; }
  const Server& server() const { return *server_; }

 private:
  const Arguments& arguments_;
  std::unique_ptr<Server> server_;
  std::mutex mutex_;
  std::condition_variable due_;
  bool restart_due_ = false;
  int port_ = 0;
};

struct Failure {
  std::string message;
  ExitCode code = kDone;
};

// The mock that the arguments describe.
base::Result<Mock> make(const Arguments& arguments, Failure& failure) {
  if (mock_server::names_script(arguments.behaviour) &&
      !std::filesystem::exists(arguments.behaviour)) {
    failure.code = kNoInput;
    return base::Error{fmt::format("{}: no such file", arguments.behaviour)};
  }
  auto mock = mock_server::make_mock(arguments.behaviour);
  if (!mock) {
    failure.code = mock_server::names_script(arguments.behaviour) ? kBadData : kUsage;
    return mock.error();
  }
  if (const auto mistake = complete(arguments, mock->faults)) {
    failure.code = kUsage;
    return base::Error{*mistake};
  }
  return mock;
}

int report(const Failure& failure, const base::Error& error) {
  fmt::print(stderr, "cls: {}\n", error.message);
  return failure.code;
}

int run_mock(const Arguments& arguments) {
  Failure failure;
  auto mock = make(arguments, failure);
  if (!mock) return report(failure, mock.error());
  const std::atomic<int>& signal = watch_interrupts();
  failure.code = kTryAgain;
  wait(milliseconds(static_cast<int>(arguments.slow_start_s * 1000.0)), signal);
  ServingProcess process(arguments);
  if (const auto started = process.start(*std::move(mock)); !started) {
    return report(failure, started.error());
  }
  fmt::print("listening on {}:{}\n", arguments.host, process.port());
  std::fflush(stdout);
  while (signal.load() == 0) {
    if (!process.wait_restart_due(milliseconds(50))) continue;
    auto again = make(arguments, failure);
    if (!again) return report(failure, again.error());
    if (const auto back = process.restart(*std::move(again), signal); !back) {
      return report(failure, back.error());
    }
  }
  const auto failed = process.server().failed_expectations();
  for (const std::string& line : failed) fmt::print(stderr, "cls: {}\n", line);
  if (!failed.empty()) return kAnswerIsNo;
  return signal.load() == SIGTERM ? kTerminated : kInterrupted;
}

}  // namespace

void add_mock_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("mock", kDescription);
  command->add_option(
      "BEHAVIOUR", arguments->behaviour,
      "simple, planner, hold, random, random:SEED, replay:FILE or FILE.json (simple)");
  command->add_option("--port", arguments->port, "0: a free one (0)")->check(CLI::Range(0, 65535));
  command->add_option("--host", arguments->host, "address to listen on (127.0.0.1)");
  add_fault_options(*command, *arguments);
  command->callback([arguments, &exit_code] { exit_code = run_mock(*arguments); });
}

}  // namespace cls::cli
