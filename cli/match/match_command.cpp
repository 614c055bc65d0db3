// `cls match`: plays one match.
#include "cli/support/commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/text/suggestion.h"
#include "cli/match/match_report.h"
#include "cli/match/match_stepper.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/support/tls_options.h"
#include "cli/terminal/progress_line.h"
#include "cli/terminal/terminal.h"
#include "orchestration/match/dry_run.h"
#include "orchestration/match/run_match.h"
#include "proxy/formation/formation_set.h"

namespace cls::cli {
namespace {

using orchestration::match::EndReason;
using orchestration::match::MatchOptions;
using orchestration::match::MatchResult;

constexpr const char* kDescription =
    "play one match and print its result\n"
    "\n"
    "  cls match mock mock                        the bundled team against itself\n"
    "  cls match mock localhost:50051 --seed 7    against your Playmaker, reproducible\n"
    "  cls match mock mock --cycles 600 --json    a short match, result as JSON\n"
    "  cls match mock 'run:python3 playmaker.py --port {port}'     starts and stops your "
    "Playmaker\n"
    "  cls match mock team:../helios --server rcssserver       rcssserver, an external team\n"
    "  cls match mock mock --server rcssserver --mode realtime\n"
    "\n"
    "LEFT and RIGHT are sides:  mock | mock:planner | mock:hold | mock:FILE.json | HOST:PORT\n"
    "| HOST:PORT+step | tls:HOST:PORT | unix:PATH | run:COMMAND | team:DIR, or the name of a\n"
    "team in cls.toml. +step: player n connects to PORT + n; team:DIR runs DIR/start or\n"
    "DIR/start.sh. See docs/matches.md.";

// Filled by CLI11; resolve() turns it into MatchOptions.
struct Arguments {
  std::string left;
  std::string right;
  MatchOptions options;
  std::optional<int> half_time;
  std::vector<std::string> settings;
  std::string on_late = "hold";
  std::string server = "embedded";
  std::string mode;
  TlsOptions tls;
  std::string trainer;
  std::string formation;
  std::string left_formation;
  std::string right_formation;
  bool dry_run = false;
  bool pin = false;
  std::string folder;
  std::string config_file;
  bool json = false;
  bool step = false;
  std::optional<int> at;
  std::string record_rpc;
  bool quiet = false;
  bool no_color = false;
};

// Deadlines of Playmakers and the handling of missed decisions.
void add_deadline_options(CLI::App& command, Arguments& arguments) {
  MatchOptions& options = arguments.options;
  command.add_option("--rpc-deadline", options.rpc_deadline_ms,
                     "deadline of an RPC in ms (default: lockstep 10000, synch 1000, "
                     "realtime 70)");
  command.add_flag("--no-deadline", options.no_deadline, "wait without limit (for debuggers)");
  command
      .add_option("--on-late", arguments.on_late,
                  "commands after a missed decision: hold, last or default")
      ->capture_default_str();
  command.add_option("--max-missed", options.max_missed,
                     "consecutive missed decisions that end the match (default: 20)");
  command.add_option("--reconnect-within", options.reconnect_within_s,
                     "seconds to wait for a disconnected Playmaker, where the server waits "
                     "(default: 3)");
  add_tls_options(command, arguments.tls);
}

void add_team_options(CLI::App& command, Arguments& arguments) {
  MatchOptions& options = arguments.options;
  command.add_option("--left-name", options.left_name, "team name of the left side");
  command.add_option("--right-name", options.right_name, "team name of the right side");
  command.add_flag("--own-names", options.own_names, "allow external teams to use their own names");
  command.add_flag("--coach,!--no-coach", options.coach,
                   "connect an online coach for each cls team (default: on)");
  command.add_option("--trainer", arguments.trainer,
                     "SIDE whose Playmaker handles GetTrainerActions (default: none)");
  command.add_option("--formation", arguments.formation,
                     "folder with formations of cls teams, see docs/formations.md (default: "
                     "built-in)");
  command.add_option("--left-formation", arguments.left_formation, "--formation of the left side");
  command.add_option("--right-formation", arguments.right_formation,
                     "--formation of the right side");
}

void add_options(CLI::App& command, Arguments& arguments) {
  MatchOptions& options = arguments.options;
  command.add_option("LEFT", arguments.left, "SIDE on the left")->required();
  command.add_option("RIGHT", arguments.right, "SIDE on the right")->required();
  command.add_option("--seed", options.seed,
                     "random seed; the same seed repeats the match (default: random, printed)");
  command.add_option("--cycles", options.cycles, "end the match at this game time");
  command.add_option("--half-time", arguments.half_time,
                     "length of a half in seconds (default: 300)");
  add_team_options(command, arguments);
  command.add_option("--dir", arguments.folder,
                     "match folder (default: ./runs/<UTC>-<left>-vs-<right>)");
  command.add_option("--config", arguments.config_file,
                     "cls.toml with team names (default: in or above the working directory)");
  command.add_flag("--json", arguments.json, "print only the result document");
  command.add_option("--set", arguments.settings, "server::NAME=VALUE, repeatable")
      ->expected(1)
      ->take_all();
  command
      .add_option("--server", arguments.server,
                  "embedded, rcssserver, PATH of a server, or HOST:PORT")
      ->capture_default_str();
  command.add_option("--mode", arguments.mode,
                     "lockstep, synch or realtime (default: lockstep; synch with an external "
                     "server or team)");
  command.add_flag("--pin", arguments.pin, "give each side half of the processor cores");
  command.add_flag("--dry-run", arguments.dry_run, "print the commands without starting anything");
  add_deadline_options(command, arguments);
  command.add_option("--start-timeout", options.start_timeout_s,
                     "seconds until the first response of a Playmaker (default: 20)");
  command.add_option("--stall-after", options.stall_after_s,
                     "seconds without a new cycle that end the match (default: 10)");
  command.add_option("--time-limit", options.time_limit_s,
                     "maximum seconds of the match (default: no limit)");
  command.add_flag("--step", arguments.step,
                   "wait for a line on stdin before each cycle (see docs/testing.md)");
  command.add_option("--at", arguments.at, "--step, starting at this game time");
  command
      .add_option("--record-rpc", arguments.record_rpc,
                  "record all requests and replies in FILE (see cls test --replay)")
      ->type_name("FILE");
  command.add_option("--monitor-port", options.monitor_port,
                     "UDP port for monitors; 0 selects a free port and prints it");
  command
      .add_option("--speed", options.speed, "limit speed to X times real time (default: no limit)")
      ->type_name("X");
  command.add_option("--protocol", options.protocol,
                     "protocol version of cls agents, 14 to 19 (default: 18)");
  command.add_flag("--quiet", arguments.quiet, "print no progress and no warnings");
  command.add_flag("--no-color", arguments.no_color, "disable color");
}

// Appends an error that names the option unless `value` is one of `choices`.
void check_choice(std::vector<std::string>& errors, std::string_view option,
                  const std::string& value, const std::vector<std::string_view>& choices) {
  for (const std::string_view known : choices) {
    if (value == known) return;
  }
  std::string message = fmt::format("{} '{}': ", option, value);
  const std::string_view near = base::nearest_name(value, choices);
  if (near.empty()) {
    message += fmt::format("must be {}", fmt::join(choices, " or "));
  } else {
    message += fmt::format("did you mean '{}'?", near);
  }
  errors.push_back(std::move(message));
}

void read_formation_options(Arguments& arguments, std::vector<std::string>& errors) {
  const auto read = [&](const std::string& own, const char* option,
                        std::shared_ptr<const proxy::FormationSet>& out) {
    const std::string& folder = own.empty() ? arguments.formation : own;
    if (folder.empty()) return;
    if (auto set = proxy::read_formations(folder)) {
      out = std::move(*set);
    } else {
      errors.push_back(
          fmt::format("{}: {}", own.empty() ? "--formation" : option, set.error().message));
    }
  };
  read(arguments.left_formation, "--left-formation", arguments.options.left_formations);
  read(arguments.right_formation, "--right-formation", arguments.options.right_formations);
}

// Sets the options from the arguments; returns all errors.
std::vector<std::string> resolve(Arguments& arguments) {
  std::vector<std::string> errors;
  MatchOptions& options = arguments.options;
  const auto read_side = [&](const std::string& text, orchestration::match::Endpoint& endpoint) {
    const auto parsed = orchestration::match::parse_endpoint(text);
    if (parsed) {
      endpoint = *parsed;
    } else {
      errors.push_back(parsed.error().message);
    }
  };
  read_side(arguments.left, options.left);
  read_side(arguments.right, options.right);
  if (!arguments.trainer.empty()) read_side(arguments.trainer, options.trainer.emplace());
  const auto server = orchestration::match::parse_server(arguments.server);
  if (server) options.server_choice = *server;
  if (!server) errors.push_back(server.error().message);
  if (!arguments.mode.empty()) {
    const auto mode = orchestration::match::parse_mode(arguments.mode);
    if (mode) options.mode = *mode;
    if (!mode) errors.push_back(mode.error().message);
  }
  check_choice(errors, "--on-late", arguments.on_late, {"hold", "last", "default"});
  options.on_late = proxy::parse_on_late(arguments.on_late).value_or(options.on_late);
  read_formation_options(arguments, errors);
  if (arguments.half_time) options.server.half_time = *arguments.half_time;
  for (const std::string& setting : arguments.settings) {
    const auto applied = apply_setting(options, setting);
    if (!applied) errors.push_back("--set: " + applied.error().message);
  }
  options.folder = arguments.folder;
  if (arguments.pin) {
    const auto pinned = pin_sides(options);
    if (!pinned) errors.push_back(pinned.error().message);
  }
  options.record_rpc = arguments.record_rpc;
  options.step = arguments.step || arguments.at;
  for (std::string& error : validate_options(options)) errors.push_back(std::move(error));
  return errors;
}

int exit_code_of(const MatchResult& result) {
  switch (result.end_reason) {
    case EndReason::kFinished:
      return result.write_error.empty() ? kOk : kWriteFailed;
    case EndReason::kRefused:
      return result.try_again ? kTryAgain : kUnavailable;
    case EndReason::kTimedOut:
      return kTimedOut;
    case EndReason::kInterrupted:
      return signal_exit_code(result.signal);
    case EndReason::kCrashed:
    case EndReason::kStalled:
    case EndReason::kLate:
    case EndReason::kProtocolError:
    case EndReason::kServerFailed:
      return kFailed;
  }
  return kInternalError;
}

// Prints the last output lines of the failed process; its log has all of them.
void print_last_output(const orchestration::match::ProcessFailure& failure) {
  constexpr std::size_t kLines = 5;
  const std::vector<std::string>& lines = failure.output;
  for (std::size_t i = lines.size() - std::min(kLines, lines.size()); i < lines.size(); ++i) {
    fmt::print(stderr, "  {}: {}\n", failure.process, lines[i]);
  }
}

int print_dry_run(const MatchOptions& options) {
  const auto text = orchestration::match::dry_run(options);
  if (!text) return print_error(kUnavailable, text.error().message);
  fmt::print("{}", *text);
  return kOk;
}

int resolve_names(Arguments& arguments) {
  MatchOptions& options = arguments.options;
  const bool names_given = !options.left_name.empty() || !options.right_name.empty();
  const int left = resolve_team_name(arguments.left, options.left_name, arguments.config_file);
  if (left != kOk) return left;
  std::string trainer_name;
  const int trainer = arguments.trainer.empty() ? kOk
                                                : resolve_team_name(arguments.trainer, trainer_name,
                                                                    arguments.config_file);
  if (trainer != kOk) return trainer;
  const int right = resolve_team_name(arguments.right, options.right_name, arguments.config_file);
  // Names of cls.toml need not match the names that external teams connect with.
  const bool named = !options.left_name.empty() || !options.right_name.empty();
  if (named && !names_given) options.own_names = true;
  return right;
}

int run_match_command(Arguments& arguments) {
  if (const int exit_code = resolve_names(arguments); exit_code != kOk) return exit_code;
  const std::vector<std::string> errors = resolve(arguments);
  if (!errors.empty()) return print_errors(kUsage, errors);
  std::vector<orchestration::match::Endpoint*> sides = {&arguments.options.left,
                                                        &arguments.options.right};
  if (arguments.options.trainer) sides.push_back(&*arguments.options.trainer);
  for (orchestration::match::Endpoint* side : sides) {
    if (const int read = read_side_script(*side); read != kOk) return read;
    if (const int read = read_tls_files(*side, arguments.tls); read != kOk) return read;
  }

  if (arguments.dry_run) return print_dry_run(arguments.options);
  const bool live = stderr_is_terminal() && !arguments.quiet && !arguments.step && !arguments.at;
  ProgressLine progress(live, arguments.quiet);
  const std::atomic<int>& signal = watch_interrupts();
  MatchStepper stepper(arguments.at.value_or(0), STDIN_FILENO, signal);
  const bool steps = arguments.step || arguments.at;
  const auto result = run_match(arguments.options, progress, signal, steps ? &stepper : nullptr);
  progress.clear();
  if (!result) return print_error(kCannotCreate, result.error().message);
  if (!result->message.empty()) print_error(0, result->message);
  if (result->failure) print_last_output(*result->failure);
  if (!result->write_error.empty()) print_error(0, result->write_error);
  if (arguments.json) {
    fmt::print("{}", to_json(*result));
  } else {
    fmt::print("{}", match_report(*result, stdout_supports_color(arguments.no_color)));
  }
  return exit_code_of(*result);
}

}  // namespace

void add_match_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("match", kDescription);
  add_options(*command, *arguments);
  command->callback([arguments, &exit_code] { exit_code = run_match_command(*arguments); });
}

}  // namespace cls::cli
