// `cls watch WHAT`: a match as a page for a browser.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "base/text/number_text.h"
#include "cli/logs/compare_matches.h"
#include "cli/logs/find_log.h"
#include "cli/logs/live_view.h"
#include "cli/logs/output_file.h"
#include "cli/logs/running_match.h"
#include "cli/logs/terminal_view.h"
#include "cli/logs/tournament_view.h"
#include "cli/support/browser.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/log_errors.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "match/result/match_folder.h"
#include "match/result/match_result.h"
#include "soccer/side.h"
#include "tournament/store/folder.h"
#include "viewer/page/match_page.h"
#include "viewer/page/page_decisions.h"
#include "viewer/page/page_drawings.h"
#include "viewer/page/page_review.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWatchDescription =
    "watch a match in a browser\n"
    "Writes one HTML file that needs no network and no server: field, timeline,\n"
    "events, statistics, and the log itself ('cls convert' gives it back).\n"
    "\n"
    "  cls watch runs/match-1                 a match folder: its match.html\n"
    "  cls watch game.rcg.gz --out game.html  any game log\n"
    "  cls watch game.rcg --at 1234 --players l7,r1\n"
    "  cls watch before.rcg after.rcg         two matches on one clock, side by side\n"
    "  cls watch runs                         the match that is played now, live\n"
    "  cls watch localhost:6000               the match on any soccer server\n"
    "  cls watch runs --view terminal         without a browser, for example over ssh\n"
    "\n"
    "WHAT is a game log (rcg 1 to 7 or JSON, plain or compressed), a page of cls, a\n"
    "match folder, a folder of matches (the latest that has a log), a tournament's\n"
    "folder (a list of its matches with a page of each; with --out its latest match\n"
    "that failed, else the latest), HOST:PORT of a soccer server, or - for standard\n"
    "input.";

struct WatchArguments {
  std::string what;
  std::string other;
  std::string out;
  std::optional<int> at;
  std::vector<std::string> players;
  std::vector<std::string> world_models;
  std::string review;
  bool compact = false;
  bool no_open = false;
  bool json = false;
  bool live = false;
  std::string viewer = "browser";
  std::string cast;
  LiveViewOptions view;

  bool in_terminal() const { return viewer == "terminal" || !cast.empty(); }
};

bool is_player(const std::string& name) {
  if (name.size() < 2 || (name[0] != 'l' && name[0] != 'r')) return false;
  const auto unum = base::parse_int(std::string_view(name).substr(1));
  return unum && soccer::is_unum(*unum);
}

// Nothing if all names are players.
std::optional<std::string> player_error(std::string_view option,
                                        const std::vector<std::string>& players) {
  for (const std::string& player : players) {
    if (is_player(player)) continue;
    return fmt::format("{} '{}': must be l1 to l11 or r1 to r11, such as l7,r1", option, player);
  }
  return std::nullopt;
}

void show(const WatchArguments& arguments, const fs::path& page) {
  const std::string url = file_url(page);
  const bool opened = !arguments.no_open && arguments.out.empty() && open_in_browser(url);

  if (arguments.json) return;
  fmt::print("{}\n", arguments.out.empty() ? url : page.string());
  if (opened) fmt::print(stderr, "cls: opened in the browser\n");
}

void print_document(const viewer::StreamMatch& match, const fs::path& page, bool compact) {
  std::error_code code;
  print_json({{"schema", "cls.watch/1"},
              {"page", page.string()},
              {"bytes", fs::file_size(page, code)},
              {"frames", match.record.frames()},
              {"compact", compact},
              {"errors", match.record.errors.count}});
}

// "1234" or "1200-1400".
std::optional<viewer::CycleRange> cycles_of(const std::string& word) {
  const std::size_t dash = std::min(word.find('-'), word.size());
  const auto first = base::parse_int(std::string_view(word).substr(0, dash));
  const auto last =
      dash < word.size() ? base::parse_int(std::string_view(word).substr(dash + 1)) : first;

  if (!first || !last || *first < 0 || *last < *first) return std::nullopt;
  return viewer::CycleRange{*first, *last};
}

// What --world-models asks for; nothing: no decisions.
base::Result<std::optional<viewer::DecisionChoice>> decision_choice(
    const std::vector<std::string>& words) {
  viewer::DecisionChoice choice;
  for (const std::string& word : words) {
    const auto cycles = cycles_of(word);
    if (words.size() == 1 && word == "none") return std::optional<viewer::DecisionChoice>();
    if (words.size() == 1 && word == "all") break;

    if (is_player(word)) {
      choice.players.push_back(word);
    } else if (cycles) {
      choice.cycles.push_back(*cycles);
    } else {
      return base::Error{
          fmt::format("--world-models '{}': must be all, none, players such as l7,r1, or cycles "
                      "such as 1200-1400",
                      word)};
    }
  }

  return std::optional(std::move(choice));
}

base::Result<std::vector<viewer::PageDecisions>> decisions_of(const WatchArguments& arguments,
                                                              const FoundLog& found) {
  constexpr double kWorthALine = 2e6;
  constexpr double kBase64 = 4.0 / 3.0;

  TRY_INIT(const auto choice, decision_choice(arguments.world_models));
  if (!choice) return std::vector<viewer::PageDecisions>();

  auto decisions = viewer::read_page_decisions(found.folder, *choice);
  if (!decisions) return decisions;

  double size = 0.0;
  for (const viewer::PageDecisions& each : *decisions)
    size += kBase64 * static_cast<double>(each.packed.size());

  if (size > kWorthALine && arguments.world_models.empty()) {
    fmt::print(stderr,
               "cls: {:.1f} MB of decisions go into the page; --world-models none, l7,r1 or "
               "1200-1400 makes it smaller\n",
               size / 1e6);
  }

  return decisions;
}

// The decisions of --review; null without it.
base::Result<base::Json> review_of(const WatchArguments& arguments, const FoundLog& found) {
  if (arguments.review.empty()) return base::Json();
  const auto document = base::read_file(arguments.review);
  if (!document) {
    const auto why = base::why_no_file(arguments.review);
    return base::Error{
        fmt::format("--review {}: {}", arguments.review, why.value_or("cannot be read"))};
  }
  auto review = viewer::page_review(*document, found.logs.game);
  if (!review) {
    return base::Error{fmt::format("--review {}: {}", arguments.review, review.error().message)};
  }
  return review;
}

// The sides of the match, for scenarios that begin with one of its moments; empty without a result.
std::array<std::string, 2> sides_of(const fs::path& folder) {
  namespace match = match;
  const auto text = base::read_file(folder / match::kResultFile);
  const auto result = match::parse_match_result(text.value_or(""));
  if (!result) return {};
  return {result->left.endpoint, result->right.endpoint};
}

int write_match_page(const WatchArguments& arguments, const FoundLog& found, const fs::path& page) {
  TRY_INIT_OR(unreadable_code(found.logs.game), const auto match,
              viewer::read_log_or_page(found.logs.game));

  report_errors(found.logs.game, match.record.errors);
  if (match.record.frames() == 0) {
    if (match.record.errors.empty()) {
      print_error(kBadData, "{}: no frame to show", found.logs.game);
    }
    return kBadData;
  }

  const auto text = read_text_log(found);
  TRY_INIT_OR(kBadData, const auto decisions, decisions_of(arguments, found));
  TRY_INIT_OR(kBadData, const auto review, review_of(arguments, found));

  const bool compact = arguments.compact || match.form.compact;
  viewer::PageSettings settings = {.at = arguments.at,
                                   .players = arguments.players,
                                   .missed = viewer::read_missed_decisions(found.folder),
                                   .drawings = viewer::read_page_drawings(found.folder),
                                   .review = review};
  if (!decisions.empty()) settings.sides = sides_of(found.folder);
  const std::string html = viewer::match_page(
      match.record, text ? &*text : nullptr, fs::path(found.logs.game).filename().string(),
      {.settings = settings, .decisions = decisions, .compact = compact});

  TRY_OR(kCannotCreate, write_beside(page, html, arguments.out));

  if (arguments.json) print_document(match, page, compact);
  show(arguments, page);
  return match.record.errors.empty() ? kOk : kBadData;
}

void print_live(const std::string& url, bool json) {
  if (json) {
    const base::Json document = {{"schema", "cls.watch/1"}, {"url", url}};
    print_json(document);
  } else {
    fmt::print("{}\n", url);
  }

  std::fflush(stdout);
  if (const std::string hint = tunnel_hint(url); !hint.empty()) {
    fmt::print(stderr, "cls: from another host: {}\n", hint);
  }
}

int serve(const WatchArguments& arguments, FollowedMatch match) {
  LiveViewOptions options = arguments.view;
  options.settings = {arguments.at, arguments.players, {}};
  options.open_browser = !arguments.no_open;

  const std::atomic<int>& signal = watch_interrupts();
  TRY_INIT_OR(kTryAgain, const auto view, LiveView::start(std::move(match), options));

  print_live(view->url(), arguments.json);
  view->serve(signal);
  return kOk;
}

int serve_matches(const WatchArguments& arguments) {
  LiveViewOptions options = arguments.view;
  options.open_browser = !arguments.no_open;
  return serve_tournament(arguments.what, options,
                          [&](const std::string& url) { print_live(url, arguments.json); });
}

int show_running(const WatchArguments& arguments, FollowedMatch match) {
  if (!arguments.in_terminal()) return serve(arguments, std::move(match));
  return show_in_terminal(std::move(match.input), {match.title, arguments.at, arguments.cast});
}

int show_log_in_terminal(const WatchArguments& arguments, const FoundLog& found) {
  TRY_INIT_OR(unreadable_code(found.logs.game), const auto match,
              viewer::read_log_or_page(found.logs.game));
  report_errors(found.logs.game, match.record.errors);
  if (match.record.frames() == 0) return kBadData;

  return show_in_terminal(match.record, {found.name, arguments.at, arguments.cast});
}

int run_watch_command(const WatchArguments& arguments) {
  if (!arguments.other.empty()) {
    return compare_matches(
        {arguments.what, arguments.other, arguments.out, arguments.no_open, arguments.json});
  }

  if (const auto error = player_error("--players", arguments.players)) {
    return print_error(kUsage, *error);
  }
  TRY_OR(kUsage, decision_choice(arguments.world_models));

  if (arguments.out.empty() && !arguments.in_terminal() && tournament::holds_plan(arguments.what)) {
    return serve_matches(arguments);
  }

  if (arguments.out.empty()) {
    TRY_INIT_OR(names_server(arguments.what) ? kUnavailable : kNoInput, auto running,
                find_running_match(arguments.what, arguments.live));
    if (running) return show_running(arguments, *std::move(running));
  }

  TRY_INIT_OR(kNoInput, const auto found, find_log(arguments.what));
  if (arguments.in_terminal()) return show_log_in_terminal(arguments, found);

  if (const std::string wrong = wrong_ending(arguments.out, "html"); !wrong.empty()) {
    return print_error(kUsage, wrong);
  }
  const fs::path page =
      arguments.out.empty() ? found.folder / (found.name + ".html") : fs::path(arguments.out);
  if (const auto why = why_no_page(page)) return print_error(kCannotCreate, *why);

  return write_match_page(arguments, found, page);
}

}  // namespace

void add_watch_command(Command& app) {
  auto [command, arguments] = app.command("watch", kWatchDescription, run_watch_command);
  command.group = kResultCommands;

  command.option("WHAT", arguments.what, "game log, page or match folder").required();
  command.option("OTHER", arguments.other, "a second match, beside the first one");
  command
      .option("--out FILE", arguments.out,
              "write the page to this file and do not open it (default: beside\n"
              "the log)")
      .of_group(kOutputGroup);

  command.option("--at", arguments.at, "cycle to show first").of_group(kDebuggingGroup);
  command.option("--players L7,R1,...", arguments.players, "players to select, such as l7,r1")
      .split_at(',');
  command
      .option("--world-models WHICH", arguments.world_models,
              "which decisions to include, of those that cls match --record-world-models\n"
              "recorded: all, none, players such as l7,r1, cycles such as 1200-1400, or\n"
              "both (default: all)")
      .of_group(kDebuggingGroup)
      .split_at(',');

  command
      .option("--review FILE", arguments.review,
              "decisions of `cls review --save FILE`, with what would have been better")
      .of_group(kDebuggingGroup);

  command.flag("--compact", arguments.compact,
               "half the size: centimeters, degrees, no velocities; the page is then\n"
               "no log");
  command.flag("--no-open", arguments.no_open, "do not open the browser");

  command
      .option("--view WHERE", arguments.viewer,
              "browser, or terminal: the match in characters, with keys (default: browser)")
      .one_of({"browser", "terminal"});
  command
      .option("--cast FILE", arguments.cast,
              "record what a terminal shows, for asciinema; of a log: all of it, without "
              "waiting")
      .of_group(kOutputGroup);

  command.flag("--live", arguments.live,
               "WHAT is a log that a server writes now (found out for match folders)");
  command.option("--listen ADDRESS", arguments.view.address.host,
                 "IP address of the page of a running match (default: 127.0.0.1; 0.0.0.0: "
                 "all hosts that know the page's address may watch)");
  command.option("--port", arguments.view.address.port, "its port (default: a free one)")
      .range(0, 65535);
  add_host_name_option(command, arguments.view.host_names);
  add_linger_option(command, arguments.view.linger_s);

  command.flag("--json", arguments.json, "print page, size and frames as one JSON document")
      .of_group(kOutputGroup);
}

}  // namespace cls::cli
