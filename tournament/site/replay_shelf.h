// Replay pages of matches, made on demand by a thread of its own.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "viewer/live/live_feed.h"

namespace cls::tournament {

/// Makes one page at a time, at the lowest priority, so that requests for many replays take no
/// processor core from a match. The pages of all readers together take a limited amount of memory:
/// those that were not asked for longest are forgotten, and made again when a reader asks.
class ReplayShelf {
 public:
  explicit ReplayShelf(std::size_t max_bytes);
  ~ReplayShelf();
  ReplayShelf(const ReplayShelf&) = delete;
  ReplayShelf& operator=(const ReplayShelf&) = delete;

  /// The page of the match whose game log is `log`, as a feed that gets its bytes when the page is
  /// made. A log that was written again has another page. `home` is a link to the page of the
  /// tournament.
  std::shared_ptr<const viewer::LiveFeed> page(const std::filesystem::path& log,
                                               const std::string& home);

  /// Bytes of the pages that are there.
  std::size_t bytes() const;

 private:
  /// A log, and when it was written.
  using Key = std::pair<std::filesystem::path, std::filesystem::file_time_type>;
  struct Page {
    Key key;
    std::string home;
    std::shared_ptr<viewer::LiveFeed> feed;
    std::size_t bytes = 0;  ///< 0: not made yet
  };
  using Pages = std::list<Page>;  ///< the latest request first

  void make_pages();
  void forget_old_pages();

  std::size_t max_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Pages pages_;
  std::map<Key, Pages::iterator> by_log_;
  std::deque<Key> orders_;
  std::size_t bytes_ = 0;
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace cls::tournament
