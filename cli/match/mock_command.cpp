// `cls mock`: runs the mock Playmaker until a signal.
#include "cli/support/commands.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/io/whole_file.h"
#include "base/system/socket_address.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/suggestion.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "mock-server/mock.h"
#include "mock-server/script/named_behaviors.h"
#include "mock-server/server.h"
#include "process/ports.h"

namespace cls::cli {
namespace {

using mock_server::Faults;
using mock_server::Mock;
using mock_server::Server;
using std::chrono::milliseconds;

constexpr int kMaxUnum = 13;  // 12: coach, 13: trainer

constexpr const char* kMockDescription =
    "run the mock Playmaker as a gRPC server\n"
    "\n"
    "  cls mock                             on a free port, which is printed\n"
    "  cls mock hold --port 50051           a behavior that only observes\n"
    "  cls mock script.json                 behavior from a script (docs/mock.md)\n"
    "  cls mock --delay 40 --jitter 60      slow replies\n"
    "  cls mock --crash-at-cycle 200        crash during the match";

struct MockArguments {
  std::string behavior{mock_server::kDefaultBehavior};
  std::string host = "127.0.0.1";
  int port = 0;
  Faults faults;
  std::vector<std::string> unimplemented;
  std::vector<int> only_cycles;
  double slow_start_s = 0.0;
  int restart_after_ms = 500;
  bool json = false;
};

void add_fault_options(Command& command, MockArguments& arguments) {
  Faults& faults = arguments.faults;
  const auto add = [&command](const std::string& name, auto& member,
                              const std::string& help) -> Option& {
    return command.option(name, member, help).of_group("Faults");
  };

  add("--delay", faults.delay_ms, "delay of each decision in ms").from(0);
  add("--jitter", faults.jitter_ms, "maximum random extra delay in ms").from(0);
  add("--drop", faults.drop, "fraction of decisions without a reply").range(0, 1);
  add("--error", faults.error, "fraction of replies that are a gRPC error").range(0, 1);
  add("--status STATUS", faults.status, "gRPC status of --error (default: UNKNOWN)");
  add("--message", faults.message, "message of --error (default: injected error)");
  add("--garbage", faults.garbage, "fraction of replies with invalid bytes").range(0, 1);
  add("--oversize", faults.oversize, "fraction of replies of 5 MiB").range(0, 1);

  add("--crash-at-cycle", faults.crash_at_cycle, "crash at the first request of this cycle")
      .from(0);
  add("--hang-at-cycle", faults.hang_at_cycle, "stop replying at this cycle").from(0);
  add("--restart-at-cycle", faults.restart_at_cycle, "restart at this cycle, without state")
      .from(0);
  add("--restart-after", arguments.restart_after_ms, "downtime of the restart in ms")
      .from(0)
      .shows_default();

  command.flag("--wrong-client-id", faults.wrong_client_id, "give all clients the same client id")
      .of_group("Faults");
  add("--unimplemented RPC,RPC,...", arguments.unimplemented,
      "comma-separated RPCs that are not implemented")
      .split_at(',');
  command.flag("--full-states", faults.full_states, "no LEAN_STATES in one call per team")
      .of_group("Faults");

  add("--slow-start", arguments.slow_start_s, "seconds before listening").from(0);
  add("--fault-cycles FROM TO", arguments.only_cycles,
      "FROM TO: delays and fractions only in these cycles")
      .takes(2);
  add("--fault-unum N,N,...", faults.unums, "delays and fractions only for these uniform numbers")
      .split_at(',');
  add("--fault-seed", faults.seed, "random seed of the faults").shows_default();
}

// Merges flags into the faults of a script; flags take precedence. Returns an error.
std::optional<std::string> resolve_faults(const MockArguments& arguments, Faults& faults) {
  const Faults stock;
  const Faults& flags = arguments.faults;
  const auto merge = [&](auto... members) {
    ((faults.*members = flags.*members != stock.*members ? flags.*members : faults.*members), ...);
  };
  merge(&Faults::delay_ms, &Faults::jitter_ms, &Faults::drop, &Faults::error, &Faults::garbage,
        &Faults::oversize, &Faults::crash_at_cycle, &Faults::hang_at_cycle,
        &Faults::restart_at_cycle, &Faults::status, &Faults::message, &Faults::wrong_client_id,
        &Faults::full_states, &Faults::unums, &Faults::seed);

  if (const auto code = mock_server::status_code(faults.status); !code) {
    return "--status: " + code.error().message;
  }

  for (const std::string& name : arguments.unimplemented) {
    const auto rpc = proto::rpc_from_name(name);
    if (!rpc) {
      return fmt::format("--unimplemented: unknown RPC '{}'{}", name,
                         base::did_you_mean(name, proto::agent_rpc_names()));
    }
    faults.unimplemented.push_back(*rpc);
  }

  for (const int unum : flags.unums) {
    if (unum >= 1 && unum <= kMaxUnum) continue;
    return fmt::format("--fault-unum: {} is not a uniform number (1 to 11, 12 coach, 13 trainer)",
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

// The faults that affect the whole process: a crash kills it, a restart closes the port.
class ServingProcess {
 public:
  explicit ServingProcess(const MockArguments& arguments) : arguments_(arguments) {}

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

    TRY_INIT(auto server,
             Server::start(std::move(mock), base::with_brackets(arguments_.host), port()));
    server_ = std::move(server);
    port_ = server_->port();
    return {};
  }

  // Waits at most `timeout` for a restart to become due. Returns immediately when it is due,
  // because calls before the restart are refused.
  bool wait_restart_due(milliseconds timeout) {
    std::unique_lock lock(mutex_);
    return due_.wait_for(lock, timeout, [this] { return restart_due_; });
  }

  // Restarts on the same port, without crash faults and without registered agents.
  base::Result<void> restart(Mock mock, const std::atomic<int>& signal) {
    server_.reset();
    wait(milliseconds(arguments_.restart_after_ms), signal);
    mock.faults.crash_at_cycle.reset();
    mock.faults.restart_at_cycle = 0;
    mock.faults.restart_cycles = 0;
    TRY_INIT(auto server,
             Server::start(std::move(mock), base::with_brackets(arguments_.host), port()));
    server_ = std::move(server);
    const std::lock_guard lock(mutex_);
    restart_due_ = false;
    return {};
  }

  int port() const { return port_ == 0 ? arguments_.port : port_; }
  const Server& server() const { return *server_; }

 private:
  const MockArguments& arguments_;
  std::unique_ptr<Server> server_;
  std::mutex mutex_;
  std::condition_variable due_;
  bool restart_due_ = false;
  int port_ = 0;
};

// Builds the mock from the arguments.
int make_mock(const MockArguments& arguments, Mock& mock) {
  const bool is_script = mock_server::is_script_name(arguments.behavior);
  const auto absence = base::absence(arguments.behavior);
  if (absence && is_script) {
    return print_error(kNoInput, "{}: {}", arguments.behavior, *absence);
  }

  TRY_INIT_OR(is_script ? kBadData : kUsage, mock, mock_server::make_mock(arguments.behavior));
  if (const auto error = resolve_faults(arguments, mock.faults)) {
    return print_error(kUsage, *error);
  }
  return kOk;
}

// A host of others, or a port that is taken, with its owner.
int report_no_listener(const MockArguments& arguments, const std::string& error) {
  using process::Protocol;
  const std::string host = process::unusable_host(arguments.host);
  if (!host.empty()) {
    return print_error(kUsage, "--host '{}': {}", arguments.host, host);
  }

  const std::string taken = process::taken_port(Protocol::kTcp, {arguments.port});
  return print_error(kTryAgain, taken.empty() ? error : taken + "; --port 0 selects a free port");
}

// gRPC 1.51 closes its listener for good when accept() finds no free descriptor, so take as many as
// the system allows (docs/reliability.md).
void raise_descriptor_limit() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

int run_mock(const MockArguments& arguments) {
  Mock mock;
  TRY_STEP(make_mock(arguments, mock));

  const std::atomic<int>& signal = watch_interrupts();
  wait(milliseconds(static_cast<int>(arguments.slow_start_s * 1000.0)), signal);
  raise_descriptor_limit();
  const JsonStdout json(arguments.json);
  ServingProcess process(arguments);
  if (const auto started = process.start(std::move(mock)); !started) {
    return report_no_listener(arguments, started.error().message);
  }

  if (json.active()) {
    const base::Json line = {{"schema", "cls.mock/1"},
                             {"host", arguments.host},
                             {"port", process.port()},
                             {"behavior", arguments.behavior}};
    json.print_line(base::json_line(line));
  }

  fmt::print("listening on {}:{}\n", arguments.host, process.port());
  std::fflush(stdout);

  while (signal.load() == 0) {
    if (!process.wait_restart_due(milliseconds(50))) continue;
    Mock again;
    TRY_STEP(make_mock(arguments, again));
    TRY_OR(kTryAgain, process.restart(std::move(again), signal));
  }

  const auto failed = process.server().failed_expectations();
  if (!failed.empty()) return print_errors(kFailed, failed);
  return signal_exit_code(signal);
}

}  // namespace

void add_mock_command(Command& app) {
  auto [command, arguments] = app.command("mock", kMockDescription, run_mock);
  command.group = kPartCommands;

  command.setting("BEHAVIOR", arguments.behavior,
                  "simple, example, planner, hold, random, random:SEED, replay:FILE or FILE.json");
  command.setting("--port", arguments.port, "port; 0 selects a free port and prints it")
      .range(0, 65535);
  command.setting("--host HOST", arguments.host, "address to listen on");

  command
      .flag("--json", arguments.json,
            "print host and port as one line of JSON; all else goes to stderr")
      .of_group(kOutputGroup);
  add_fault_options(command, arguments);
}

}  // namespace cls::cli
