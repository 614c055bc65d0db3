// Bytes behind a mutex.
#include "viewer/live/live_feed.h"

namespace cls::viewer {

void LiveFeed::append(std::string_view bytes) {
  {
    const std::lock_guard lock(mutex_);
    bytes_ += bytes;
  }
  changed_.notify_all();
}

void LiveFeed::finish() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  changed_.notify_all();
}

LiveFeed::Piece LiveFeed::read(std::size_t from, std::size_t max) const {
  const std::lock_guard lock(mutex_);
  note_reader();
  Piece piece;
  if (from < bytes_.size()) piece.bytes = bytes_.substr(from, max);
  piece.ended = finished_ && from + piece.bytes.size() >= bytes_.size();
  return piece;
}

bool LiveFeed::wait(std::size_t from, std::chrono::milliseconds timeout) const {
  std::unique_lock lock(mutex_);
  note_reader();
  return changed_.wait_for(lock, timeout, [&] { return finished_ || from < bytes_.size(); });
}

bool LiveFeed::wait_for_reader(std::chrono::milliseconds timeout) const {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, timeout, [&] { return has_reader_; });
}

void LiveFeed::note_reader() const {
  if (has_reader_) return;
  has_reader_ = true;
  changed_.notify_all();
}

}  // namespace cls::viewer
