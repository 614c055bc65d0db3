// `cls tournament archive DIR`: the logs of all matches in the league's form.
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "base/io/whole_file.h"
#include "base/text/counted.h"
#include "base/text/json.h"
#include "cli/logs/league_logs.h"
#include "cli/logs/output_file.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/log_progress.h"
#include "cli/tournament/tournament_session.h"
#include "gamelog/files/log_files.h"
#include "league/matches/playing.h"
#include "tournament/config/start_times.h"
#include "tournament/report/report_model.h"
#include "tournament/store/folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;
using base::Json;

constexpr const char* kArchiveDescription =
    "write the logs of all matches as the league archives them\n"
    "\n"
    "  cls tournament archive cup               into cup/archive\n"
    "  cls tournament archive cup /media/logs\n"
    "\n"
    "A folder for each stage has 20270715093000-RED_2-vs-BLUE_1.rcg.gz (version 5)\n"
    "and .rcl.gz. Files that are there already are left as they are, so the command\n"
    "may run again and again during the tournament.";

struct ArchiveArguments {
  std::string folder;
  std::string out;
  bool json = false;
};

// "first round/group A" of "first round, group A".
fs::path stage_folder(const Fixture& fixture) {
  std::string text = stage_text(fixture);
  for (char& c : text) {
    if (c == '/') c = '-';
  }
  const std::size_t comma = text.find(", ");
  if (comma == std::string::npos) return text;
  return fs::path(text.substr(0, comma)) / text.substr(comma + 2);
}

constexpr const char* kAnnulledFolder = "annulled";

struct Archive {
  int written = 0;
  int present = 0;
  std::vector<std::string> problems;
  Json files = Json::array();
};

// False when a file cannot be written, or after a signal.
bool write_log_file(const fs::path& file, const std::string& bytes, Archive& archive) {
  const auto failure = write_output(file, [&bytes](base::ByteSink& sink) {
    sink.write(bytes);
    return true;
  });
  if (!failure) return true;
  archive.problems.push_back(failure->message);
  return false;
}

// The logs of a playing, unless its folder or a log in it leads out of the tournament.
base::Result<LeagueLogs> logs_of(const fs::path& folder, const Playing& playing) {
  const fs::path place = folder / playing.folder;
  for (const auto& [game, text] : gamelog::find_logs({place.string()}).matches) {
    for (const std::string& log : {game, text}) {
      if (log.empty() || is_inside(log, folder)) continue;
      return base::Error{fmt::format("{}: a link that leads out of the tournament", log)};
    }
  }
  if (!is_inside(place, folder)) {
    return base::Error{fmt::format("{}: no folder of this tournament", place.string())};
  }
  return read_league_logs(place, parse_utc_time(playing.began));
}

bool add_playing(const fs::path& folder, const Fixture& fixture, const Playing& playing,
                 const fs::path& out, Archive& archive) {
  const auto logs = logs_of(folder, playing);
  if (!logs) {
    archive.problems.push_back(fmt::format("match {}: {}", fixture.index, logs.error().message));
    return true;
  }

  const fs::path root = playing.annulled ? out / kAnnulledFolder : out;
  const fs::path stem = root / stage_folder(fixture) / logs->name;
  const fs::path game = stem.string() + ".rcg.gz";
  const fs::path text = stem.string() + ".rcl.gz";
  archive.files.push_back(
      {{"match", fixture.index}, {"rcg", game.string()}, {"annulled", playing.annulled}});
  archive.files.back()["rcl"] = logs->rcl.empty() ? Json(nullptr) : Json(text.string());
  std::error_code code;
  if (fs::exists(game, code)) {
    ++archive.present;
    return true;
  }

  auto created = base::create_folders(stem.parent_path());
  // Commands that read the archive count no annulled match.
  if (created && playing.annulled) created = gamelog::set_apart(root);
  if (!created) {
    archive.problems.push_back(created.error().message);
    return false;
  }

  // The game log is last: a match is in the archive when its game log is.
  if (!logs->rcl.empty() && !write_log_file(text, logs->rcl, archive)) return false;
  if (!write_log_file(game, logs->rcg, archive)) return false;
  ++archive.written;
  return true;
}

int run_archive(const ArchiveArguments& arguments) {
  TRY_STEP(check_tournament(arguments.folder));
  TRY_INIT_OR(kBadData, const auto state, read_tournament(arguments.folder));
  const bool inside = arguments.out.empty();
  const fs::path out = inside ? fs::path(arguments.folder) / "archive" : fs::path(arguments.out);
  TRY_OR(kCannotCreate, inside ? gamelog::set_apart(out) : base::create_folders(out));

  const std::atomic<int>& signal = watch_interrupts();
  Archive archive;
  LogProgress progress(state.matches.size());
  std::size_t done = 0;
  bool whole = true;
  for (const ScheduledMatch& match : state.matches) {
    progress.update(++done);
    if (signal != 0) return signal_exit_code(signal);
    // A result from a file has no logs.
    const bool from_file = state.config.execution.keep_logs == KeepLogs::kAll;
    const bool played = match.outcome && match.outcome->finished();
    if (played && match.outcome->folder.empty() && !from_file) {
      archive.problems.push_back(
          fmt::format("match {}: its logs were not retained (keep_logs)", match.fixture.index));
    }
    whole = std::ranges::all_of(playings_of(match), [&](const Playing& playing) {
      return add_playing(arguments.folder, match.fixture, playing, out, archive);
    });
    if (!whole) break;
  }

  for (const std::string& problem : archive.problems) {
    if (!problem.empty()) print_error(0, problem);
  }

  if (arguments.json) {
    print_json({{"schema", "cls.archive/1"},
                {"dir", out.string()},
                {"written", archive.written},
                {"present", archive.present},
                {"matches", archive.files},
                {"problems", archive.problems}});
  } else {
    fmt::print("{}: {} written, {} there already\n", out.string(),
               base::counted(archive.written, "match", "matches"), archive.present);
  }

  if (signal != 0) return signal_exit_code(signal);
  if (!whole) return kCannotCreate;

  return archive.problems.empty() ? kOk : kFailed;
}

}  // namespace

void add_tournament_archive_command(Command& app) {
  auto [command, arguments] = app.command("archive", kArchiveDescription, run_archive);
  command.option("DIR", arguments.folder, "folder of the tournament").required();
  command.option("OUT", arguments.out, "folder of the archive (default: DIR/archive)");
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli
