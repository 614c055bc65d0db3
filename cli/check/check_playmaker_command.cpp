// `cls check playmaker ENDPOINT`.
#include "cli/support/commands.h"

#include <atomic>
#include <optional>
#include <string>

#include "checks/playmaker/playmaker_check.h"
#include "cli/check/check_output.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/support/tls_options.h"
#include "process/scratch_folder.h"

namespace cls::cli {
namespace {

using match::Endpoint;

constexpr const char* kCheckPlaymakerDescription =
    "check that a Playmaker can play matches\n"
    "\n"
    "  cls check playmaker localhost:50051\n"
    "  cls check playmaker 'run:python3 playmaker.py --port {port}'\n"
    "  cls check playmaker unix:playmaker.socket --json\n"
    "\n"
    "The steps cover the handshake, every RPC, edge-case States, 22 agents in\n"
    "parallel, broken connections, second matches and memory. Each step prints what\n"
    "it measured; a failed one, why it matters. ENDPOINT is HOST:PORT,\n"
    "tls:HOST:PORT, unix:PATH, run:COMMAND (with {port}), a team of cls.toml or mock.";

struct CheckPlaymakerArguments {
  std::string endpoint;
  match::TlsFileNames tls;
  std::optional<double> start_timeout_s;
  int deadline_ms = 3000;
  int calls = 10'000;
  int latency_limit_ms = 100;
  CheckOutput output;
};

int run_check_playmaker(const CheckPlaymakerArguments& arguments) {
  checks::PlaymakerCheckOptions options;
  TRY_STEP(read_playmaker("", arguments.endpoint, arguments.tls, options.endpoint));

  const std::optional<double> limit =
      arguments.start_timeout_s ? arguments.start_timeout_s : start_timeout_of_project();
  if (limit) {
    options.start_timeout = checks::Milliseconds(static_cast<int>(*limit * 1000.0));
  }
  options.deadline = checks::Milliseconds(arguments.deadline_ms);
  options.calls = arguments.calls;
  options.latency_limit = checks::Milliseconds(arguments.latency_limit_ms);

  std::optional<process::ScratchFolder> scratch;
  if (options.endpoint.kind == match::Endpoint::Kind::kRun) {
    TRY_INIT_OR(kCannotCreate, auto created, process::ScratchFolder::create());
    options.folder = scratch.emplace(std::move(created)).path();
  }

  const std::atomic<int>& signal = watch_interrupts();
  TRY_INIT_OR(kUnavailable, const auto report,
              checks::check_playmaker(options, step_printer(arguments.output), signal));

  return finish_check(report, arguments.output, signal);
}

}  // namespace

void add_check_playmaker_command(Command& check) {
  auto [command, arguments] =
      check.command("playmaker", kCheckPlaymakerDescription, run_check_playmaker);
  command.option("ENDPOINT", arguments.endpoint, "the Playmaker").required();
  add_tls_options(command, arguments.tls);
  add_check_output_options(command, arguments.output);

  command
      .option("--start-timeout", arguments.start_timeout_s,
              "seconds until the first response (default: that of cls.toml, else 20)")
      .of_group(kLimitsGroup)
      .above(0);
  command.setting("--rpc-deadline", arguments.deadline_ms, "deadline of an RPC in ms")
      .of_group(kPlaymakersGroup)
      .above(0);
  command.setting("--calls", arguments.calls, "number of calls in the memory step").above(0);

  command
      .setting("--latency-limit", arguments.latency_limit_ms,
               "maximum p99 latency of decisions in ms, with 22 players calling")
      .of_group(kLimitsGroup)
      .above(0);
}

}  // namespace cls::cli
