// From options to a folder with logs and a result.
#include "match/run_match.h"

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "base/io/whole_file.h"
#include "base/system/host.h"
#include "match/hooks/debug_clients.h"
#include "match/hooks/debug_log.h"
#include "match/hooks/error_recording.h"
#include "match/hooks/match_saver.h"
#include "match/hooks/missed_log.h"
#include "match/hooks/rpc_recorder.h"
#include "match/hooks/situation_run.h"
#include "match/hooks/world_model_recorder.h"
#include "match/match_setup.h"
#include "match/programs/team_sandbox.h"
#include "match/result/late_warnings.h"
#include "match/result/match_folder.h"
#include "match/server/match_logs.h"
#include "match/terms/match_settings.h"
#include "process/ports.h"
#include "soccer/per_side.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;
using base::Result;
using FileSink = std::unique_ptr<base::FileSink>;

// Short enough to be typed.
std::uint64_t random_seed() { return std::random_device()(); }

/// Keeps the first of several errors.
class FirstError {
 public:
  void add(const std::string& error) {
    if (text_.empty()) text_ = error;
  }
  void close(base::FileSink& sink) {
    if (const auto closed = sink.close(); !closed) add(closed.error().message);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

recording::RecordingHeader recording_header(const MatchSetup& setup) {
  recording::RecordingHeader header;
  header.set_seed(setup.seed);
  header.set_left_name(setup.names.left);
  header.set_right_name(setup.names.right);
  header.set_left_endpoint(setup.options.left.text);
  header.set_right_endpoint(setup.options.right.text);
  return header;
}

/// A hook that a match has for its folder, with what it says at the end.
struct FileHook {
  std::unique_ptr<MatchHooks> hooks;               ///< null: not wanted
  std::function<std::string()> close = nothing;    ///< why a file is not complete, or nothing
  std::function<std::string()> problem = nothing;  ///< why the match is refused, or nothing
  std::function<void(MatchResult&)> add_result = [](MatchResult&) {};

  static std::string nothing() { return {}; }
};

template <typename Hook>
FileHook closed_at_end(std::unique_ptr<Hook> hook) {
  Hook* closed = hook.get();
  return {.hooks = std::move(hook), .close = [closed] { return closed->close(); }};
}

Result<FileHook> debug_log(const MatchSetup& setup) {
  return closed_at_end(std::make_unique<DebugLog>(setup.folder));
}

Result<FileHook> missed_log(const MatchSetup& setup) {
  return closed_at_end(std::make_unique<MissedLog>(setup.folder));
}

Result<FileHook> resume_check(const MatchSetup& setup) {
  if (setup.options.resumed == nullptr) return FileHook{};
  auto check = std::make_unique<ResumeCheck>(setup.options.resumed);
  const ResumeCheck* resumed = check.get();
  return FileHook{.hooks = std::move(check), .problem = [resumed] { return resumed->problem(); }};
}

Result<FileHook> match_saver(const MatchSetup& setup) {
  const MatchOptions& options = setup.options;
  if (!options.save_at) return FileHook{};
  return closed_at_end(std::make_unique<MatchSaver>(
      options.save_file, *options.save_at,
      describe_match(options, setup.seed, setup.names.left, setup.names.right)));
}

Result<FileHook> rpc_recorder(const MatchSetup& setup) {
  if (setup.options.record_rpc.empty()) return FileHook{};
  TRY_INIT(auto recorder, RpcRecorder::create(setup.options.record_rpc, recording_header(setup)));
  return closed_at_end(std::move(recorder));
}

Result<FileHook> world_model_recorder(const MatchSetup& setup) {
  if (!setup.options.record_world_models) return FileHook{};
  return closed_at_end(
      std::make_unique<WorldModelRecorder>(setup.folder, setup.names.left, setup.names.right));
}

Result<FileHook> situation_run(const MatchSetup& setup) {
  const MatchOptions& options = setup.options;
  if (options.loaded_book == nullptr) return FileHook{};
  auto run = std::make_unique<SituationRun>(*options.loaded_book, setup.seed, options.situations,
                                            situation_cycles(options));
  const SituationRun* played = run.get();
  return FileHook{.hooks = std::move(run),
                  .add_result = [played](MatchResult& result) { result.book = played->result(); }};
}

Result<FileHook> debug_clients(const MatchSetup& setup) {
  if (!setup.options.debug.wanted()) return FileHook{};
  return closed_at_end(std::make_unique<DebugClients>(setup.options.debug));
}

/// In the order of their calls.
constexpr std::array kFileHooks = {situation_run,        debug_log,    missed_log,
                                   resume_check,         match_saver,  rpc_recorder,
                                   world_model_recorder, debug_clients};

/// Those that the options ask for.
class FileHooks {
 public:
  static Result<FileHooks> create(const MatchSetup& setup) {
    FileHooks all;
    for (const auto& make : kFileHooks) {
      TRY_INIT(auto hook, make(setup));
      if (hook.hooks != nullptr) all.hooks_.push_back(std::move(hook));
    }
    return all;
  }

  void add_to(Match& match) {
    for (const FileHook& hook : hooks_) match.add_hooks(*hook.hooks);
  }
  /// Why the match is refused, or an empty string.
  std::string problem() const {
    FirstError first;
    for (const FileHook& hook : hooks_) first.add(hook.problem());
    return first.text();
  }
  void add_results(MatchResult& result) const {
    for (const FileHook& hook : hooks_) hook.add_result(result);
  }
  void close(FirstError& error) {
    for (const FileHook& hook : hooks_) error.add(hook.close());
  }

 private:
  std::vector<FileHook> hooks_;
};

constexpr soccer::PerSide<const char*> kErrorFiles = {kLeftErrorFile, kRightErrorFile};

// Saves the first failed call of each side.
void record_errors(const MatchSetup& setup, const Match& match, MatchResult& result) {
  for (const auto& side : match.sides()) {
    const soccer::Side which = side->identity().side;
    const proxy::PlaymakerErrors* errors = side->errors();
    if (errors == nullptr || !errors->first || which == soccer::Side::kNeutral) continue;
    if (errors->first->calls.empty()) continue;
    const char* file = kErrorFiles[which];
    const auto written =
        write_error_recording(setup.folder / file, recording_header(setup), which, *errors->first);
    if (written) result.team(which).errors.first->recording = file;
    if (!written && result.write_error.empty()) result.write_error = written.error().message;
  }
}

// Adds what only the whole match shows.
void add_late_warnings(const fs::path& folder, MatchResult& result, MatchObserver& observer) {
  std::vector<std::string> late = action_warnings(result.left);
  for (const auto& lines : {action_warnings(result.right), output_warnings(result, folder)}) {
    late.insert(late.end(), lines.begin(), lines.end());
  }
  for (const std::string& line : late) {
    observer.on_warning(line);
    result.warnings.push_back(line);
  }
}

// Plays with all hooks; the sides are gone when this returns.
MatchResult play(const MatchSetup& setup, std::unique_ptr<Match> match, FileHooks& files,
                 MatchHooks* hooks, MatchObserver& observer) {
  files.add_to(*match);
  if (hooks != nullptr) match->add_hooks(*hooks);
  match->play(observer);
  MatchResult result = match->result();
  files.add_results(result);
  if (std::string problem = files.problem(); !problem.empty()) {
    result.end_reason = EndReason::kRefused;
    result.message = std::move(problem);
  }
  record_errors(setup, *match, result);
  return result;
}

Result<FileSink> create_file(const MatchSetup& setup, const char* name) {
  return base::FileSink::create((setup.folder / name).string());
}

// A match that could not be set up.
MatchResult refused(const MatchSetup& setup, std::string message, bool try_again) {
  MatchResult result;
  result.end_reason = EndReason::kRefused;
  result.message = std::move(message);
  result.try_again = try_again;
  result.seed = setup.seed;
  result.mode = name(mode_of(setup.options));
  result.server_kind = setup.options.server_choice.text;
  result.left.name = setup.names.left;
  result.left.endpoint = setup.options.left.text;
  result.right.name = setup.names.right;
  result.right.endpoint = setup.options.right.text;
  return result;
}

// A match without a cycle has no logs.
void remove_logs(const fs::path& folder, MatchResult& result) {
  for (std::string* log : {&result.rcg, &result.rcl}) {
    std::error_code code;
    if (!log->empty()) fs::remove(folder / *log, code);
    log->clear();
  }
}

// The one fixed port that a match in lockstep may need.
bool stock_port_is_taken(const MatchSetup& setup) {
  const bool external = !setup.options.left.has_playmaker() || !setup.options.right.has_playmaker();
  return external && !process::taken_port(process::Protocol::kUdp, {ServerPorts().player}).empty();
}

Result<MatchResult> play_lockstep(const MatchSetup& setup, MatchHooks* hooks,
                                  MatchObserver& observer) {
  TRY_INIT(auto logs, MatchLogs::create(setup.folder, setup.options.server));
  TRY_INIT(const auto event_file, create_file(setup, kEventsFile));
  TRY_INIT(auto files, FileHooks::create(setup));
  EventRecorder events(*event_file);
  auto match = make_lockstep_match(setup, {logs.game(), logs.text(), &events});
  events.start(setup.names, setup.seed);
  MatchResult result = match ? play(setup, *std::move(match), files, hooks, observer)
                             : refused(setup, match.error().message, stock_port_is_taken(setup));
  events.end(result);
  FirstError error;
  if (const auto closed = logs.close(result); !closed) error.add(closed.error().message);
  error.close(*event_file);
  files.close(error);
  error.add(result.write_error);
  result.write_error = error.text();
  if (result.steps == 0) remove_logs(setup.folder, result);
  return result;
}

Result<MatchResult> play_over_udp(const MatchSetup& setup, MatchHooks* hooks,
                                  MatchObserver& observer) {
  TRY_INIT(const auto event_file, create_file(setup, kEventsFile));
  TRY_INIT(auto files, FileHooks::create(setup));
  FirstError error;
  MatchResult result;
  EventRecorder events(*event_file);
  auto plan = plan_match(setup.options, setup.names, setup.seed, setup.folder);
  if (!plan) return refused(setup, plan.error().message, false);
  if (const std::string in_use = port_in_use(*plan); !in_use.empty()) {
    result = refused(setup, in_use, true);
  } else {
    auto match = make_external_match(setup, *std::move(plan));
    result = match ? play(setup, *std::move(match), files, hooks, observer)
                   : refused(setup, match.error().message, false);
  }
  result.deterministic = false;
  write_events(events, setup.folder, result);
  const auto converted = convert_server_logs(setup.folder, setup.options.server, result);
  if (!converted) error.add(converted.error().message);
  error.close(*event_file);
  files.close(error);
  error.add(result.write_error);
  result.write_error = error.text();
  return result;
}

bool starts_programs(const MatchOptions& options) {
  return mode_of(options) != MatchMode::kLockstep || options.left.starts_programs() ||
         options.right.starts_programs() || (options.trainer && options.trainer->starts_programs());
}

}  // namespace

TeamNames team_names(const MatchOptions& options) {
  const auto name = [](const std::string& given, const Endpoint& endpoint) {
    return given.empty() ? default_team_name(endpoint) : given;
  };
  return distinct_names(name(options.left_name, options.left),
                        name(options.right_name, options.right));
}

Result<MatchResult> run_match(const MatchOptions& options, MatchObserver& observer,
                              const std::atomic<int>& stop_signal, MatchHooks* hooks) {
  const auto start = std::chrono::steady_clock::now();
  const TeamNames names = team_names(options);
  const std::uint64_t seed = options.seed.value_or(random_seed());
  ManifestTimes times;
  times.started = base::utc_now();
  TRY_INIT(const auto folder, make_match_folder(options, names));
  if (const auto written =
          base::write_file(folder / kManifestFile, manifest_json(options, names, seed, times));
      !written) {
    return written.error();
  }
  std::optional<process::ProcessHost> host;
  if (starts_programs(options)) {
    TRY_INIT(auto created, process::ProcessHost::create());
    host.emplace(std::move(created));
  }
  const MatchSetup setup{
      options, names, seed, stop_signal, host ? &*host : nullptr, fs::absolute(folder)};
  std::vector<std::string> warnings = settings_without_effect(options);
  for (std::string& line : sandbox_warnings(options, folder)) warnings.push_back(std::move(line));
  for (const std::string& warning : warnings) observer.on_warning(warning);
  observer.on_folder(setup.folder, running_game_log(options));
  auto result = mode_of(options) == MatchMode::kLockstep ? play_lockstep(setup, hooks, observer)
                                                         : play_over_udp(setup, hooks, observer);
  if (!result) return result;
  result->folder = folder.string();
  result->warnings.insert(result->warnings.begin(), warnings.begin(), warnings.end());
  add_late_warnings(folder, *result, observer);
  result->wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  // For tournaments, which read only the document.
  if (!result->write_error.empty()) result->warnings.push_back(result->write_error);
  times.ended = base::utc_now();
  times.server_version = result->server_version;
  for (const auto& [file, text] :
       {std::pair(kManifestFile, manifest_json(options, names, seed, times)),
        std::pair(kResultFile, to_json(*result))}) {
    const auto written = base::write_file_durably(folder / file, text);
    if (!written && result->write_error.empty()) result->write_error = written.error().message;
  }
  return result;
}

}  // namespace cls::match
