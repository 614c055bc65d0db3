// Follows a running match and turns it into a stream for viewers.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>

#include "viewer/live/live_feed.h"
#include "viewer/live/live_input.h"

namespace cls::viewer {

/// Reads the match on a thread of its own, from a file or a monitor connection: the match does not
/// know of it. The thread yields to the match, and it does not read at all before the first reader
/// of the feed comes, if the input reports the end of the match without being read. The stream has
/// the frames as they arrive, statistics now and then, and an end once the match is over: with its
/// result in the log, or when the input ends.
class LiveMatch {
 public:
  /// Statistics take some 100 ms of a processor core; seldom enough not to slow the match.
  static constexpr std::chrono::milliseconds kStatisticsInterval{10'000};

  /// `text_log` is the text log of the same match, read at the end if it exists; may be empty.
  explicit LiveMatch(std::unique_ptr<LiveInput> input, std::filesystem::path text_log = {},
                     std::chrono::milliseconds statistics_interval = kStatisticsInterval);
  /// Ends the stream with what was read.
  ~LiveMatch();
  LiveMatch(const LiveMatch&) = delete;
  LiveMatch& operator=(const LiveMatch&) = delete;

  const std::shared_ptr<const LiveFeed>& feed() const { return readers_; }
  /// True after the end of the match. Readers may still get what they have not received yet.
  bool over() const { return over_.load(); }

 private:
  bool wait_for_reader();
  void follow();

  std::unique_ptr<LiveInput> input_;
  std::filesystem::path text_log_;
  std::chrono::milliseconds statistics_interval_;
  std::shared_ptr<LiveFeed> feed_;
  std::shared_ptr<const LiveFeed> readers_;
  std::atomic<bool> stop_{false};
  std::atomic<bool> over_{false};
  std::thread thread_;
};

}  // namespace cls::viewer
