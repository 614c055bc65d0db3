// `cls doctor`.
#include "cli/support/commands.h"

#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <string>

#include "base/system/own_program.h"
#include "base/text/wrap_text.h"
#include "checks/doctor/doctor.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/support/tls_options.h"
#include "cli/terminal/terminal.h"

namespace cls::cli {
namespace {

using checks::DoctorCheck;
using checks::DoctorReport;
using checks::DoctorStatus;
using match::Endpoint;

constexpr const char* kDoctorDescription =
    "check the host, its programs, and optionally a server or a Playmaker\n"
    "\n"
    "  cls doctor                              host and programs\n"
    "  cls doctor --server rcssserver          does it start and respond?\n"
    "  cls doctor --server localhost:6000      a running server: its type, its match\n"
    "  cls doctor --playmaker localhost:50051  does the Playmaker respond?\n"
    "  cls doctor --json                       for scripts\n"
    "\n"
    "Changes nothing and connects no player. Prints how to install what is missing.\n"
    "Exit code: 1 if something required is missing, 69 if the server or Playmaker is\n"
    "unreachable.";

struct DoctorArguments {
  std::string server;
  std::string playmaker;
  match::TlsFileNames tls;
  double limit_s = 5.0;
  bool json = false;
};

constexpr std::size_t kFoundColumn = 28;
constexpr std::size_t kNarrow = 60;
constexpr std::size_t kNarrowColumn = 4;

const char* color_of(DoctorStatus status, bool needed) {
  constexpr const char* kGreen = "\x1b[32m";
  constexpr const char* kYellow = "\x1b[33m";
  constexpr const char* kRed = "\x1b[31m";

  if (status == DoctorStatus::kOk) return kGreen;
  return needed ? kRed : kYellow;
}

void print_row(const DoctorCheck& check, bool color) {
  const std::string status = fmt::format("{:<11}", name(check.status));
  const std::string shown =
      color ? fmt::format("{}{}\x1b[0m", color_of(check.status, check.needed), status) : status;

  const bool narrow = stdout_width() < kNarrow;
  const std::size_t column = narrow ? kNarrowColumn : kFoundColumn;
  const auto folded = [column](const std::string& text) {
    return base::wrap_text(text, stdout_width(), column);
  };

  if (narrow) {
    fmt::print("{}  {}\n{:{}}{}\n", shown, check.name, "", column, folded(check.found));
  } else {
    fmt::print("{}  {:<13}  {}\n", shown, check.name, folded(check.found));
  }
  if (check.status != DoctorStatus::kOk) {
    fmt::print("{:{}}{}\n", "", column, folded("needed for: " + check.purpose));
  }
  if (!check.hint.empty()) {
    fmt::print("{:{}}{}\n", "", column, folded("hint: " + check.hint));
  }

  std::fflush(stdout);
}

void print_summary(const DoctorReport& report) {
  std::string lacking;
  for (const DoctorCheck& check : report.checks) {
    if (check.needed && check.status != DoctorStatus::kOk) {
      lacking += (lacking.empty() ? "" : ", ") + check.name;
    }
  }

  if (lacking.empty()) {
    fmt::print("\nReady to play: cls match mock mock\n");
  } else {
    fmt::print("\nNot ready: {}\n", lacking);
  }
}

int exit_code_of(const DoctorReport& report, int signal) {
  if (signal != 0) return signal_exit_code(signal);
  if (report.unreachable()) return kUnavailable;
  return report.healthy() ? kOk : kFailed;
}

int run_doctor(const DoctorArguments& arguments) {
  checks::DoctorOptions options;

  TRY_INIT_OR(kUnavailable, const auto program, base::own_program());
  options.own_program = program;
  options.limit = std::chrono::milliseconds(static_cast<int>(arguments.limit_s * 1000.0));

  if (!arguments.server.empty()) {
    TRY_INIT_OR(kUsage, auto server, match::parse_server(arguments.server));
    options.server = std::move(server);
  }

  if (!arguments.playmaker.empty()) {
    TRY_STEP(read_playmaker("--playmaker: ", arguments.playmaker, arguments.tls,
                            options.playmaker.emplace()));
  }

  const std::atomic<int>& signal = watch_interrupts();
  const bool color = stdout_supports_color();
  const auto on_check = [&](const DoctorCheck& check) {
    const bool wanted = check.status != DoctorStatus::kOk || !output_options().quiet;
    if (!arguments.json && wanted) print_row(check, color);
  };

  const DoctorReport report = checks::examine(options, on_check, signal);
  if (arguments.json) {
    fmt::print("{}", checks::to_json(report));
  } else {
    print_summary(report);
  }

  return exit_code_of(report, signal);
}

}  // namespace

void add_doctor_command(Command& app) {
  auto [command, arguments] = app.command("doctor", kDoctorDescription, run_doctor);
  command.group = kCheckCommands;
  command.starts_programs = true;

  command.option("--server SERVER", arguments.server,
                 "check a server: rcssserver, PATH, embedded or HOST:PORT");
  command
      .option("--playmaker SIDE", arguments.playmaker,
              "check a Playmaker: HOST:PORT, HOST:PORT+step, tls:HOST:PORT, unix:PATH, "
              "run:COMMAND")
      .of_group(kPlaymakersGroup);

  add_tls_options(command, arguments.tls);
  command
      .setting("--start-timeout", arguments.limit_s,
               "timeout of each program and each probe in seconds")
      .of_group(kLimitsGroup)
      .above(0);

  command.flag("--json", arguments.json, "print one JSON document instead of the table")
      .of_group(kOutputGroup);
}

}  // namespace cls::cli
