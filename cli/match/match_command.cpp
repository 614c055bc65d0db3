// `cls match`: plays one match.
#include "cli/support/commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/text/counted.h"
#include "base/text/json.h"
#include "cli/logs/live_view.h"
#include "cli/match/match_arguments.h"
#include "cli/match/match_report.h"
#include "cli/match/match_stepper.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/progress_line.h"
#include "cli/terminal/terminal.h"
#include "match/dry_run.h"
#include "match/hooks/event_command.h"
#include "match/result/match_folder.h"
#include "match/run_match.h"

namespace cls::cli {
namespace {

using match::EndReason;
using match::MatchResult;

constexpr const char* kMatchDescription =
    "play one match and print its result\n"
    "\n"
    "  cls match mock mock                      the bundled team against itself\n"
    "  cls match mock localhost:50051 --seed 7  against your Playmaker, reproducible\n"
    "  cls match mock mock --cycles 600 --json  a short match, its result as JSON\n"
    "  cls match mock 'run:python3 playmaker.py --port {port}'    starts it, stops it\n"
    "  cls match mock team:../helios --server rcssserver    an external team\n"
    "  cls match mock mock --server rcssserver --mode realtime\n"
    "\n"
    "LEFT and RIGHT are sides (docs/matches.md):\n"
    "\n"
    "  mock             the bundled team; mock:simple, mock:example, mock:planner,\n"
    "                   mock:hold, mock:random, mock:random:SEED: other behaviors;\n"
    "                   mock:learned: a team that learned from the planner\n"
    "  mock:FILE.json   a script (docs/mock.md); mock:replay:FILE: recorded replies\n"
    "  HOST:PORT        a running Playmaker; tls:HOST:PORT, unix:PATH\n"
    "  HOST:PORT+step   the same; player n connects to PORT + n\n"
    "  run:COMMAND      a Playmaker that cls starts; {port} is filled in\n"
    "  team:DIR         an external team: DIR/start or DIR/start.sh\n"
    "  policy:FILE      a trained policy (docs/training.md); policy:planner and\n"
    "                   policy:random choose its options by plan or at random\n"
    "  mix:1=SIDE;2-11=SIDE;coach=SIDE    several Playmakers in one team\n"
    "  each:run:COMMAND                   a process for each player and the coach\n"
    "  planner:FILE=SIDE                  other parameters of the planner\n"
    "  NAME             a team in cls.toml";

/// Shows the progress of a match, and starts its page when its folder is known.
class WatchedMatch : public ProgressLine {
 public:
  WatchedMatch(bool shown, const MatchArguments& arguments)
      : ProgressLine(shown, arguments.quiet), arguments_(arguments) {}

  void on_folder(const std::filesystem::path& folder, const std::string& game_log) override {
    if (!arguments_.watch && !arguments_.open) return;

    LiveViewOptions options;
    options.open_browser = arguments_.open;
    options.linger_s = arguments_.linger_s;
    options.host_names = arguments_.host_names;
    auto view =
        LiveView::start({viewer::follow_log(folder / game_log, [this] { return over_.load(); }),
                         folder / match::kTextLogFile, folder.filename().string(), folder},
                        options);
    if (!view) return on_warning(view.error().message);
    view_ = *std::move(view);

    // Prints the address also with --quiet: without it the page is of no use.
    clear();
    fmt::print(stderr, "{}", message_line(fmt::format("watch {}", view_->url())));
    if (const std::string hint = tunnel_hint(view_->url()); !hint.empty()) {
      on_notice(fmt::format("from another host: {}", hint));
    }
  }

  /// Serves the page after the match, as long as the options say.
  void serve_the_end(const std::atomic<int>& signal) {
    over_.store(true);
    if (view_ != nullptr) view_->serve(signal);
  }

 private:
  const MatchArguments& arguments_;
  std::atomic<bool> over_{false};
  std::unique_ptr<LiveView> view_;
};

int exit_code_of(const MatchResult& result) {
  const bool unknown = result.end_reason == EndReason::kServerFailed;
  if ((result.valid() || unknown) && !result.write_error.empty()) return kWriteFailed;
  if (result.end_reason == EndReason::kRefused && result.try_again) return kTryAgain;
  if (result.end_reason == EndReason::kInterrupted) return signal_exit_code(result.signal);
  return row_of(result.end_reason).exit_code;
}

// The first error of each Playmaker, which a warning has printed.
std::vector<std::string> warned_errors(const MatchResult& result) {
  std::vector<std::string> texts;
  for (const auto* team : {&result.left, &result.right}) {
    if (team->errors.first && !team->errors.first->message.empty()) {
      texts.push_back(team->errors.first->message);
    }
  }
  return texts;
}

// Says an error that a warning has printed no second time.
void print_end(const MatchResult& result, bool warned) {
  std::string message = result.message;
  for (const std::string& text : warned ? warned_errors(result) : std::vector<std::string>()) {
    if (!message.ends_with(text)) continue;
    message.resize(message.size() - text.size());
    message += "the error above";
  }
  print_error(0, message);
}

// Prints the last output lines of the failed process that say more than the errors of its calls;
// its log has all of them.
void print_last_output(const MatchResult& result) {
  constexpr std::size_t kLines = 5;
  const std::vector<std::string> known = warned_errors(result);
  std::vector<std::string> lines = result.failure->output;
  std::erase_if(lines, [&known](const std::string& line) {
    return std::ranges::any_of(
        known, [&line](const std::string& text) { return line.find(text) != std::string::npos; });
  });
  std::size_t first = lines.size() - std::min(kLines, lines.size());
  // Marks of a compiler or an exception below a line that is not shown.
  while (first < lines.size() && lines[first].find_first_not_of(" ^~") == std::string::npos) {
    ++first;
  }
  for (std::size_t i = first; i < lines.size(); ++i) {
    fmt::print(stderr, "  {}: {}\n", result.failure->process, lines[i]);
  }
}

int print_dry_run(const MatchArguments& arguments) {
  TRY_INIT_OR(kUnavailable, const auto text, match::dry_run(arguments.options));

  if (arguments.json) {
    return print_json({{"schema", "cls.dry-run/1"}, {"script", text}});
  }

  fmt::print("{}", text);
  for (const SettingRow& row : setting_rows(arguments)) {
    if (row.origin == "default") continue;
    fmt::print("# {} = {} ({})\n", row.name, row.value, row.origin);
  }
  return kOk;
}

// After Ctrl-C: what is stored, and how to play the match to its end.
void print_interrupted(const MatchResult& result) {
  print_error(0,
              "interrupted at cycle {}; log and result are in {}/; the same command "
              "with --seed {} plays the match again",
              result.cycles, result.folder, result.seed);
}

// Plays the match; with --on-event events go to the command, too.
base::Result<MatchResult> play(const MatchArguments& arguments, WatchedMatch& progress,
                               const std::atomic<int>& signal, match::MatchHooks* hooks) {
  if (arguments.on_event.empty()) return run_match(arguments.options, progress, signal, hooks);
  const std::chrono::duration<double> limit(arguments.hook_limit_s);
  match::EventCommand events(progress, arguments.on_event,
                             std::chrono::duration_cast<std::chrono::milliseconds>(limit),
                             match::team_names(arguments.options));
  auto result = run_match(arguments.options, events, signal, hooks);
  if (result) events.finish(*result, signal);
  return result;
}

int run_match_command(const Command& command, MatchArguments& arguments) {
  TRY_STEP(resolve_match(command, arguments));
  if ((arguments.watch || arguments.open) && !arguments.options.server.game_logging) {
    return print_error(kUsage,
                       "--watch: the page shows the game log, which server::game_logging "
                       "switches off");
  }

  if (arguments.dry_run) return print_dry_run(arguments);
  // A match without its programs leaves nothing in runs/.
  if (arguments.options.folder.empty()) {
    TRY_OR(kUnavailable, match::dry_run(arguments.options));
  }

  const bool live = stderr_is_terminal() && !arguments.quiet && !arguments.step && !arguments.at;
  WatchedMatch progress(live, arguments);
  const std::atomic<int>& signal = watch_interrupts();
  MatchStepper stepper(arguments.at.value_or(0), STDIN_FILENO, signal);
  const bool steps = arguments.step || arguments.at;
  const auto result = play(arguments, progress, signal, steps ? &stepper : nullptr);
  progress.clear();
  if (!result) return print_error(kCannotCreate, result.error().message);

  if (result->end_reason == EndReason::kInterrupted) {
    print_interrupted(*result);
  } else if (!result->message.empty()) {
    print_end(*result, !arguments.quiet);
  }
  if (result->failure) print_last_output(*result);
  if (!result->write_error.empty()) print_error(0, result->write_error);

  if (arguments.json) {
    fmt::print("{}", to_json(*result));
  } else {
    fmt::print("{}", match_report(*result, stdout_supports_color(), stdout_width()));
  }

  std::fflush(stdout);
  progress.serve_the_end(signal);
  const int exit_code = exit_code_of(*result);
  if (!arguments.strict || exit_code != kOk || result->warnings.empty()) return exit_code;
  return print_error(kFailed, base::counted(result->warnings.size(), "warning") + " (--strict)");
}

}  // namespace

void add_match_command(Command& app) {
  auto [command, arguments] = app.command("match", kMatchDescription, run_match_command);
  command.group = kPlayCommands;
  command.starts_programs = true;
  command.option("LEFT", arguments.left, "SIDE on the left").required();
  command.option("RIGHT", arguments.right, "SIDE on the right").required();
  add_match_options(command, arguments);
}

}  // namespace cls::cli
