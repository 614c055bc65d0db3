// From options to a folder with logs and a result.
#include "orchestration/match.h"

#include <chrono>
#include <memory>
#include <optional>
#include <random>
#include <utility>

#include "orchestration/lockstep_match.h"
#include "orchestration/match_chronicle.h"
#include "orchestration/match_folder.h"
#include "orchestration/version.h"
#include "orchestration/whole_file.h"

namespace cls::orchestration {
namespace {

namespace fs = std::filesystem;
using soccer::Error;
using soccer::Result;

std::uint64_t drawn_seed() {
  // Short enough to be typed again.
  return std::random_device()();
}

TeamNames names_of(const MatchOptions& options) {
  const auto name = [](const std::string& given, const Endpoint& endpoint) {
    return given.empty() ? default_team_name(endpoint) : given;
  };
  return distinct_names(name(options.left_name, options.left),
                        name(options.right_name, options.right));
}

/// The files that grow while the match runs.
struct Logs {
  std::unique_ptr<gamelog::FileSink> game;
  std::unique_ptr<gamelog::FileSink> text;
  std::unique_ptr<gamelog::FileSink> events;

  /// The first thing that could not be written, empty when all was.
  std::string close() {
    std::string problem;
    for (gamelog::FileSink* sink : {game.get(), text.get(), events.get()}) {
      const auto closed = sink->close();
      if (!closed && problem.empty()) problem = closed.error().message;
    }
    return problem;
  }
};

Result<Logs> open_logs(const fs::path& folder) {
  Logs logs;
  const std::pair<std::unique_ptr<gamelog::FileSink>*, const char*> files[] = {
      {&logs.game, kGameLogFile}, {&logs.text, kTextLogFile}, {&logs.events, kEventsFile}};
  for (const auto& [sink, name] : files) {
    auto opened = gamelog::FileSink::create((folder / name).string());
    if (!opened) return opened.error();
    *sink = std::move(*opened);
  }
  return logs;
}

}  // namespace

Result<MatchResult> run_match(const MatchOptions& options, MatchObserver& observer,
                              const std::atomic<int>& stop_signal) {
  const auto start = std::chrono::steady_clock::now();
  const TeamNames names = names_of(options);
  const std::uint64_t seed = options.seed.value_or(drawn_seed());
  const auto folder = make_match_folder(options, names);
  if (!folder) return folder.error();
  auto logs = open_logs(*folder);
  if (!logs) return logs.error();
  if (const auto written = write_file(*folder / kManifestFile, manifest_json(options, names, seed));
      !written) {
    return written.error();
  }
  std::optional<ProcessHost> host;
  if (options.left.starts_programs() || options.right.starts_programs()) {
    auto created = ProcessHost::create();
    if (!created) return created.error();
    host.emplace(*std::move(created));
  }
  auto match = LockstepMatch::create(options, names, seed, stop_signal, host ? &*host : nullptr,
                                     fs::absolute(*folder));
  if (!match) return match.error();

  EventLog events(*logs->events);
  MatchChronicle chronicle(events);
  (*match)->record(*logs->game, *logs->text);
  chronicle.begin(names, seed);
  (*match)->play(observer, chronicle);

  MatchResult result = (*match)->result();
  result.goals = chronicle.goals();
  chronicle.end(result);
  result.server_version = kVersion;
  result.folder = folder->string();
  result.rcg = kGameLogFile;
  result.rcl = kTextLogFile;
  result.write_error = logs->close();
  result.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto written = write_file(*folder / kResultFile, to_json(result));
  if (!written && result.write_error.empty()) result.write_error = written.error().message;
  return result;
}

}  // namespace cls::orchestration
