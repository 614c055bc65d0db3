// Game log bytes that arrive while the match is played.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "base/result.h"

namespace cls::viewer {

/// Called by one thread.
class LiveInput {
 public:
  enum class State { kOpen, kEnded };

  virtual ~LiveInput() = default;

  /// Reads up to `size` bytes that are there into `to` and returns their number, without waiting.
  virtual std::size_t read(char* to, std::size_t size) = 0;

  /// Asked when there is nothing to read.
  virtual State state() = 0;

  /// True if state() reports the end without anything having been read: then reading may begin
  /// late.
  virtual bool knows_its_end() const { return false; }
};

/// The bytes of a game log that a server is still writing, plain or gzip; the file may not exist
/// yet. `complete` returns true once the writer has closed it; null: never. A log that shrinks has
/// ended: another one replaces it.
std::unique_ptr<LiveInput> follow_log(std::filesystem::path log, std::function<bool()> complete);

/// The same bytes, `delay` later. It has to be read from its beginning on to find the time of each
/// byte, so it does not wait for its first reader.
std::unique_ptr<LiveInput> delayed(std::unique_ptr<LiveInput> input,
                                   std::chrono::milliseconds delay);

/// Follows a running soccer server, as a monitor (version 5) that only watches. Repeated
/// frames before kick-off and after the match are left out. The input ends when the server has been
/// silent for 30 seconds. The error names the address.
base::Result<std::unique_ptr<LiveInput>> follow_server(const std::string& host, int port);

}  // namespace cls::viewer
