// The folder is read again when its files have changed. Documents follow from what was read and
// from the logs of running matches.
#include "tournament/site/tournament_site.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <tuple>
#include <utility>

#include "base/text/number_text.h"
#include "match/result/match_folder.h"
#include "tournament/site/organizer_view.h"
#include "tournament/site/replay_shelf.h"
#include "tournament/site/spectator_view.h"
#include "tournament/store/decisions_file.h"
#include "tournament/store/pauses_file.h"
#include "viewer/live/live_match.h"
#include "viewer/live/live_site.h"
#include "viewer/live/match_list.h"
#include "viewer/page/encoding.h"
#include "viewer/page/match_page.h"
#include "viewer/page/page_decisions.h"
#include "viewer/page/page_drawings.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using std::chrono::steady_clock;
using viewer::HttpReply;

constexpr milliseconds kRefreshInterval{1000};
/// Without requests for this long the folder of a tournament that is over is not read.
constexpr milliseconds kRestAfter{15'000};
/// Matches that are over and whose streams are still there for those who watch them.
constexpr std::size_t kMaxEndedStreams = 4;
constexpr std::size_t kTagLength = 20;
constexpr const char* kHome = "../../";

HttpReply not_found(std::string_view why = "not found") {
  HttpReply reply;
  reply.body = fmt::format("{}\n", why);
  return reply;
}

HttpReply redirect_to(std::string location) {
  HttpReply reply;
  reply.status = 302;
  reply.location = std::move(location);
  return reply;
}

std::shared_ptr<const viewer::HttpDocument> document(std::string text) {
  viewer::HttpDocument made;
  made.tag = viewer::sha256_hex(text).substr(0, kTagLength);
  made.packed = viewer::gzip(text);
  made.text = std::move(text);
  return std::make_shared<const viewer::HttpDocument>(std::move(made));
}

HttpReply document_reply(std::shared_ptr<const viewer::HttpDocument> document) {
  HttpReply reply;
  reply.status = 200;
  reply.type = "text/html; charset=utf-8";
  reply.document = std::move(document);
  return reply;
}

// Differs after every change of the tournament, and once a minute: planned times move on.
std::string fingerprint(const fs::path& tournament) {
  const auto minutes = std::chrono::floor<std::chrono::minutes>(std::chrono::system_clock::now());
  std::string text =
      fmt::format("{} {}", minutes.time_since_epoch().count(), FolderLock::is_held(tournament));
  const std::string store = kStoreFile;
  for (const std::string& name :
       {std::string(kPlanFile), store, store + "-wal", std::string(kScheduleFile),
        std::string(kDecisionsFile), std::string(kPausesFile), std::string(kResultsFolder),
        std::string(kMatchesFolder)}) {
    std::error_code code;
    const auto written = fs::last_write_time(tournament / name, code);
    const auto size = fs::file_size(tournament / name, code);
    text += fmt::format(" {}:{}", written.time_since_epoch().count(), code ? 0 : size);
  }
  return text;
}

}  // namespace

struct TournamentSite::State {
  /// The folder of a match that has a page.
  struct MatchFolder {
    fs::path path;
    bool live = false;  ///< it has no result yet
  };
  using MatchFolders = std::map<int, MatchFolder>;

  /// The last glances at a log, to show one of some time ago.
  struct DelayedGlance {
    fs::path log;
    viewer::LogGlance reader;
    std::deque<std::pair<steady_clock::time_point, viewer::Glance>> seen = {};

    std::optional<viewer::Glance> before(milliseconds delay) {
      const auto now = steady_clock::now();
      if (auto glance = reader.now()) seen.emplace_back(now, *std::move(glance));
      while (seen.size() > 1 && seen[1].first <= now - delay) seen.pop_front();
      if (seen.empty() || seen.front().first > now - delay) return std::nullopt;
      return seen.front().second;
    }
  };

  struct FollowedMatch {
    fs::path folder;
    std::unique_ptr<viewer::LiveMatch> match;
    bool ended = false;
  };

  State(fs::path where, const SiteOptions& given)
      : folder(std::move(where)),
        options(given),
        is_public(given.reader == Reader::kSpectator),
        shelf(given.max_replay_bytes) {}

  base::Result<void> refresh() {
    const std::string current = fingerprint(folder);
    const bool changed = current != seen;
    if (!changed && tournament.running.empty()) return {};

    if (changed) {
      TRY_INIT(tournament, read_tournament(folder));
      make_views();
      seen = current;
    }
    if (is_public) {
      publish_public_pages();
    } else {
      publish_list();
    }
    return {};
  }

  void make_views() {
    ++views;
    if (is_public) {
      public_view = spectator_view(tournament, folder);
      over.store(public_view.over);
    } else {
      list = organizer_view(tournament, folder, first_look);
    }
    std::erase_if(glances, [this](const auto& known) {
      return !std::ranges::binary_search(tournament.running, known.first);
    });
  }

  // Matches without a result have no replay: the run may play them again.
  MatchFolders public_folders() const {
    MatchFolders found;
    for (const ScheduledMatch& match : tournament.matches) {
      const bool running = std::ranges::binary_search(tournament.running, match.fixture.index);
      if (!match.outcome && !running) continue;
      if (match.outcome && (match.outcome->folder.empty() || match.outcome->invalid())) continue;
      const fs::path path = folder_of(tournament, match, folder);
      if (!is_inside(match::game_log_in(path), folder)) continue;
      found[match.fixture.index] = {path, !match.outcome};
    }
    return found;
  }

  MatchFolders all_folders() const {
    MatchFolders found;
    for (const ScheduledMatch& match : tournament.matches) {
      found[match.fixture.index] = {folder_of(tournament, match, folder), !match.outcome};
    }
    return found;
  }

  // Score and clock of a match that is played now.
  std::optional<viewer::Glance> glance_at(int index, const fs::path& match) {
    const fs::path log = match::game_log_in(match);
    auto known = glances.find(index);
    if (known == glances.end() || known->second.log != log) {
      known = glances.insert_or_assign(index, DelayedGlance{log, viewer::LogGlance(log)}).first;
    }
    return known->second.before(options.delay);
  }

  void publish_public_pages() {
    SpectatorPage shown = public_view;
    MatchFolders found = public_folders();
    for (auto& group : shown.results) {
      for (SpectatorMatch& match : group.content) match.has_page = found.contains(match.index);
    }

    // The running matches change all the time, and are a document of their own.
    for (SpectatorMatch& match : shown.running) match.has_page = found.contains(match.index);
    auto without_running = shown;
    for (SpectatorMatch& match : without_running.running) match.score.clear();
    const std::string rest =
        viewer::sha256_hex(spectator_page(without_running, "")).substr(0, kTagLength);

    for (SpectatorMatch& match : shown.running) {
      if (!match.has_page) continue;
      match.glance = glance_at(match.index, found[match.index].path);
      if (match.glance)
        match.score = fmt::format("{} : {}", match.glance->left, match.glance->right);
    }
    publish(std::move(found), document(spectator_page(shown, rest)),
            document(spectator_now(shown, rest)));
  }

  void publish_list() {
    viewer::MatchList shown = list;
    MatchFolders found = all_folders();
    for (viewer::ListedMatch& row : shown.matches) {
      if (!std::ranges::binary_search(tournament.running, row.index) || !row.live) continue;
      const fs::path& path = found[row.index].path;
      std::error_code code;
      row.has_page = fs::exists(match::game_log_in(path), code);
      const auto glance = row.has_page ? glance_at(row.index, path) : std::nullopt;
      if (!glance) continue;
      row.score = fmt::format("{} : {}", glance->left, glance->right);
      row.state = fmt::format("cycle {}", glance->cycle);
      row.ball = glance->ball;
    }
    viewer::HttpDocument made;
    made.text = viewer::match_list_page(shown);
    publish(std::move(found), std::make_shared<const viewer::HttpDocument>(std::move(made)),
            nullptr);
  }

  void publish(MatchFolders found, std::shared_ptr<const viewer::HttpDocument> made_page,
               std::shared_ptr<const viewer::HttpDocument> made_now) {
    const std::lock_guard lock(mutex);
    follow_running(found);
    forget_ended(found);
    page = std::move(made_page);
    now = std::move(made_now);
    folders = std::move(found);
  }

  void follow(int index, const fs::path& path) {
    const auto known = followed.find(index);
    if (known != followed.end() && known->second.folder == path) return;

    auto input =
        viewer::follow_log(match::game_log_in(path), [path] { return match::has_result(path); });
    if (options.delay > milliseconds(0)) input = viewer::delayed(std::move(input), options.delay);
    followed[index] = {path, std::make_unique<viewer::LiveMatch>(std::move(input)), false};
  }

  // With a delay a match is read from its start on, not from the first reader on.
  void follow_running(const MatchFolders& found) {
    if (options.delay == milliseconds(0)) return;
    for (const auto& [index, match] : found) {
      if (match.live) follow(index, match.path);
    }
  }

  // Readers of a stream have their share in it until they have its end.
  void forget_ended(const MatchFolders& found) {
    std::size_t ended = 0;
    for (auto& [index, match] : followed) {
      const auto now_at = found.find(index);
      const bool running = now_at != found.end() && now_at->second.live;
      match.ended = !running && match.match->over();
      if (match.ended) ++ended;
    }

    std::erase_if(followed, [&ended](const auto& match) {
      return match.second.ended && ended > kMaxEndedStreams && ended-- > 0;
    });
  }

  // Reads again a second later what cannot be read now, such as a store that `run` replaces.
  void refresh_regularly() {
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, kRefreshInterval, [this] { return stopped; })) {
      const bool rests = steady_clock::now() - asked > kRestAfter && over.load();
      if (rests) continue;
      lock.unlock();
      std::ignore = refresh();
      lock.lock();
    }
  }

  HttpReply front() const {
    return is_public ? document_reply(page) : viewer::page_reply(page->text);
  }

  HttpReply stream(int index, std::string_view query) const {
    const auto known = followed.find(index);
    if (known != followed.end()) return viewer::feed_reply(known->second.match->feed(), query);
    return is_public ? not_found() : not_found("the match is not played now");
  }

  HttpReply live_reply(int index, const fs::path& path) {
    follow(index, path);
    viewer::PageSettings settings;
    if (is_public) settings.home = kHome;
    const viewer::LivePaths paths{viewer::kStreamPath, is_public ? "" : viewer::kDrawingsPath};
    return viewer::page_reply(viewer::live_page(fmt::format("match {}", index), paths, settings));
  }

  HttpReply replay_reply(const fs::path& path) {
    const fs::path log = match::game_log_in(path);
    if (is_public) {
      HttpReply reply;
      reply.status = 200;
      reply.type = "text/html; charset=utf-8";
      reply.feed = shelf.page(log, kHome);
      return reply;
    }

    const auto read = viewer::read_log_or_page(log.string());
    if (!read || read->record.frames() == 0) return not_found("the match has no log");
    return viewer::page_reply(
        viewer::match_page(read->record, nullptr, log.filename().string(),
                           {.settings = {.missed = viewer::read_missed_decisions(path),
                                         .drawings = viewer::read_page_drawings(path)}}));
  }

  // "12/", "12/live" or "12/drawings-left".
  HttpReply match_reply(std::string_view path, std::string_view query) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    const auto index = base::parse_int(path.substr(0, slash));
    if (!index) return not_found();
    const auto found = folders.find(*index);
    if (found == folders.end() && !is_public) return not_found();

    const bool is_whole = slash == path.size();
    const std::string_view rest = is_whole ? "" : path.substr(slash + 1);
    if (rest == viewer::kStreamPath) return stream(*index, query);
    if (found == folders.end()) return not_found();
    if (is_whole) return is_public ? redirect_to(fmt::format("{}/", *index)) : not_found();

    const MatchFolder& match = found->second;
    if (!rest.empty()) {
      return is_public ? not_found() : viewer::drawings_reply(match.path, rest, query);
    }
    return match.live ? live_reply(*index, match.path) : replay_reply(match.path);
  }

  const fs::path folder;
  const SiteOptions options;
  const bool is_public;
  ReplayShelf shelf;

  // Used by the one who reads.
  std::string seen;  ///< fingerprint() of what was read
  TournamentState tournament;
  SpectatorPage public_view;
  viewer::MatchList list;
  std::optional<FirstLook> first_look;
  std::map<int, DelayedGlance> glances;
  std::atomic<int> views{0};

  mutable std::mutex mutex;
  std::condition_variable wake;
  bool stopped = false;
  steady_clock::time_point asked = steady_clock::now();
  std::shared_ptr<const viewer::HttpDocument> page;
  std::shared_ptr<const viewer::HttpDocument> now;
  MatchFolders folders;
  std::map<int, FollowedMatch> followed;
  std::atomic<bool> over{false};
  std::thread thread;
};

TournamentSite::TournamentSite(std::unique_ptr<State> state) : state_(std::move(state)) {}

base::Result<std::unique_ptr<TournamentSite>> TournamentSite::open(const fs::path& folder,
                                                                   const SiteOptions& options) {
  auto state = std::make_unique<State>(folder, options);
  if (state->is_public) {
    TRY(state->refresh());
    state->thread = std::thread([all = state.get()] { all->refresh_regularly(); });
  }
  return std::unique_ptr<TournamentSite>(new TournamentSite(std::move(state)));
}

TournamentSite::~TournamentSite() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stopped = true;
  }
  state_->wake.notify_all();
  if (state_->thread.joinable()) state_->thread.join();
}

int TournamentSite::views() const { return state_->views.load(); }

HttpReply TournamentSite::reply(std::string_view path, std::string_view query) {
  if (!state_->is_public) {
    if (const auto read = state_->refresh(); !read) return not_found(read.error().message);
  }

  const std::lock_guard lock(state_->mutex);
  state_->asked = steady_clock::now();
  if (path.empty()) return state_->front();
  if (path == "now" && state_->now) return document_reply(state_->now);

  constexpr std::string_view kMatch = "match/";
  if (!path.starts_with(kMatch)) return not_found();
  return state_->match_reply(path.substr(kMatch.size()), query);
}

}  // namespace cls::tournament
