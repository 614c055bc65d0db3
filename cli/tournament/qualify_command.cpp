// `cls qualify TEAM OPPONENT...`: plays and packs the logs with which a team qualifies.
#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/io/tar.h"
#include "base/io/whole_file.h"
#include "base/text/counted.h"
#include "base/text/json.h"
#include "cli/logs/league_logs.h"
#include "cli/logs/output_file.h"
#include "cli/support/commands.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/tournament/tournament_session.h"
#include "match/terms/endpoint.h"
#include "tournament/config/config_file.h"
#include "tournament/config/config_keys.h"
#include "tournament/config/start_times.h"
#include "tournament/store/folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using namespace tournament;

constexpr const char* kQualifyDescription =
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

struct QualifyArguments {
  std::string team;
  std::vector<std::string> opponents;
  std::string folder = "qualification";
  std::string out;
  std::string mode = "realtime";
  int half_time = 300;
  bool json = false;
};

// Equal names of folders get a number.
std::vector<TeamEntry> team_entries(const QualifyArguments& arguments, std::string& error) {
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

std::string config_text(const QualifyArguments& arguments, const std::vector<TeamEntry>& teams) {
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
    return print_error(kCannotCreate, "{}: other teams or settings; --dir names another folder",
                       file.string());
  }
  TRY_OR(kCannotCreate, base::create_folders(folder));
  const auto written = base::write_file(file, text);
  return written ? kOk : print_error(kCannotCreate, written.error().message);
}

struct Packed {
  LeagueLogs logs;
  std::time_t start = 0;
};

// Prints the error and returns an exit code.
int read_matches(const fs::path& folder, int cycles, std::vector<Packed>& packed) {
  TRY_INIT_OR(kBadData, const auto state, read_tournament(folder));
  for (const ScheduledMatch& match : state.matches) {
    if (!match.outcome || !match.outcome->played()) {
      return print_error(kFailed, "match {} was not played", match.fixture.index);
    }
    const std::time_t start = parse_utc_time(match.outcome->started);
    TRY_INIT_OR(kBadData, auto logs, read_league_logs(folder / match.outcome->folder, start));
    if (logs.rcl.empty()) {
      return print_error(kBadData, "match {} has no text log", match.fixture.index);
    }
    if (logs.last_cycle < cycles) {
      return print_error(kBadData, "match {} ends at cycle {} of {}", match.fixture.index,
                         logs.last_cycle, cycles);
    }
    packed.push_back({std::move(logs), start});
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

int run_qualify(const QualifyArguments& arguments) {
  std::string error;
  const std::vector<TeamEntry> teams = team_entries(arguments, error);
  if (!error.empty()) return print_error(kUsage, error);
  const fs::path out = arguments.out.empty() ? fs::path(teams.front().name + "_logs.tar.gz")
                                             : fs::path(arguments.out);
  if (!out.string().ends_with(kArchiveEnding)) {
    return print_error(kUsage, "--out '{}': must end in {}", out.string(), kArchiveEnding);
  }

  TRY_STEP(write_config(arguments.folder, config_text(arguments, teams)));
  TRY_STEP(play_tournament(arguments.folder, arguments.json));

  std::vector<Packed> packed;
  const int cycles = arguments.half_time * 20;
  TRY_STEP(read_matches(arguments.folder, cycles, packed));
  TRY_STEP(write_archive(out, stem_of(out), packed));

  std::vector<std::string> files;
  for (const Packed& one : packed) files.push_back(one.logs.name);
  const bool whole = cycles >= kFullTime;
  if (!whole) {
    print_error(0, "warning: {} cycles a match; the league asks for whole matches", cycles);
  }

  if (arguments.json) {
    return print_json({{"schema", "cls.qualify/1"},
                       {"archive", out.string()},
                       {"whole_matches", whole},
                       {"matches", files}});
  }
  fmt::print("{}: {}\n", out.string(), base::counted(files.size(), "match", "matches"));
  for (const std::string& file : files) fmt::print("  {}.rcg, .rcl\n", file);
  return kOk;
}

}  // namespace

void add_qualify_command(Command& app) {
  auto [command, arguments] = app.command("qualify", kQualifyDescription, run_qualify);
  command.group = kPlayCommands;
  command.starts_programs = true;
  command.option("TEAM", arguments.team, "the SIDE that qualifies").required();
  command.option("OPPONENT", arguments.opponents, "SIDEs to play against").required();
  command.option("--out FILE", arguments.out, "the archive (default: TEAM_logs.tar.gz)")
      .of_group(kOutputGroup);
  command.setting("--dir DIR", arguments.folder, "folder of the matches");
  command.setting("--mode MODE", arguments.mode, "realtime, synch or lockstep")
      .one_of({"realtime", "synch", "lockstep"});
  command.setting("--half-time", arguments.half_time, "seconds of a half").above(0);
  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli
