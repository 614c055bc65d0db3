// Reads the state of the tournament for each request; matches are followed on demand.
#include "cli/logs/tournament_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include "base/text/number_text.h"
#include "cli/support/browser.h"
#include "cli/support/exit_code.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "gamelog/files/log_files.h"
#include "gamelog/rcl/rcl_reader.h"
#include "match/result/match_folder.h"
#include "tournament/report/report_model.h"
#include "tournament/report/report_tables.h"
#include "tournament/store/folder.h"
#include "viewer/live/live_site.h"
#include "viewer/live/log_glance.h"
#include "viewer/live/match_list.h"
#include "viewer/page/match_page.h"
#include "viewer/page/page_decisions.h"
#include "viewer/page/page_drawings.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
namespace tournament = tournament;
using match::game_log_in;
using match::has_result;
using tournament::ScheduledMatch;
using viewer::HttpReply;

constexpr std::chrono::milliseconds kTournamentPollInterval{200};
constexpr double kShortlySeconds = 60.0;

HttpReply not_found(std::string why) {
  HttpReply reply;
  reply.body = std::move(why) + "\n";
  return reply;
}

class TournamentSite {
 public:
  explicit TournamentSite(fs::path folder) : folder_(std::move(folder)) {}

  HttpReply reply(std::string_view path, std::string_view query) {
    const auto state = tournament::read_tournament(folder_);
    if (!state) return not_found(state.error().message);
    if (path.empty()) return list(*state);

    // match/INDEX/, match/INDEX/live, match/INDEX/drawings-left
    constexpr std::string_view kMatch = "match/";
    if (!path.starts_with(kMatch)) return not_found("not found");
    path.remove_prefix(kMatch.size());

    const std::size_t slash = std::min(path.find('/'), path.size());
    const auto index = base::parse_int(path.substr(0, slash));

    const auto match = std::find_if(
        state->matches.begin(), state->matches.end(),
        [&](const ScheduledMatch& one) { return index && one.fixture.index == *index; });
    if (match == state->matches.end() || slash == path.size()) return not_found("not found");

    const std::string_view rest = path.substr(slash + 1);
    if (rest == viewer::kStreamPath) return stream(*match, query);
    return rest.empty() ? page(*state, *match)
                        : viewer::drawings_reply(match_folder(*state, *match), rest, query);
  }

 private:
  HttpReply list(const tournament::TournamentState& state) {
    const tournament::Report report = tournament::make_report(state.config, state.matches, folder_);
    viewer::MatchList list;
    list.title = report.name;
    list.status = status(report, state.running.size());
    list.running = !report.complete;
    list.facts = facts(report, state.running.size());

    for (const tournament::RankedTable& ranked : report.tables) {
      add_table(tournament::standings_table(report, ranked, tournament::Headings::kShort), list);
    }

    add_table(tournament::crosstable(report, false), list);
    for (const ScheduledMatch& match : state.matches) list.matches.push_back(row(state, match));

    return viewer::page_reply(viewer::match_list_page(list));
  }

  static void add_table(const tournament::ReportTable& table, viewer::MatchList& list) {
    if (!table.empty()) list.tables.push_back(table.table.format_html(table.title));
  }

  // What a visitor wants to know first.
  static std::vector<viewer::Fact> facts(const tournament::Report& report, std::size_t running) {
    const tournament::MatchCounts& counts = report.counts;

    int goals = 0;
    int counted = 0;
    for (const ScheduledMatch& match : report.matches) {
      if (!match.outcome || !match.outcome->counts()) continue;
      goals += match.outcome->left_score + match.outcome->right_score;
      ++counted;
    }

    const auto& ranked = report.tables;
    const bool leads = counted > 0 && !ranked.empty() && !ranked.back().standings.empty();
    const std::string waiting = fmt::to_string(counts.open - static_cast<int>(running));
    return {{report.complete ? "winner" : "leader",
             leads ? report.team(ranked.back().standings.front().team) : "–"},
            {"matches done", fmt::format("{} of {}", counts.done(), counts.scheduled)},
            {"played now", fmt::to_string(running)},
            {"still to play", waiting},
            {"goals a match", counted > 0 ? fmt::format("{:.1f}", double(goals) / counted) : "–"}};
  }

  // "4 of 6 matches done, 2 played now, about 3 min left".
  std::string status(const tournament::Report& report, std::size_t running) {
    std::string text = tournament::counts_text(report.counts);
    if (running > 0) text += fmt::format(", {} played now", running);

    const auto now = std::chrono::steady_clock::now();
    const int done = report.counts.done();
    if (!first_look_) first_look_ = {now, done};
    if (running == 0 || done <= first_look_->second) return text;

    const double seconds = std::chrono::duration<double>(now - first_look_->first).count() *
                           report.counts.open / (done - first_look_->second);
    return text + (seconds < kShortlySeconds
                       ? ", less than a minute left"
                       : fmt::format(", about {:.0f} min left", seconds / 60.0));
  }

  viewer::ListedMatch row(const tournament::TournamentState& state, const ScheduledMatch& match) {
    const auto name = [&](int team) { return state.config.competition.team(team); };
    viewer::ListedMatch row{
        match.fixture.index, name(match.fixture.left), name(match.fixture.right), "", "", false};

    std::error_code code;
    const bool running =
        std::binary_search(state.running.begin(), state.running.end(), match.fixture.index);
    row.has_page = (running || match.attempts > 0) &&
                   fs::exists(game_log_in(match_folder(state, match)), code);

    if (!match.outcome) {
      row.state = running ? "starting" : match.attempts > 0 ? "not finished" : "planned";
      row.live = true;
      if (running && row.has_page) look_at(match.fixture.index, match_folder(state, match), row);
    } else {
      row.score = fmt::format("{} : {}", match.outcome->left_score, match.outcome->right_score);
      row.state = match.outcome->forfeit ? "forfeited" : "finished";
      if (match.outcome->annulled) row.state = "annulled";
      if (match.outcome->invalid()) row.state = "failed: " + match.outcome->message;
      row.has_page = row.has_page && !match.outcome->folder.empty();
    }

    return row;
  }

  fs::path match_folder(const tournament::TournamentState& state,
                        const ScheduledMatch& match) const {
    if (match.outcome && !match.outcome->folder.empty()) return folder_ / match.outcome->folder;
    return folder_ /
           tournament::match_folder(state.config, match.fixture, std::max(1, match.attempts));
  }

  HttpReply page(const tournament::TournamentState& state, const ScheduledMatch& match) {
    const fs::path folder = match_folder(state, match);
    const std::string title = fmt::format("match {}", match.fixture.index);

    if (!match.outcome) {
      follow(match.fixture.index, folder);
      return viewer::page_reply(
          viewer::live_page(title, {viewer::kStreamPath, viewer::kDrawingsPath}, {}));
    }

    const auto read = viewer::read_log_or_page(game_log_in(folder).string());
    if (!read || read->record.frames() == 0) return not_found("the match has no log");
    return viewer::page_reply(viewer::match_page(read->record, nullptr,
                                                 game_log_in(folder).filename().string(), false,
                                                 {.missed = viewer::read_missed_decisions(folder),
                                                  .drawings = viewer::read_page_drawings(folder)}));
  }

  // Score and clock of a match that is played now.
  void look_at(int index, const fs::path& folder, viewer::ListedMatch& row) {
    const fs::path log = game_log_in(folder);

    auto found = glances_.find(index);
    if (found == glances_.end() || found->second.first != log) {
      found = glances_.insert_or_assign(index, std::pair(log, viewer::LogGlance(log))).first;
    }

    const auto glance = found->second.second.now();
    if (!glance) return;

    row.score = fmt::format("{} : {}", glance->left, glance->right);
    row.state = fmt::format("cycle {}", glance->cycle);
    row.ball = glance->ball;
  }

  void follow(int index, const fs::path& folder) {
    const auto found = followed_.find(index);
    if (found != followed_.end() && found->second.first == folder) return;

    auto input = viewer::follow_log(game_log_in(folder), [folder] { return has_result(folder); });
    followed_[index] = {folder, std::make_unique<viewer::LiveMatch>(std::move(input))};
  }

  HttpReply stream(const ScheduledMatch& match, std::string_view query) const {
    const auto found = followed_.find(match.fixture.index);
    if (found == followed_.end()) return not_found("the match is not played now");
    return viewer::feed_reply(found->second.second->feed(), query);
  }

  fs::path folder_;
  std::map<int, std::pair<fs::path, std::unique_ptr<viewer::LiveMatch>>> followed_;
  std::map<int, std::pair<fs::path, viewer::LogGlance>> glances_;
  /// When the list was first asked for, and how many matches were done then.
  std::optional<std::pair<std::chrono::steady_clock::time_point, int>> first_look_;
};

// Without a running `cls tournament run`, too.
bool is_over(const fs::path& folder) {
  const auto state = tournament::read_tournament(folder);
  return !state || state->running.empty();
}

}  // namespace

int serve_tournament(const fs::path& folder, const LiveViewOptions& options,
                     const std::function<void(const std::string& url)>& on_start) {
  // Without a terminal the page of a tournament that is over would end before anyone sees it.
  const auto earliest_end = end_of_linger(options.linger_s);
  if (is_over(folder) && earliest_end <= std::chrono::steady_clock::now()) {
    return print_error(
        kUsage, fmt::format("{0}: no match is played now; --linger SECONDS serves the list of its "
                            "matches, cls tournament report {0} --format html --out FILE writes it",
                            folder.string()));
  }

  const std::atomic<int>& signal = watch_interrupts();
  // Used by the server's thread only.
  TournamentSite site(fs::canonical(folder));
  const auto server = viewer::HttpServer::start(
      options.address,
      [&site](std::string_view path, std::string_view query) { return site.reply(path, query); });
  if (!server) return print_error(kTryAgain, server.error().message);

  on_start((*server)->url());
  if (options.open_browser) open_in_browser((*server)->single_use_url());

  while (signal.load() == 0 && !is_over(folder))
    std::this_thread::sleep_for(10 * kTournamentPollInterval);
  const auto end = end_of_linger(options.linger_s);
  while (signal.load() == 0 && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(kTournamentPollInterval);
  }

  return kOk;
}

}  // namespace cls::cli
