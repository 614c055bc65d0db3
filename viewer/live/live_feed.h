// The stream of a match that is still played, in memory.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

namespace cls::viewer {

/// One thread writes, any number of threads read, each at its own place and speed. All bytes stay,
/// so a late reader gets the whole match, and a slow one costs no more than the others.
class LiveFeed {
 public:
  struct Piece {
    std::string bytes;
    bool ended = false;  ///< no byte follows these
  };

  void append(std::string_view bytes);
  /// Called once, after the last append().
  void finish();

  /// Up to `max` bytes from the offset `from` on; none if they are not there yet.
  Piece read(std::size_t from, std::size_t max) const;

  /// Waits until there are bytes at `from`, or none will come. False after `timeout`.
  bool wait(std::size_t from, std::chrono::milliseconds timeout) const;

  /// Waits for the first reader. False after `timeout`.
  bool wait_for_reader(std::chrono::milliseconds timeout) const;

 private:
  void note_reader() const;

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::string bytes_;
  bool finished_ = false;
  mutable bool has_reader_ = false;
};

}  // namespace cls::viewer
