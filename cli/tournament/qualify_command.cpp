// `cls qualify TEAM OPPONENT...`: plays and packs the logs with which a team qualifies.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/io/tar.h"
#include "base/io/whole_file.h"
#include "base/text/counted.h"
#include "base/text/json_text.h"
#include "cli/logs/league_logs.h"
#include "cli/logs/output_file.h"
#include "cli/support/commands.h"
#include "cli/support/exit_code.h"
#include "cli/support/print_error.h"
#include "cli/tournament/tournament_run.h"
#include "match/terms/endpoint.h"
#include "tournament/config/config_file.h"
#include "tournament/config/config_keys.h"
#include "tournament/config/start_times.h"
#include "tournament/store/folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;

constexpr const char* kDescription =
    "play the matches of a qualification and pack their logs for the league\n"
    "\n"
    "  cls qualify team:mine team:opponents/helios team:opponents/cyrus\n"
    "  cls qualify team:mine team:helios team:cyrus --out MINE_logs.tar.gz\n"
    "\n"
    "A match against each opponent, ten cycles a second as the league plays. The\n"
    "archive has both logs of each match, the game log in version 5, under the names\n"
    "of the soccer server. After an interruption the same command resumes.";

constexpr int kFullTime = 6000;  // cycles of a match of the league
constexpr std::string_view kArchiveEnding = ".tar.gz";

struct Arguments {
  std::string team;
  std::vector<std::string> opponents;
  std::string folder = "qualification";
  std::string out;
  std::string mode = "realtime";
  int half_time = 300;
  bool json = false;
};

// Equal names of folders get a number.
std::vector<TeamEntry> team_entries(const Arguments& arguments, std::string& error) {
  std::vector<std::string> sides = arguments.opponents;
  sides.insert(sides.begin(), arguments.team);
  std::vector<TeamEntry> teams;
  std::set<std::string> names;
  for (const std::string& side : sides) {
    const auto endpoint = match::parse_endpoint(side);
    if (!endpoint) {
      error = endpoint.error().message;
      return {};
    }
    const std::string stem = match::default_team_name(*endpoint);
    std::string name = stem;
    for (int number = 2; !names.insert(name).second; ++number) {
      name = fmt::format("{}{}", stem.substr(0, 12), number);
    }
    teams.push_back({name, side});
  }
  return teams;
}

std::string config_text(const Arguments& arguments, const std::vector<TeamEntry>& teams) {
  std::error_code code;
  std::string text = fmt::format(
      "# Matches of a qualification, written by `cls qualify`.\n"
      "schema = 1\n\n[tournament]\nname = {}\nformat = \"gauntlet\"\ngauntlet = [{}]\n"
      "swap_sides = false\nmode = {}\nconcurrency = 1\nfolder = {}\n\n"
      "[server]\nhalf_time = {}\ngame_log_version = 5\n",
      toml_quoted("Qualification of " + teams.front().name), toml_quoted(teams.front().name),
      toml_quoted(arguments.mode), toml_quoted(fs::current_path(code).string()),
      arguments.half_time);
  for (const TeamEntry& team : teams) {
    text += fmt::format("\n[teams.{}]\nendpoint = {}\n", toml_quoted(team.name),
                        toml_quoted(team.endpoint));
  }
  return text;
}

// Writes cls.toml. That of matches that have begun must be the same: then the command resumes.
int write_config(const fs::path& folder, const std::string& text) {
  const fs::path file = folder / kConfigFile;
  std::error_code code;
  if (const auto before = base::read_file(file); before && fs::exists(folder / kStoreFile, code)) {
    if (*before == text) return kOk;
    return print_error(
        kCannotCreate,
        fmt::format("{}: other teams or settings; --dir names another folder", file.string()));
  }
  if (const auto created = base::create_folders(folder); !created) {
    return print_error(kCannotCreate, created.error().message);
  }
  const auto written = base::write_file(file, text);
  return written ? kOk : print_error(kCannotCreate, written.error().message);
}

struct Packed {
  LeagueLogs logs;
  std::time_t start = 0;
};

// Prints the error and returns an exit code.
int read_matches(const fs::path& folder, int cycles, std::vector<Packed>& packed) {
  const auto state = read_tournament(folder);
  if (!state) return print_error(kBadData, state.error().message);
  for (const ScheduledMatch& match : state->matches) {
    if (!match.outcome || !match.outcome->played()) {
      return print_error(kFailed, fmt::format("match {} was not played", match.fixture.index));
    }
    const std::time_t start = parse_utc_time(match.outcome->started);
    auto logs = read_league_logs(folder / match.outcome->folder, start);
    if (!logs) return print_error(kBadData, logs.error().message);
    if (logs->rcl.empty()) {
      return print_error(kBadData, fmt::format("match {} has no text log", match.fixture.index));
    }
    if (logs->last_cycle < cycles) {
      return print_error(kBadData, fmt::format("match {} ends at cycle {} of {}",
                                               match.fixture.index, logs->last_cycle, cycles));
    }
    packed.push_back({*std::move(logs), start});
  }
  return kOk;
}

int write_archive(const fs::path& out, const std::string& top, const std::vector<Packed>& packed) {
  std::string problem;
  const auto failure = write_output(out, [&](base::ByteSink& sink) {
    for (const Packed& one : packed) {
      for (const auto& [ending, bytes] :
           {std::pair(".rcg", &one.logs.rcg), std::pair(".rcl", &one.logs.rcl)}) {
        const auto added =
            base::append_to_tar(top + "/" + one.logs.name + ending, *bytes, one.start, sink);
        if (added) continue;
        problem = added.error().message;
        return false;
      }
    }
    base::end_tar(sink);
    return true;
  });
  if (!problem.empty()) return print_error(kCannotCreate, problem);
  return report_failure(failure);
}

// "MINE_logs" of "out/MINE_logs.tar.gz".
std::string stem_of(const fs::path& out) {
  std::string stem = out.filename().string();
  stem.resize(stem.size() - kArchiveEnding.size());
  return stem;
}

int run(const Arguments& arguments) {
  std::string error;
  const std::vector<TeamEntry> teams = team_entries(arguments, error);
  if (!error.empty()) return print_error(kUsage, error);
  const fs::path out = arguments.out.empty() ? fs::path(teams.front().name + "_logs.tar.gz")
                                             : fs::path(arguments.out);
  if (!out.string().ends_with(kArchiveEnding)) {
    return print_error(kUsage,
                       fmt::format("--out '{}': must end in {}", out.string(), kArchiveEnding));
  }
  if (const int code = write_config(arguments.folder, config_text(arguments, teams)); code != kOk) {
    return code;
  }
  if (const int code = play_tournament(arguments.folder, arguments.json); code != kOk) return code;

  std::vector<Packed> packed;
  const int cycles = arguments.half_time * 20;
  if (const int code = read_matches(arguments.folder, cycles, packed); code != kOk) return code;
  if (const int code = write_archive(out, stem_of(out), packed); code != kOk) return code;

  std::vector<std::string> files;
  for (const Packed& one : packed) files.push_back(one.logs.name);
  const bool whole = cycles >= kFullTime;
  if (!whole) {
    print_error(
        0, fmt::format("warning: {} cycles a match; the league asks for whole matches", cycles));
  }
  if (arguments.json) {
    const nlohmann::ordered_json document = {{"schema", "cls.qualify/1"},
                                             {"archive", out.string()},
                                             {"whole_matches", whole},
                                             {"matches", files}};
    fmt::print("{}", base::json_document(document));
    return kOk;
  }
  fmt::print("{}: {}\n", out.string(), base::counted(files.size(), "match", "matches"));
  for (const std::string& file : files) fmt::print("  {}.rcg, .rcl\n", file);
  return kOk;
}

}  // namespace

void add_qualify_command(Command& app) {
  const auto arguments = std::make_shared<Arguments>();
  Command& command = app.command("qualify", kDescription);
  command.group = kPlayCommands;
  command.starts_programs = true;
  command.option("TEAM", arguments->team, "the SIDE that qualifies").required();
  command.option("OPPONENT", arguments->opponents, "SIDEs to play against").required();
  command.option("--out", arguments->out, "the archive (default: TEAM_logs.tar.gz)");
  command.option("--dir", arguments->folder, "folder of the matches").shows_default();
  command.option("--mode", arguments->mode, "realtime, synch or lockstep")
      .shows_default()
      .one_of({"realtime", "synch", "lockstep"});
  command.option("--half-time", arguments->half_time, "seconds of a half").above(0).shows_default();
  command.flag("--json", arguments->json, "print one JSON document");
  command.run = [arguments] { return run(*arguments); };
}

}  // namespace cls::cli
