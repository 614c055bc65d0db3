// `cls match`: options in, one call, result out.
#include "cli/match/match_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/text/suggestion.h"
#include "cli/match/match_report.h"
#include "cli/match/match_stepper.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/named_side.h"
#include "cli/support/side_script.h"
#include "cli/support/tls_options.h"
#include "cli/terminal/progress_line.h"
#include "cli/terminal/terminal.h"
#include "orchestration/match/dry_run.h"
#include "orchestration/match/match.h"
#include "proxy/formation/formation_set.h"

namespace cls::cli {
namespace {

using orchestration::match::EndReason;
using orchestration::match::MatchOptions;
using orchestration::match::MatchResult;

constexpr const char* kDescription =
    "Plays one match and prints its result.\n"
    "\n"
    "  cls match mock mock                        the bundled team against itself\n"
    "  cls match mock localhost:50051 --seed 7    against your Playmaker, repeatable\n"
    "  cls match mock mock --cycles 600 --json    a short one, result as JSON\n"
    "  cls match mock 'run:python3 brain.py --port {port}'     starts and ends your Playmaker\n"
    "  cls match mock team:../helios --server rcssserver       the real server, a foreign team\n"
    "  cls match mock mock --server rcssserver --mode realtime\n"
    "\n"
    "A side is  mock | mock:planner | mock:hold | mock:FILE.json | HOST:PORT | HOST:PORT+step |\n"
    "tls:HOST:PORT | unix:PATH | run:COMMAND | team:DIR  (+step: player n asks PORT + n; team:\n"
    "DIR/start or DIR/start.sh), or the name of a team in cls.toml. See docs/matches.md.";

// What CLI11 fills in; turned into MatchOptions once everything is read.
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
  bool no_colour = false;
};

// What a Playmaker is given, and what becomes of answers that do not come.
void add_answer_options(CLI::App& command, Arguments& arguments) {
  MatchOptions& options = arguments.options;
  command.add_option("--rpc-deadline", options.rpc_deadline_ms,
                     "time a Playmaker has for an answer, in ms (lockstep 10000, synch 1000, "
                     "realtime 70)");
  command.add_flag("--no-deadline", options.no_deadline, "wait for ever (a debugger at work)");
  command.add_option("--on-late", arguments.on_late,
                     "commands of a cycle without an answer: hold, last or default (hold)");
  command.add_option("--max-missed", options.max_missed,
                     "missed answers in a row that end the match (20)");
  command.add_option("--reconnect-within", options.reconnect_within_s,
                     "seconds that a Playmaker lost in mid-match may take to come back where the "
                     "server waits (3)");
  add_tls_options(command, arguments.tls);
}

void add_options(CLI::App& command, Arguments& arguments) {
  MatchOptions& options = arguments.options;
  command.add_option("LEFT", arguments.left, "left side")->required();
  command.add_option("RIGHT", arguments.right, "right side")->required();
  command.add_option("--seed", options.seed, "makes the match repeatable (else drawn and told)");
  command.add_option("--cycles", options.cycles, "end when game time reaches this");
  command.add_option("--half-time", arguments.half_time, "length of a half in seconds (300)");
  command.add_option("--left-name", options.left_name, "team name of the left side");
  command.add_option("--right-name", options.right_name, "team name of the right side");
  command.add_flag("--own-names", options.own_names,
                   "foreign teams may play under names of their own");
  command.add_option("--dir", arguments.folder, "match folder (./runs/<UTC>-<left>-vs-<right>)");
  command.add_option("--config", arguments.config_file,
                     "cls.toml whose team names are sides (the one here or above)");
  command.add_flag("--json", arguments.json, "print the result document, nothing else");
  command.add_option("--set", arguments.settings, "server::NAME=VALUE, repeatable")
      ->expected(1)
      ->take_all();
  command.add_option("--server", arguments.server,
                     "embedded, rcssserver, the PATH of a server, or HOST:PORT (embedded)");
  command.add_option("--mode", arguments.mode,
                     "how time runs: lockstep, synch or realtime (lockstep; synch with a foreign "
                     "server or team)");
  command.add_flag("--coach,!--no-coach", options.coach, "both teams bring their coach (yes)");
  command.add_option("--trainer", arguments.trainer,
                     "a side form: who is asked GetTrainerActions (nobody)");
  command.add_option("--formation", arguments.formation,
                     "folder with formations for our agents, see docs/formations.md (built-in)");
  command.add_option("--left-formation", arguments.left_formation, "the same for the left side");
  command.add_option("--right-formation", arguments.right_formation, "the same for the right side");
  command.add_flag("--pin", arguments.pin, "give each side half of the processors for itself");
  command.add_flag("--dry-run", arguments.dry_run, "print what would be started, start nothing");
  add_answer_options(command, arguments);
  command.add_option("--start-timeout", options.start_timeout_s,
                     "seconds until a Playmaker must answer first (20)");
  command.add_option("--stall-after", options.stall_after_s,
                     "seconds without a new cycle that end the match (10)");
  command.add_option("--time-limit", options.time_limit_s, "seconds for the whole match (none)");
  command.add_flag("--step", arguments.step,
                   "wait before each cycle's decisions for a line on stdin (see docs/testing.md)");
  command.add_option("--at", arguments.at, "--step from this game time on");
  command.add_option("--record-rpc", arguments.record_rpc,
                     "write all requests and replies into this file (cls test --replay)");
  command.add_option("--monitor-port", options.monitor_port,
                     "UDP port where monitors may attach and watch; 0: a free one, which is told");
  command.add_option("--speed", options.speed,
                     "play at so many times real time (as fast as it goes)");
  command.add_option("--protocol", options.protocol, "version our agents speak, 14 to 19 (18)");
  command.add_flag("--quiet", arguments.quiet, "no progress, no warnings");
  command.add_flag("--no-color", arguments.no_colour, "plain text also on a terminal");
}

// The one word of `words` that was meant, or a mistake that names the option.
void check_word(std::vector<std::string>& mistakes, std::string_view option,
                const std::string& word, const std::vector<std::string_view>& words) {
  for (const std::string_view known : words) {
    if (word == known) return;
  }
  std::string message = fmt::format("{} '{}': ", option, word);
  const std::string_view near = base::nearest_name(word, words);
  if (near.empty()) {
    message += fmt::format("must be {}", fmt::join(words, " or "));
  } else {
    message += fmt::format("did you mean '{}'?", near);
  }
  mistakes.push_back(std::move(message));
}

void read_formations_of(Arguments& arguments, std::vector<std::string>& mistakes) {
  const auto read = [&](const std::string& own, const char* option,
                        std::shared_ptr<const proxy::FormationSet>& out) {
    const std::string& folder = own.empty() ? arguments.formation : own;
    if (folder.empty()) return;
    if (auto set = proxy::read_formations(folder)) {
      out = std::move(*set);
    } else {
      mistakes.push_back(
          fmt::format("{}: {}", own.empty() ? "--formation" : option, set.error().message));
    }
  };
  read(arguments.left_formation, "--left-formation", arguments.options.left_formations);
  read(arguments.right_formation, "--right-formation", arguments.options.right_formations);
}

// Everything that is wrong with the arguments, and the options they make.
std::vector<std::string> complete(Arguments& arguments) {
  std::vector<std::string> mistakes;
  MatchOptions& options = arguments.options;
  const auto read_side = [&](const std::string& text, orchestration::match::Endpoint& endpoint) {
    const auto parsed = orchestration::match::parse_endpoint(text);
    if (parsed) {
      endpoint = *parsed;
    } else {
      mistakes.push_back(parsed.error().message);
    }
  };
  read_side(arguments.left, options.left);
  read_side(arguments.right, options.right);
  if (!arguments.trainer.empty()) read_side(arguments.trainer, options.trainer.emplace());
  const auto server = orchestration::match::parse_server(arguments.server);
  if (server) options.server_choice = *server;
  if (!server) mistakes.push_back(server.error().message);
  if (!arguments.mode.empty()) {
    const auto mode = orchestration::match::parse_mode(arguments.mode);
    if (mode) options.mode = *mode;
    if (!mode) mistakes.push_back(mode.error().message);
  }
  check_word(mistakes, "--on-late", arguments.on_late, {"hold", "last", "default"});
  options.on_late = proxy::on_late_from_name(arguments.on_late).value_or(options.on_late);
  read_formations_of(arguments, mistakes);
  if (arguments.half_time) options.server.half_time = *arguments.half_time;
  for (const std::string& setting : arguments.settings) {
    const auto applied = apply_setting(options, setting);
    if (!applied) mistakes.push_back("--set: " + applied.error().message);
  }
  options.folder = arguments.folder;
  if (arguments.pin) {
    const auto pinned = pin_sides(options);
    if (!pinned) mistakes.push_back(pinned.error().message);
  }
  options.record_rpc = arguments.record_rpc;
  const bool lockstep = mode_of(options) == orchestration::match::MatchMode::kLockstep;
  if ((arguments.step || arguments.at) && !lockstep) {
    mistakes.push_back("--step and --at need --mode lockstep");
  }
  for (std::string& mistake : mistakes_in(options)) mistakes.push_back(std::move(mistake));
  return mistakes;
}

int exit_code_of(const MatchResult& result) {
  switch (result.end_reason) {
    case EndReason::kFinished:
      return result.write_error.empty() ? kDone : kWriteFailed;
    case EndReason::kRefused:
      return result.try_again ? kTryAgain : kUnavailable;
    case EndReason::kTimedOut:
      return kTimedOut;
    case EndReason::kInterrupted:
      return result.signal == SIGTERM ? kTerminated : kInterrupted;
    case EndReason::kCrashed:
    case EndReason::kStalled:
    case EndReason::kLate:
    case EndReason::kProtocolError:
    case EndReason::kServerFailed:
      return kAnswerIsNo;
  }
  return kInternalError;
}

// The end of the output of the process that failed; its log has all of it.
void tell_last_words(const orchestration::match::ProcessFailure& failure) {
  constexpr std::size_t kLines = 5;
  const std::vector<std::string>& lines = failure.output;
  for (std::size_t i = lines.size() - std::min(kLines, lines.size()); i < lines.size(); ++i) {
    fmt::print(stderr, "  {}: {}\n", failure.process, lines[i]);
  }
}

int print_dry_run(const MatchOptions& options) {
  const auto text = orchestration::match::dry_run(options);
  if (!text) {
    fmt::print(stderr, "cls: {}\n", text.error().message);
    return kUnavailable;
  }
  fmt::print("{}", *text);
  return kDone;
}

int resolve_names(Arguments& arguments) {
  MatchOptions& options = arguments.options;
  const bool asked_for = !options.left_name.empty() || !options.right_name.empty();
  const int left = resolve_named_side(arguments.left, options.left_name, arguments.config_file);
  if (left != kDone) return left;
  std::string trainer_name;
  const int trainer =
      arguments.trainer.empty()
          ? kDone
          : resolve_named_side(arguments.trainer, trainer_name, arguments.config_file);
  if (trainer != kDone) return trainer;
  const int right = resolve_named_side(arguments.right, options.right_name, arguments.config_file);
  // Names of cls.toml are the user's; what a foreign team calls itself is its own affair.
  const bool named = !options.left_name.empty() || !options.right_name.empty();
  if (named && !asked_for) options.own_names = true;
  return right;
}

int run_match_command(Arguments& arguments) {
  if (const int exit_code = resolve_names(arguments); exit_code != kDone) return exit_code;
  const std::vector<std::string> mistakes = complete(arguments);
  for (const std::string& mistake : mistakes) fmt::print(stderr, "cls: {}\n", mistake);
  if (!mistakes.empty()) return kUsage;
  std::vector<orchestration::match::Endpoint*> sides = {&arguments.options.left,
                                                        &arguments.options.right};
  if (arguments.options.trainer) sides.push_back(&*arguments.options.trainer);
  for (orchestration::match::Endpoint* side : sides) {
    if (const int read = read_script_of(*side); read != kDone) return read;
    if (const int read = read_tls_files(*side, arguments.tls); read != kDone) return read;
  }

  if (arguments.dry_run) return print_dry_run(arguments.options);
  const bool live = stderr_is_terminal() && !arguments.quiet && !arguments.step && !arguments.at;
  ProgressLine progress(live, arguments.quiet);
  const std::atomic<int>& signal = watch_interrupts();
  MatchStepper stepper(arguments.at.value_or(0), STDIN_FILENO, signal);
  const bool steps = arguments.step || arguments.at;
  const auto result = run_match(arguments.options, progress, signal, steps ? &stepper : nullptr);
  progress.clear();
  if (!result) {
    fmt::print(stderr, "cls: {}\n", result.error().message);
    return kCannotCreate;
  }
  if (!result->message.empty()) fmt::print(stderr, "cls: {}\n", result->message);
  if (result->failure) tell_last_words(*result->failure);
  if (!result->write_error.empty()) fmt::print(stderr, "cls: {}\n", result->write_error);
  if (arguments.json) {
    fmt::print("{}", to_json(*result));
  } else {
    fmt::print("{}", match_report(*result, stdout_takes_colour(arguments.no_colour)));
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
