// From options to a folder with logs and a result.
#include "orchestration/match/match.h"

#include <chrono>
#include <memory>
#include <optional>
#include <random>
#include <utility>

#include "base/io/whole_file.h"
#include "base/system/version.h"
#include "orchestration/match/hooks/debug_log.h"
#include "orchestration/match/hooks/match_chronicle.h"
#include "orchestration/match/hooks/rpc_recorder.h"
#include "orchestration/match/lockstep_match.h"
#include "orchestration/match/network_match.h"
#include "orchestration/match/result/match_folder.h"

namespace cls::orchestration::match {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

std::uint64_t drawn_seed() {
  // Short enough to be typed again.
  return std::random_device()();
}

/// The files that grow while the match runs.
struct Logs {
  std::unique_ptr<base::FileSink> game;
  std::unique_ptr<base::FileSink> text;
  std::unique_ptr<base::FileSink> events;

  /// The first thing that could not be written, empty when all was.
  std::string close() {
    std::string problem;
    for (base::FileSink* sink : {game.get(), text.get(), events.get()}) {
      const auto closed = sink->close();
      if (!closed && problem.empty()) problem = closed.error().message;
    }
    return problem;
  }
};

Result<Logs> open_logs(const fs::path& folder) {
  Logs logs;
  const std::pair<std::unique_ptr<base::FileSink>*, const char*> files[] = {
      {&logs.game, kGameLogFile}, {&logs.text, kTextLogFile}, {&logs.events, kEventsFile}};
  for (const auto& [sink, name] : files) {
    auto opened = base::FileSink::create((folder / name).string());
    if (!opened) return opened.error();
    *sink = std::move(*opened);
  }
  return logs;
}

/// What every kind of match gets.
struct MatchContext {
  const MatchOptions& options;
  const TeamNames& names;
  std::uint64_t seed;
  const fs::path& folder;
  MatchObserver& observer;
  const std::atomic<int>& stop_signal;
  MatchDirector* director;  ///< null: none
};

recording::RecordingHeader recording_header(const MatchContext& context) {
  recording::RecordingHeader header;
  header.set_seed(context.seed);
  header.set_left_name(context.names.left);
  header.set_right_name(context.names.right);
  header.set_left_endpoint(context.options.left.text);
  header.set_right_endpoint(context.options.right.text);
  return header;
}

Result<MatchResult> play_lockstep(const MatchContext& context, process::ProcessHost* host) {
  auto logs = open_logs(context.folder);
  if (!logs) return logs.error();
  std::unique_ptr<RpcRecorder> recorder;
  if (!context.options.record_rpc.empty()) {
    auto created = RpcRecorder::create(context.options.record_rpc, recording_header(context));
    if (!created) return created.error();
    recorder = *std::move(created);
  }
  auto match = LockstepMatch::create(context.options, context.names, context.seed,
                                     context.stop_signal, host, context.folder);
  if (!match) return match.error();
  DebugLog debug(context.folder);
  (*match)->direct(debug);
  if (recorder != nullptr) (*match)->direct(*recorder);
  if (context.director != nullptr) (*match)->direct(*context.director);
  EventLog events(*logs->events);
  MatchChronicle chronicle(events);
  (*match)->record(*logs->game, *logs->text);
  chronicle.begin(context.names, context.seed);
  (*match)->play(context.observer, chronicle);

  MatchResult result = (*match)->result();
  result.goals = chronicle.goals();
  chronicle.end(result);
  result.server_version = base::kVersion;
  result.rcg = kGameLogFile;
  result.rcl = kTextLogFile;
  result.write_error = logs->close();
  for (const std::string& problem :
       {debug.close(), recorder == nullptr ? std::string() : recorder->close()}) {
    if (result.write_error.empty()) result.write_error = problem;
  }
  return result;
}

// A match that could not even be begun.
MatchResult refused(const MatchContext& context, const std::string& message) {
  MatchResult result;
  result.left.name = context.names.left;
  result.left.endpoint = context.options.left.text;
  result.right.name = context.names.right;
  result.right.endpoint = context.options.right.text;
  result.end_reason = EndReason::kRefused;
  result.message = message;
  result.seed = context.seed;
  result.mode = name(mode_of(context.options));
  result.server_kind = context.options.server_choice.text;
  return result;
}

Result<MatchResult> play_network(const MatchContext& context, process::ProcessHost& host) {
  auto file = base::FileSink::create((context.folder / kEventsFile).string());
  if (!file) return file.error();
  for (const char* old : {kGameLogFile, kTextLogFile}) {
    std::error_code code;
    fs::remove(context.folder / old, code);
  }
  EventLog events(**file);
  auto match = NetworkMatch::create(context.options, context.names, context.seed,
                                    context.stop_signal, host, context.folder);
  if (!match) return refused(context, match.error().message);
  (*match)->play(context.observer);
  MatchResult result = (*match)->result(context.observer);
  (*match)->write_events(events, result);
  if (const auto closed = (*file)->close(); !closed) result.write_error = closed.error().message;
  return result;
}

Result<MatchResult> play(const MatchContext& context) {
  const bool lockstep = mode_of(context.options) == MatchMode::kLockstep;
  const std::optional<Endpoint>& trainer = context.options.trainer;
  const bool alone = lockstep && !context.options.left.starts_programs() &&
                     !context.options.right.starts_programs() &&
                     !(trainer && trainer->starts_programs());
  if (alone) return play_lockstep(context, nullptr);
  auto host = process::ProcessHost::create();
  if (!host) return host.error();
  return lockstep ? play_lockstep(context, &*host) : play_network(context, *host);
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
                              const std::atomic<int>& stop_signal, MatchDirector* director) {
  const auto start = std::chrono::steady_clock::now();
  const TeamNames names = team_names(options);
  const std::uint64_t seed = options.seed.value_or(drawn_seed());
  const auto folder = make_match_folder(options, names);
  if (!folder) return folder.error();
  if (const auto written =
          base::write_file(*folder / kManifestFile, manifest_json(options, names, seed));
      !written) {
    return written.error();
  }
  const fs::path whole = fs::absolute(*folder);
  auto result = play({options, names, seed, whole, observer, stop_signal, director});
  if (!result) return result;
  result->folder = folder->string();
  result->wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto written = base::write_file(*folder / kResultFile, to_json(*result));
  if (!written && result->write_error.empty()) result->write_error = written.error().message;
  return result;
}

}  // namespace cls::orchestration::match
