// Output that is compressed and written by a thread of its own.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "base/io/byte_sink.h"
#include "base/result.h"

namespace cls::base {

/// Passes everything to `inner` on another thread, in the same order. write() waits only while
/// more than kMaxWaiting bytes are not yet written. close() waits for all and returns the first
/// error of `inner`.
class BackgroundSink : public ByteSink {
 public:
  static constexpr std::size_t kMaxWaiting = 16 << 20;

  explicit BackgroundSink(std::unique_ptr<ByteSink> inner);
  ~BackgroundSink() override;
  BackgroundSink(const BackgroundSink&) = delete;
  BackgroundSink& operator=(const BackgroundSink&) = delete;

  void write(std::string_view bytes) override;
  Result<void> close() override;

 private:
  void hand_over();
  void loop();

  std::unique_ptr<ByteSink> inner_;
  std::string block_;  ///< collects small writes
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string waiting_;
  bool closing_ = false;
  std::thread thread_;
};

/// Suffix of the name of a log with this compression level (0 to 9): ".gz", empty for 0.
std::string_view compressed_suffix(int level);

/// A new log file. Level 0: plain, written by the caller's thread; 1 to 9: gzip, in the background.
Result<std::unique_ptr<ByteSink>> create_log_file(const std::string& path, int level);

/// Replaces the plain file `path` by `path`.gz.
Result<void> compress_file(const std::string& path, int level);

}  // namespace cls::base
