// From options to a folder with logs and a result.
#include "match/run_match.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "base/io/disk_space.h"
#include "base/io/whole_file.h"
#include "base/system/host.h"
#include "match/hooks/choice_recorder.h"
#include "match/hooks/debug_action_log.h"
#include "match/hooks/debug_clients.h"
#include "match/hooks/match_saver.h"
#include "match/hooks/missed_log.h"
#include "match/hooks/rpc_recorder.h"
#include "match/hooks/situation_run.h"
#include "match/hooks/world_model_recorder.h"
#include "match/match_setup.h"
#include "match/programs/team_folder.h"
#include "match/programs/team_sandbox.h"
#include "match/result/late_warnings.h"
#include "match/result/match_folder.h"
#include "match/server/match_logs.h"
#include "match/server/match_plan.h"
#include "match/terms/match_settings.h"
#include "process/ports.h"
#include "soccer/per_side.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;
using base::Result;
using FileSink = std::unique_ptr<base::FileSink>;

constexpr std::uint64_t kSpaceOfDocuments = std::uint64_t{2} << 20;

// Short enough to be typed.
std::uint64_t random_seed() { return std::random_device()(); }

/// Keeps the first of several errors.
class FirstError {
 public:
  void add(const std::string& error) {
    if (text_.empty()) text_ = error;
  }
  void add(const Result<void>& done) {
    if (!done) add(done.error().message);
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

using FolderHook = std::unique_ptr<FolderHooks>;
using FolderHookList = std::vector<FolderHook>;

// A hook that is made without errors.
template <FolderHook (*make)(const MatchSetup&)>
Result<FolderHook> wanted(const MatchSetup& setup) {
  return make(setup);
}

FolderHook debug_actions(const MatchSetup& setup) {
  return std::make_unique<DebugActionLog>(setup.folder);
}

FolderHook missed_log(const MatchSetup& setup) { return std::make_unique<MissedLog>(setup.folder); }

FolderHook resume_check(const MatchSetup& setup) {
  if (setup.options.resumed == nullptr) return nullptr;
  return std::make_unique<ResumeCheck>(setup.options.resumed);
}

FolderHook match_saver(const MatchSetup& setup) {
  const MatchOptions& options = setup.options;
  if (!options.save_at) return nullptr;
  return std::make_unique<MatchSaver>(options.save_file, *options.save_at,
                                      describe_match(options, setup.seed, setup.names));
}

FolderHook world_model_recorder(const MatchSetup& setup) {
  if (!setup.options.record_world_models) return nullptr;
  return std::make_unique<WorldModelRecorder>(setup.folder, setup.names);
}

FolderHook choice_recorder(const MatchSetup& setup) {
  if (!setup.options.record_choices) return nullptr;
  return std::make_unique<ChoiceRecorder>(setup.folder);
}

FolderHook situation_run(const MatchSetup& setup) {
  const MatchOptions& options = setup.options;
  if (options.loaded_book == nullptr) return nullptr;
  return std::make_unique<SituationRun>(*options.loaded_book, setup.seed, options.situations,
                                        situation_cycles(options));
}

FolderHook debug_clients(const MatchSetup& setup) {
  if (!setup.options.debug.wanted()) return nullptr;
  return std::make_unique<DebugClients>(setup.options.debug);
}

Result<FolderHook> rpc_recorder(const MatchSetup& setup) {
  if (setup.options.record_rpc.empty()) return FolderHook();
  TRY_INIT(auto recorder, RpcRecorder::create(setup.options.record_rpc, recording_header(setup)));
  return FolderHook(std::move(recorder));
}

/// In the order of their calls; null: not wanted.
constexpr std::array<Result<FolderHook> (*)(const MatchSetup&), 9> kFolderHooks = {
    wanted<situation_run>,        wanted<debug_actions>,   wanted<missed_log>,
    wanted<resume_check>,         wanted<match_saver>,     rpc_recorder,
    wanted<world_model_recorder>, wanted<choice_recorder>, wanted<debug_clients>};

/// Those that the options ask for.
Result<FolderHookList> make_hooks(const MatchSetup& setup) {
  FolderHookList all;
  for (const auto& make : kFolderHooks) {
    TRY_INIT(auto hook, make(setup));
    if (hook != nullptr) all.push_back(std::move(hook));
  }
  return all;
}

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
  std::vector<std::string> late = missed_cycle_warnings(result);
  for (const auto& lines : {action_warnings(result.left), action_warnings(result.right),
                            output_warnings(result, folder)}) {
    late.insert(late.end(), lines.begin(), lines.end());
  }
  for (const std::string& line : late) {
    observer.on_warning(line);
    result.warnings.push_back(line);
  }
}

// Plays with all hooks; the sides are gone when this returns.
MatchResult play(const MatchSetup& setup, std::unique_ptr<Match> match, const FolderHookList& files,
                 MatchHooks* hooks, MatchObserver& observer) {
  for (const FolderHook& hook : files) match->add_hooks(*hook);
  if (hooks != nullptr) match->add_hooks(*hooks);

  base::KeptSpace for_documents;
  if (has_external_team(setup.options)) for_documents = {setup.folder, kSpaceOfDocuments};
  match->play(observer);
  for_documents.release();

  MatchResult result = match->result();
  FirstError problem;
  for (const FolderHook& hook : files) {
    hook->add_result(result);
    problem.add(hook->problem());
  }
  if (!problem.text().empty()) {
    result.end_reason = EndReason::kRefused;
    result.message = problem.text();
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

// The side whose start script cannot be run, where no program of the other side could take that
// away: a team must not void its matches so.
std::optional<soccer::Side> side_without_program(const MatchSetup& setup) {
  std::optional<soccer::Side> found;
  for (const soccer::Side side : soccer::kBothSides) {
    const Endpoint& endpoint = endpoint_of(setup.options, side);
    if (endpoint.kind != Endpoint::Kind::kTeam) continue;
    const TeamValues values =
        team_values(setup.options, setup.names, side, kLoopback, {}, setup.folder);
    if (team_plan(endpoint, values)) continue;
    if (found) return std::nullopt;
    found = side;
  }
  if (!found) return found;

  const soccer::Side other = soccer::opponent(*found);
  const bool out_of_reach =
      !endpoint_of(setup.options, other).starts_programs() || has_namespaces(setup.options, other);
  return out_of_reach ? found : std::nullopt;
}

// A match whose programs, server or sides are not as its options say.
MatchResult refused_by_setup(const MatchSetup& setup, std::string message, bool try_again) {
  MatchResult result = refused(setup, std::move(message), try_again);
  result.fault = side_without_program(setup);
  return result;
}

// Closes the files of a match whose logs are `complete`; the first error becomes that of the
// result.
void close_files(const Result<void>& complete, base::FileSink& events, const FolderHookList& files,
                 MatchResult& result) {
  FirstError error;
  error.add(complete);
  error.add(events.close());
  for (const FolderHook& hook : files) error.add(hook->close());
  error.add(result.write_error);
  result.write_error = error.text();
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
  const auto needs = [&](soccer::Side side) {
    return !endpoint_of(setup.options, side).has_playmaker() &&
           !has_namespaces(setup.options, side);
  };
  return std::ranges::any_of(soccer::kBothSides, needs) &&
         !process::taken_port(process::Protocol::kUdp, {ServerPorts().player}).empty();
}

Result<MatchResult> play_lockstep(const MatchSetup& setup, MatchHooks* hooks,
                                  MatchObserver& observer) {
  TRY_INIT(auto logs,
           MatchLogs::create(setup.folder, setup.options.server, has_external_team(setup.options)));
  TRY_INIT(const auto event_file, create_file(setup, kEventsFile));
  TRY_INIT(auto files, make_hooks(setup));

  EventRecorder events(*event_file);
  auto match = make_lockstep_match(setup, {logs.game(), logs.text(), &events});
  events.start(setup.names, setup.seed);
  MatchResult result =
      match ? play(setup, *std::move(match), files, hooks, observer)
            : refused_by_setup(setup, match.error().message, stock_port_is_taken(setup));
  events.end(result);

  close_files(logs.close(result), *event_file, files, result);
  if (result.steps == 0) remove_logs(setup.folder, result);
  return result;
}

Result<MatchResult> play_over_udp(const MatchSetup& setup, MatchHooks* hooks,
                                  MatchObserver& observer) {
  TRY_INIT(const auto event_file, create_file(setup, kEventsFile));
  TRY_INIT(auto files, make_hooks(setup));

  MatchResult result;
  auto plan = plan_match(setup.options, setup.names, setup.seed, setup.folder);
  if (!plan) return refused_by_setup(setup, plan.error().message, false);
  if (const std::string in_use = port_in_use(*plan); !in_use.empty()) {
    result = refused(setup, in_use, true);
  } else {
    auto match = make_external_match(setup, *std::move(plan));
    result = match ? play(setup, *std::move(match), files, hooks, observer)
                   : refused(setup, match.error().message, false);
  }
  result.deterministic = false;

  EventRecorder events(*event_file);
  write_events(events, setup.folder, result);
  const auto converted = convert_server_logs(setup.folder, setup.options.server, result);
  close_files(converted, *event_file, files, result);
  return result;
}

// Why nothing of the match could connect to anything; empty: it needs no network, or has one.
std::string network_problem(const MatchOptions& options) {
  const bool over_udp = mode_of(options) != MatchMode::kLockstep || has_external_team(options);
  const bool in_process = !over_udp && options.left.is_built_in() && options.right.is_built_in();
  return in_process ? std::string() : process::loopback_problem(over_udp);
}

Result<MatchResult> play_match(const MatchSetup& setup, MatchHooks* hooks,
                               MatchObserver& observer) {
  const std::string problem = network_problem(setup.options);
  if (!problem.empty()) return refused(setup, problem, false);
  if (std::string why = refused_without_namespaces(setup.options); !why.empty()) {
    return refused(setup, std::move(why), false);
  }
  return mode_of(setup.options) == MatchMode::kLockstep ? play_lockstep(setup, hooks, observer)
                                                        : play_over_udp(setup, hooks, observer);
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
  return distinct_names(name(options.names.left, options.left),
                        name(options.names.right, options.right));
}

namespace {

// Manifest and result, of a match that is over.
void write_documents(const MatchSetup& setup, const fs::path& folder, ManifestTimes times,
                     MatchResult& result) {
  times.ended = base::utc_now();
  times.server_version = result.server_version;
  for (const auto& [file, text] :
       {std::pair(kManifestFile, manifest_json(setup.options, setup.names, setup.seed, times)),
        std::pair(kResultFile, to_json(result))}) {
    const auto written = base::write_file_durably(folder / file, text);
    if (!written && result.write_error.empty()) result.write_error = written.error().message;
  }
}

}  // namespace

Result<MatchResult> run_match(const MatchOptions& options, MatchObserver& observer,
                              const std::atomic<int>& stop_signal, MatchHooks* hooks) {
  const auto start = std::chrono::steady_clock::now();
  const TeamNames names = team_names(options);
  const std::uint64_t seed = options.seed.value_or(random_seed());
  const ManifestTimes times = {.started = base::utc_now()};
  TRY_INIT(const auto folder, make_match_folder(options, names));
  TRY(base::write_file(folder / kManifestFile, manifest_json(options, names, seed, times)));

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

  auto result = play_match(setup, hooks, observer);
  if (!result) return result;

  result->folder = folder.string();
  result->warnings.insert(result->warnings.begin(), warnings.begin(), warnings.end());
  add_late_warnings(folder, *result, observer);
  result->wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  // For tournaments, which read only the document.
  if (!result->write_error.empty()) result->warnings.push_back(result->write_error);
  write_documents(setup, folder, times, *result);
  return result;
}

}  // namespace cls::match
