// A queue of bytes between the writer and its thread.
#include "base/io/background_sink.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <utility>

#include "base/io/gzip_sink.h"
#include "base/io/whole_file.h"

namespace cls::base {
namespace {

constexpr std::size_t kBlockSize = 256 * 1024;

}  // namespace

BackgroundSink::BackgroundSink(std::unique_ptr<ByteSink> inner)
    : inner_(std::move(inner)), thread_([this] { loop(); }) {}

BackgroundSink::~BackgroundSink() { [[maybe_unused]] const Result<void> closed = close(); }

void BackgroundSink::write(std::string_view bytes) {
  block_ += bytes;
  if (block_.size() >= kBlockSize) hand_over();
}

Result<void> BackgroundSink::close() {
  if (thread_.joinable()) {
    hand_over();
    {
      const std::lock_guard lock(mutex_);
      closing_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  return inner_->close();
}

void BackgroundSink::hand_over() {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() <= kMaxWaiting; });
    waiting_ += block_;
  }
  changed_.notify_all();
  block_.clear();
}

void BackgroundSink::loop() {
  std::string taken;
  while (true) {
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return closing_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      taken.swap(waiting_);
    }
    changed_.notify_all();
    inner_->write(taken);
    taken.clear();
  }
}

std::string_view compressed_suffix(int level) { return level > 0 ? ".gz" : ""; }

Result<std::unique_ptr<ByteSink>> create_log_file(const std::string& path, int level) {
  TRY_INIT(auto file, FileSink::create(path));
  if (level <= 0) return std::unique_ptr<ByteSink>(std::move(file));
  auto gzip = std::make_unique<GzipSink>(std::move(file), level);
  return std::unique_ptr<ByteSink>(std::make_unique<BackgroundSink>(std::move(gzip)));
}

Result<void> compress_file(const std::string& path, int level) {
  const auto text = read_file(path);
  if (!text) return Error{fmt::format("cannot read {}", path)};

  TRY_INIT(auto file, FileSink::create(path + ".gz"));
  GzipSink gzip(std::move(file), level);
  gzip.write(*text);
  if (const auto closed = gzip.close(); !closed) return closed;

  std::error_code code;
  std::filesystem::remove(path, code);
  return {};
}

}  // namespace cls::base
