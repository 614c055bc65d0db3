// One thread reads the folder and publishes documents; the server's thread looks them up.
#include "tournament/spectators/spectator_site.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "base/text/number_text.h"
#include "match/result/match_files.h"
#include "tournament/spectators/replay_shelf.h"
#include "tournament/spectators/spectator_view.h"
#include "viewer/live/live_match.h"
#include "viewer/live/live_site.h"
#include "viewer/page/encoding.h"

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

HttpReply not_found() {
  HttpReply reply;
  reply.body = "not found\n";
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

// A folder of a stranger may name any other one in its results, and hold links to any other one.
bool is_inside(const fs::path& file, const fs::path& tournament) {
  std::error_code code;
  const fs::path whole = fs::canonical(file, code);
  const fs::path root = code ? fs::path() : fs::canonical(tournament, code);
  if (code) return false;
  return std::mismatch(root.begin(), root.end(), whole.begin(), whole.end()).first == root.end();
}

}  // namespace

struct SpectatorSite::State {
  /// What a match shows besides its place in the schedule.
  struct MatchFolder {
    fs::path path;
    bool running = false;
  };

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

  State(fs::path tournament, const SpectatorOptions& given)
      : folder(std::move(tournament)), options(given), shelf(given.max_replay_bytes) {}

  base::Result<void> refresh();
  void refresh_regularly();
  void add_folders(const TournamentState& tournament, SpectatorPage& page,
                   std::map<int, MatchFolder>& found);
  void follow_running(const std::map<int, MatchFolder>& found);
  void follow(int index, const fs::path& path);
  void forget_ended(const std::map<int, MatchFolder>& found);

  HttpReply match_reply(std::string_view path, std::string_view query);
  HttpReply stream(int index, std::string_view query);

  const fs::path folder;
  const SpectatorOptions options;
  ReplayShelf shelf;
  std::map<int, DelayedGlance> glances;  ///< used by the reading thread

  mutable std::mutex mutex;
  std::condition_variable wake;
  bool stopped = false;
  steady_clock::time_point asked = steady_clock::now();
  std::shared_ptr<const viewer::HttpDocument> page;
  std::shared_ptr<const viewer::HttpDocument> now;
  std::map<int, MatchFolder> folders;
  std::map<int, FollowedMatch> followed;
  std::atomic<bool> over{false};
  std::thread thread;
};

// Sets what follows from the logs. Matches without a result have no replay: the run may play them
// again.
void SpectatorSite::State::add_folders(const TournamentState& tournament, SpectatorPage& shown,
                                       std::map<int, MatchFolder>& found) {
  for (const ScheduledMatch& match : tournament.matches) {
    const bool running = std::binary_search(tournament.running.begin(), tournament.running.end(),
                                            match.fixture.index);
    if (!match.outcome && !running) continue;
    if (match.outcome && (match.outcome->folder.empty() || match.outcome->invalid())) continue;
    const fs::path inside =
        match.outcome ? fs::path(match.outcome->folder)
                      : match_folder(tournament.config, match.fixture, std::max(1, match.attempts));
    if (!is_inside(match::game_log_in(folder / inside), folder)) continue;
    found[match.fixture.index] = {folder / inside, !match.outcome};
  }

  const auto has_page = [&found](const SpectatorMatch& match) {
    return found.contains(match.index);
  };
  for (auto& group : shown.results) {
    for (SpectatorMatch& match : group.content) match.has_page = has_page(match);
  }

  std::map<int, DelayedGlance> looked;
  for (SpectatorMatch& match : shown.running) {
    match.has_page = has_page(match);
    if (!match.has_page) continue;
    const fs::path log = match::game_log_in(found[match.index].path);
    auto known = glances.extract(match.index);
    DelayedGlance glance = !known.empty() && known.mapped().log == log
                               ? std::move(known.mapped())
                               : DelayedGlance{log, viewer::LogGlance(log)};
    match.glance = glance.before(options.delay);
    if (match.glance) match.score = fmt::format("{} : {}", match.glance->left, match.glance->right);
    looked.emplace(match.index, std::move(glance));
  }
  glances = std::move(looked);
}

void SpectatorSite::State::follow(int index, const fs::path& path) {
  const auto known = followed.find(index);
  if (known != followed.end() && known->second.folder == path) return;
  auto input =
      viewer::follow_log(match::game_log_in(path), [path] { return match::has_result(path); });
  if (options.delay > milliseconds(0)) input = viewer::delayed(std::move(input), options.delay);
  followed[index] = {path, std::make_unique<viewer::LiveMatch>(std::move(input)), false};
}

// With a delay a match is read from its start on, not from the first reader on.
void SpectatorSite::State::follow_running(const std::map<int, MatchFolder>& found) {
  if (options.delay == milliseconds(0)) return;
  for (const auto& [index, match] : found) {
    if (match.running) follow(index, match.path);
  }
}

// Readers of a stream have their share in it until they have its end.
void SpectatorSite::State::forget_ended(const std::map<int, MatchFolder>& found) {
  std::size_t ended = 0;
  for (auto& [index, match] : followed) {
    const auto now_at = found.find(index);
    const bool running = now_at != found.end() && now_at->second.running;
    match.ended = !running && match.match->over();
    if (match.ended) ++ended;
  }
  for (auto match = followed.begin(); match != followed.end() && ended > kMaxEndedStreams;) {
    if (!match->second.ended) {
      ++match;
      continue;
    }
    match = followed.erase(match);
    --ended;
  }
}

base::Result<void> SpectatorSite::State::refresh() {
  TRY_INIT(const auto tournament, read_tournament(folder));
  SpectatorPage shown = spectator_view(tournament, folder);
  std::map<int, MatchFolder> found;
  add_folders(tournament, shown, found);

  // The running matches change all the time, and are a document of their own.
  auto without_running = shown;
  for (SpectatorMatch& match : without_running.running) match.glance.reset();
  for (SpectatorMatch& match : without_running.running) match.score.clear();
  const std::string rest =
      viewer::sha256_hex(spectator_page(without_running, "")).substr(0, kTagLength);
  auto made_page = document(spectator_page(shown, rest));
  auto made_now = document(spectator_now(shown, rest));

  const std::lock_guard lock(mutex);
  follow_running(found);
  forget_ended(found);
  page = std::move(made_page);
  now = std::move(made_now);
  folders = std::move(found);
  over.store(shown.over);
  return {};
}

// What cannot be read, such as a store that `run` replaces, may be readable a second later.
void SpectatorSite::State::refresh_regularly() {
  std::unique_lock lock(mutex);
  while (!wake.wait_for(lock, kRefreshInterval, [this] { return stopped; })) {
    const bool rests = steady_clock::now() - asked > kRestAfter && over.load();
    if (rests) continue;
    lock.unlock();
    static_cast<void>(refresh());
    lock.lock();
  }
}

HttpReply SpectatorSite::State::stream(int index, std::string_view query) {
  const auto known = followed.find(index);
  if (known == followed.end()) return not_found();
  return viewer::feed_reply(known->second.match->feed(), query);
}

// "12/" or "12/live".
HttpReply SpectatorSite::State::match_reply(std::string_view path, std::string_view query) {
  const std::size_t slash = std::min(path.find('/'), path.size());
  const auto index = base::parse_int(path.substr(0, slash));
  if (!index) return not_found();
  if (slash < path.size() && path.substr(slash + 1) == viewer::kStreamPath) {
    return stream(*index, query);
  }

  const auto found = folders.find(*index);
  if (found == folders.end()) return not_found();
  if (slash == path.size()) return redirect_to(fmt::format("{}/", *index));
  if (!path.substr(slash + 1).empty()) return not_found();

  const MatchFolder& match = found->second;
  if (match.running) {
    follow(*index, match.path);
    viewer::PageSettings settings;
    settings.home = kHome;
    return viewer::page_reply(
        viewer::live_page(fmt::format("match {}", *index), {viewer::kStreamPath, ""}, settings));
  }
  HttpReply reply;
  reply.status = 200;
  reply.type = "text/html; charset=utf-8";
  reply.feed = shelf.page(match::game_log_in(match.path), kHome);
  return reply;
}

SpectatorSite::SpectatorSite(std::unique_ptr<State> state) : state_(std::move(state)) {}

base::Result<std::unique_ptr<SpectatorSite>> SpectatorSite::open(const fs::path& folder,
                                                                 const SpectatorOptions& options) {
  auto state = std::make_unique<State>(folder, options);
  if (const auto read = state->refresh(); !read) return read.error();
  state->thread = std::thread([all = state.get()] { all->refresh_regularly(); });
  return std::unique_ptr<SpectatorSite>(new SpectatorSite(std::move(state)));
}

SpectatorSite::~SpectatorSite() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->stopped = true;
  }
  state_->wake.notify_all();
  if (state_->thread.joinable()) state_->thread.join();
}

HttpReply SpectatorSite::reply(std::string_view path, std::string_view query) {
  const std::lock_guard lock(state_->mutex);
  state_->asked = steady_clock::now();
  if (path.empty()) return document_reply(state_->page);
  if (path == "now") return document_reply(state_->now);

  constexpr std::string_view kMatch = "match/";
  if (!path.starts_with(kMatch)) return not_found();
  return state_->match_reply(path.substr(kMatch.size()), query);
}

}  // namespace cls::tournament
