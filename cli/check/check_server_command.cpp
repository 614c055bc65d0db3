// `cls check server HOST:PORT|PATH`.
#include "cli/check/check_server_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "cli/support/ci_reports.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "orchestration/checks/server/server_check.h"

namespace cls::cli {
namespace {

using orchestration::checks::CheckReport;
using orchestration::checks::CheckStep;
using orchestration::checks::StepResult;

constexpr const char* kDescription =
    "Tries whether teams can play on a soccer server, in named steps.\n"
    "\n"
    "  cls check server rcssserver            started by us, found on PATH\n"
    "  cls check server localhost:6000        one that runs, which nobody has joined yet\n"
    "  cls check server embedded --json       our own\n"
    "\n"
    "Who may join, what clients of versions 8 to 19 are told, what commands do, errors, monitors,\n"
    "coaches, garbage, leaving and coming back. The steps take the places of both teams: restart "
    "a\n"
    "running server afterwards. Trainers' and coaches' ports are the next two.";

struct Arguments {
  std::string server;
  double start_timeout_s = 20.0;
  bool json = false;
  CiReports reports;
};

int exit_code_of(const CheckReport& report, int interrupted) {
  if (interrupted == SIGINT) return kInterrupted;
  if (interrupted == SIGTERM) return kTerminated;
  if (report.steps.front().result != StepResult::kPass) return kUnavailable;
  return report.passed() ? kDone : kAnswerIsNo;
}

int run_check_server(const Arguments& arguments) {
  const auto server = orchestration::match::parse_server(arguments.server);
  if (!server) {
    fmt::print(stderr, "cls: {}\n", server.error().message);
    return kUsage;
  }
  orchestration::checks::ServerCheckOptions options;
  options.server = *server;
  options.own_program = std::filesystem::read_symlink("/proc/self/exe").string();
  options.start_timeout =
      std::chrono::milliseconds(static_cast<int>(arguments.start_timeout_s * 1000.0));
  const std::atomic<int>& interrupted = watch_interrupts();
  const auto on_step = [&](const CheckStep& step) {
    if (arguments.json) return;
    fmt::print("{}", to_text(step));
    std::fflush(stdout);
  };
  const auto report = orchestration::checks::check_server(options, on_step, interrupted);
  if (!report) {
    fmt::print(stderr, "cls: {}\n", report.error().message);
    return kUnavailable;
  }
  fmt::print("{}", arguments.json ? to_json(*report) : summary(*report));
  const ExitCode handed_out =
      hand_out(arguments.reports, to_junit(*report), to_annotations(*report));
  return handed_out == kDone ? exit_code_of(*report, interrupted) : handed_out;
}

}  // namespace

void add_check_server_command(CLI::App& check, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = check.add_subcommand("server", kDescription);
  command
      ->add_option("SERVER", arguments->server,
                   "HOST:PORT, a program (PATH or a name), or embedded")
      ->required();
  command->add_flag("--json", arguments->json, "one JSON document at the end instead of lines");
  add_ci_options(*command, arguments->reports);
  command
      ->add_option("--start-timeout", arguments->start_timeout_s,
                   "seconds until it must answer first (20)")
      ->check(CLI::PositiveNumber);
  command->callback([arguments, &exit_code] { exit_code = run_check_server(*arguments); });
}

}  // namespace cls::cli
