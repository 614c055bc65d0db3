// `cls check server HOST:PORT|PATH`.
#include "cli/support/commands.h"

#include <atomic>
#include <optional>
#include <string>

#include "base/system/own_program.h"
#include "checks/server/server_check.h"
#include "cli/check/check_output.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "process/scratch_folder.h"

namespace cls::cli {
namespace {

constexpr const char* kCheckServerDescription =
    "check that teams can play on a soccer server\n"
    "\n"
    "  cls check server rcssserver            started by cls, from PATH\n"
    "  cls check server localhost:6000        a running server without clients\n"
    "  cls check server embedded --json       the embedded server\n"
    "\n"
    "The steps cover connecting, replies to clients of protocol versions 8 to 19,\n"
    "commands, errors, monitors, coaches, invalid input, disconnecting and\n"
    "reconnecting. They connect clients as both teams: restart a running server\n"
    "afterwards. The trainer and coach ports are the next two.";

struct CheckServerArguments {
  std::string server;
  double start_timeout_s = 20.0;
  CheckOutput output;
};

int run_check_server(const CheckServerArguments& arguments) {
  TRY_INIT_OR(kUsage, const auto server, match::parse_server(arguments.server));

  checks::ServerCheckOptions options;
  options.server = server;

  TRY_INIT_OR(kUnavailable, const auto program, base::own_program());
  options.own_program = program;
  options.start_timeout =
      std::chrono::milliseconds(static_cast<int>(arguments.start_timeout_s * 1000.0));

  std::optional<process::ScratchFolder> scratch;
  if (options.server.kind != match::ServerChoice::Kind::kAddress) {
    TRY_INIT_OR(kCannotCreate, auto created, process::ScratchFolder::create());
    options.folder = scratch.emplace(std::move(created)).path();
  }

  const std::atomic<int>& signal = watch_interrupts();
  TRY_INIT_OR(kUnavailable, const auto report,
              checks::check_server(options, step_printer(arguments.output), signal));
  return finish_check(report, arguments.output, signal);
}

}  // namespace

void add_check_server_command(Command& check) {
  auto [command, arguments] = check.command("server", kCheckServerDescription, run_check_server);
  command.option("SERVER", arguments.server, "HOST:PORT, a program (path or name), or embedded")
      .required();

  add_check_output_options(command, arguments.output);
  command.setting("--start-timeout", arguments.start_timeout_s, "seconds until the first response")
      .of_group(kLimitsGroup)
      .above(0);
}

}  // namespace cls::cli
