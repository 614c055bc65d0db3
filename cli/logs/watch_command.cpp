// `cls watch WHAT`: a match as a page for a browser.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/json_text.h"
#include "base/text/number_text.h"
#include "cli/logs/find_match_folder.h"
#include "cli/support/browser.h"
#include "cli/support/commands.h"
#include "cli/support/exit_code.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "gamelog/files/log_files.h"
#include "gamelog/rcl/rcl_reader.h"
#include "soccer/side.h"
#include "viewer/page/match_page.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

constexpr const char* kDescription =
    "watch a match in a browser\n"
    "Writes one HTML file that needs no network and no server: field, timeline,\n"
    "events, statistics, and the log itself ('cls convert' gives it back).\n"
    "\n"
    "  cls watch runs/match-1                 a match folder: its match.html\n"
    "  cls watch game.rcg.gz --out game.html  any game log\n"
    "  cls watch game.rcg --at 1234 --players l7,r1\n"
    "\n"
    "WHAT is a game log (rcg 1 to 6, JSON, gzip), a page of cls, a match folder, a\n"
    "tournament's folder or a folder of matches (the latest that failed, else the\n"
    "latest), or - for standard input.";

struct Arguments {
  std::string what;
  std::string out;
  std::optional<int> at;
  std::vector<std::string> players;
  bool compact = false;
  bool no_open = false;
  bool json = false;
};

// What to show, and where its page goes by default.
struct Found {
  gamelog::MatchLogs logs;
  fs::path page;
};

std::string without_log_suffix(std::string name) {
  for (const std::string_view suffix : {".gz", ".rcg", ".json", ".html"}) {
    if (name.ends_with(suffix)) name.resize(name.size() - suffix.size());
  }
  return name;
}

Result<Found> find_in_folder(const fs::path& folder) {
  auto match = find_match_folder(folder, std::nullopt);
  fs::path where = folder;
  if (match) where = match->folder;
  const gamelog::FoundLogs found = gamelog::find_logs({where.string()});
  const auto has_game = [](const gamelog::MatchLogs& one) { return !one.game.empty(); };
  const auto first = std::find_if(found.matches.begin(), found.matches.end(), has_game);
  if (first == found.matches.end()) {
    return match ? Error{fmt::format("{}: no game log (*.rcg, *.rcg.gz)", where.string())}
                 : match.error();
  }
  if (!match && found.matches.size() > 1) {
    return Error{fmt::format("{}: {} logs; name one, such as {}", where.string(),
                             found.matches.size(), first->game)};
  }
  return Found{*first, where / "match.html"};
}

Result<Found> find_what(const std::string& what) {
  std::error_code code;
  if (fs::is_directory(what, code)) return find_in_folder(what);
  if (what == "-") return Found{{what, ""}, "match.html"};
  if (what.ends_with(".rcl") || what.ends_with(".rcl.gz")) {
    return Error{fmt::format("{}: a text log; name the game log (rcg) beside it", what)};
  }
  if (const auto why = base::why_no_file(what)) return Error{fmt::format("{}: {}", what, *why)};
  const gamelog::FoundLogs found = gamelog::find_logs({what});
  const fs::path path(what);
  const std::string name = without_log_suffix(path.filename().string()) + ".html";
  const gamelog::MatchLogs logs =
      found.matches.size() == 1 ? found.matches.front() : gamelog::MatchLogs{what, ""};
  return Found{logs, path.parent_path() / name};
}

std::string start_of(const fs::path& file) {
  std::array<char, 32> bytes{};
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(in.gcount())};
}

bool is_player(const std::string& name) {
  if (name.size() < 2 || (name[0] != 'l' && name[0] != 'r')) return false;
  const auto unum = base::parse_int(std::string_view(name).substr(1));
  return unum && *unum >= 1 && *unum <= soccer::kPlayersPerTeam;
}

// A page is replaced, another file is not.
std::optional<std::string> why_not_written(const fs::path& page) {
  std::error_code code;
  if (!fs::exists(page, code)) return std::nullopt;
  if (fs::is_directory(page, code)) return fmt::format("{}: a folder, not a file", page.string());
  if (viewer::looks_like_page(start_of(page))) return std::nullopt;
  return fmt::format("{}: exists and is no page of cls; name another file with --out",
                     page.string());
}

void show(const Arguments& arguments, const fs::path& page) {
  const std::string url = file_url(page);
  const bool opened = !arguments.no_open && arguments.out.empty() && open_in_browser(url);
  if (arguments.json) return;
  fmt::print("{}\n", arguments.out.empty() ? url : page.string());
  if (opened) fmt::print(stderr, "cls: opened in the browser\n");
}

void print_document(const viewer::StreamMatch& match, const fs::path& page, bool compact) {
  std::error_code code;
  const nlohmann::ordered_json document = {{"schema", "cls.watch/1"},
                                           {"page", page.string()},
                                           {"bytes", fs::file_size(page, code)},
                                           {"frames", match.record.frames()},
                                           {"compact", compact},
                                           {"errors", match.record.errors.count}};
  fmt::print("{}", base::json_document(document));
}

int write_match_page(const Arguments& arguments, const Found& found, const fs::path& page) {
  const auto match = viewer::read_log_or_page(found.logs.game);
  if (!match) {
    return print_error(unreadable_code(found.logs.game), match.error().message);
  }
  report_errors(found.logs.game, match->record.errors);
  if (match->record.frames() == 0) {
    if (match->record.errors.empty()) {
      print_error(kBadData, fmt::format("{}: no frame to show", found.logs.game));
    }
    return kBadData;
  }
  std::optional<gamelog::RclRecord> text;
  if (!found.logs.text.empty()) {
    if (auto read = gamelog::read_rcl_file(found.logs.text)) text = *std::move(read);
  }
  const bool compact = arguments.compact || match->form.compact;
  const std::string html = viewer::match_page(match->record, text ? &*text : nullptr,
                                              fs::path(found.logs.game).filename().string(),
                                              compact, {arguments.at, arguments.players});
  if (const auto written = base::write_file(page, html); !written) {
    return print_error(kCannotCreate, written.error().message);
  }
  if (arguments.json) print_document(*match, page, compact);
  show(arguments, page);
  return match->record.errors.empty() ? kOk : kBadData;
}

int run_watch_command(const Arguments& arguments) {
  for (const std::string& player : arguments.players) {
    if (is_player(player)) continue;
    return print_error(kUsage, fmt::format("--players '{}': must be l1 to l11 or r1 to r11, such "
                                           "as l7,r1",
                                           player));
  }
  const auto found = find_what(arguments.what);
  if (!found) return print_error(kNoInput, found.error().message);
  const fs::path page = arguments.out.empty() ? found->page : fs::path(arguments.out);
  if (const auto why = why_not_written(page)) return print_error(kCannotCreate, *why);
  return write_match_page(arguments, *found, page);
}

}  // namespace

void add_watch_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("watch", kDescription);
  command->add_option("WHAT", arguments->what, "game log, page or match folder")->required();
  command->add_option("--out", arguments->out,
                      "write the page to this file and do not open it (default: beside\n"
                      "the log)");
  command->add_option("--at", arguments->at, "cycle to show first");
  command->add_option("--players", arguments->players, "players to select, such as l7,r1")
      ->delimiter(',');
  command->add_flag("--compact", arguments->compact,
                    "half the size: centimeters, degrees, no velocities; the page is then\n"
                    "no log");
  command->add_flag("--no-open", arguments->no_open, "do not open the browser");
  command->add_flag("--json", arguments->json, "print page, size and frames as one JSON document");
  command->callback([arguments, &exit_code] { exit_code = run_watch_command(*arguments); });
}

}  // namespace cls::cli
