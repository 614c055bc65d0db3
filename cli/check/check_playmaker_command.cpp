// `cls check playmaker ENDPOINT`.
#include "cli/check/check_playmaker_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string>

#include "cli/support/ci_reports.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/tls_options.h"
#include "orchestration/checks/playmaker/playmaker_check.h"

namespace cls::cli {
namespace {

using orchestration::checks::CheckReport;
using orchestration::checks::CheckStep;
using orchestration::checks::StepResult;
using orchestration::match::Endpoint;

constexpr const char* kDescription =
    "Tries whether matches can be played with a Playmaker, in named steps.\n"
    "\n"
    "  cls check playmaker localhost:50051\n"
    "  cls check playmaker 'run:python3 playmaker.py --port {port}'\n"
    "  cls check playmaker unix:brain.socket --json\n"
    "\n"
    "Handshake, every rpc, States from the edges of the game, 22 agents at once, broken "
    "connections,\n"
    "second matches, memory: each step says what was seen, and a failed one why it matters.\n"
    "ENDPOINT is HOST:PORT, tls:HOST:PORT, unix:PATH, run:COMMAND ({port} is filled in) or mock.";

struct Arguments {
  std::string endpoint;
  TlsOptions tls;
  double start_timeout_s = 20.0;
  int deadline_ms = 3000;
  int calls = 10'000;
  int latency_limit_ms = 100;
  bool json = false;
  CiReports reports;
};

int exit_code_of(const CheckReport& report, int interrupted) {
  if (interrupted == SIGINT) return kInterrupted;
  if (interrupted == SIGTERM) return kTerminated;
  if (report.steps.front().result != StepResult::kPass) return kUnavailable;
  return report.passed() ? kDone : kAnswerIsNo;
}

int run_check_playmaker(const Arguments& arguments) {
  auto endpoint = orchestration::match::parse_endpoint(arguments.endpoint);
  if (!endpoint || !endpoint->has_playmaker()) {
    fmt::print(stderr, "cls: {}\n",
               endpoint ? "team:DIR has no Playmaker to check" : endpoint.error().message);
    return kUsage;
  }
  if (const int read = read_tls_files(*endpoint, arguments.tls); read != kDone) return read;
  orchestration::checks::PlaymakerCheckOptions options;
  options.endpoint = *endpoint;
  options.start_timeout =
      orchestration::checks::Milliseconds(static_cast<int>(arguments.start_timeout_s * 1000.0));
  options.deadline = orchestration::checks::Milliseconds(arguments.deadline_ms);
  options.calls = arguments.calls;
  options.latency_limit = orchestration::checks::Milliseconds(arguments.latency_limit_ms);
  const std::atomic<int>& interrupted = watch_interrupts();
  const auto on_step = [&](const CheckStep& step) {
    if (arguments.json) return;
    fmt::print("{}", to_text(step));
    std::fflush(stdout);
  };
  const auto report = orchestration::checks::check_playmaker(options, on_step, interrupted);
  if (!report) {
    fmt::print(stderr, "cls: {}\n", report.error().message);
    return endpoint->kind == Endpoint::Kind::kMock ? kBadData : kUnavailable;
  }
  fmt::print("{}", arguments.json ? to_json(*report) : summary(*report));
  const ExitCode handed_out =
      hand_out(arguments.reports, to_junit(*report), to_annotations(*report));
  return handed_out == kDone ? exit_code_of(*report, interrupted) : handed_out;
}

}  // namespace

void add_check_playmaker_command(CLI::App& check, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = check.add_subcommand("playmaker", kDescription);
  command->add_option("ENDPOINT", arguments->endpoint, "the Playmaker")->required();
  command->add_flag("--json", arguments->json, "one JSON document at the end instead of lines");
  add_tls_options(*command, arguments->tls);
  add_ci_options(*command, arguments->reports);
  command
      ->add_option("--start-timeout", arguments->start_timeout_s,
                   "seconds until it must answer first (20)")
      ->check(CLI::PositiveNumber);
  command->add_option("--rpc-deadline", arguments->deadline_ms, "time of an answer, in ms (3000)")
      ->check(CLI::PositiveNumber);
  command->add_option("--calls", arguments->calls, "calls of the memory step (10000)")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--latency-limit", arguments->latency_limit_ms,
                   "ms within which 99 of 100 decisions must come while 22 players ask (100)")
      ->check(CLI::PositiveNumber);
  command->callback([arguments, &exit_code] { exit_code = run_check_playmaker(*arguments); });
}

}  // namespace cls::cli
