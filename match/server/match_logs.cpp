// Opens, closes and converts the logs of a match folder.
#include "match/server/match_logs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/io/background_sink.h"
#include "base/io/disk_space.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcg/rcg_writer.h"
#include "gamelog/rcg/record_writer.h"
#include "match/result/match_folder.h"
#include "match/server/server_logs.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;
using base::Result;

constexpr std::chrono::milliseconds kFlushInterval{50};

int level(int compression) { return std::clamp(compression, 0, 9); }

// Writes the game log again, in another version.
Result<void> convert_game_log(const fs::path& file, gamelog::RcgVersion version) {
  TRY_INIT(const auto record, gamelog::read_rcg_file(file.string()));
  TRY_INIT(auto sink, base::FileSink::create(file.string()));
  gamelog::write_rcg(record, version, *sink);
  return sink->close();
}

// Compresses the log `name` of the folder, and corrects its name.
Result<void> compress_log(const fs::path& folder, int compression, std::string& name) {
  if (name.empty() || level(compression) == 0) return {};
  const auto done = base::compress_file((folder / name).string(), level(compression));
  if (done) name += base::compressed_suffix(level(compression));
  return done;
}

/// Writes to `inner` and flushes it now and then, for readers that follow the log of a running
/// match.
class FlushedSink : public base::ByteSink {
 public:
  explicit FlushedSink(std::unique_ptr<base::ByteSink> inner) : inner_(std::move(inner)) {}

  void write(std::string_view bytes) override {
    inner_->write(bytes);
    const auto now = std::chrono::steady_clock::now();
    if (now - flushed_ < kFlushInterval) return;
    flushed_ = now;
    inner_->flush();
  }
  void flush() override { inner_->flush(); }
  Result<void> close() override { return inner_->close(); }

 private:
  std::unique_ptr<base::ByteSink> inner_;
  std::chrono::steady_clock::time_point flushed_{};
};

}  // namespace

std::string running_game_log(const MatchOptions& options) {
  if (!options.server.game_logging) return "";
  const int compression =
      mode_of(options) == MatchMode::kLockstep ? level(options.server.game_log_compression) : 0;
  return fmt::format("{}{}", kGameLogFile, base::compressed_suffix(compression));
}

Result<MatchLogs> MatchLogs::create(const fs::path& folder, const soccer::ServerParams& params,
                                    bool keep_space) {
  MatchLogs logs;
  const auto open = [&](bool wanted, const char* file, int compression, std::string& name,
                        std::unique_ptr<base::ByteSink>& sink) -> Result<void> {
    if (!wanted) return {};

    name = std::string(file).append(base::compressed_suffix(level(compression)));
    TRY_INIT(auto created, base::create_log_file((folder / name).string(), level(compression)));
    sink = std::move(created);
    if (!keep_space) return {};
    logs.kept_.push_back(folder / name);
    base::reserve_space(folder / name, kSpaceOfLog);
    return {};
  };

  TRY(open(params.game_logging, kGameLogFile, params.game_log_compression, logs.game_name_,
           logs.game_));
  if (logs.game_ != nullptr) logs.game_ = std::make_unique<FlushedSink>(std::move(logs.game_));
  TRY(open(params.text_logging, kTextLogFile, params.text_log_compression, logs.text_name_,
           logs.text_));
  return logs;
}

Result<void> MatchLogs::close(MatchResult& result) {
  result.rcg = game_name_;
  result.rcl = text_name_;
  Result<void> first;
  for (base::ByteSink* sink : {game_.get(), text_.get()}) {
    if (sink == nullptr) continue;
    auto closed = sink->close();
    if (first) first = std::move(closed);
  }
  std::ranges::for_each(kept_, base::release_space);
  return first;
}

Result<void> convert_server_logs(const fs::path& folder, const soccer::ServerParams& params,
                                 MatchResult& result) {
  std::error_code code;
  if (!params.game_logging && !result.rcg.empty()) {
    fs::remove(folder / result.rcg, code);
    result.rcg.clear();
  }

  const auto version = gamelog::rcg_version(params.game_log_version);
  if (!result.rcg.empty() && version && *version != gamelog::RcgVersion::kV6) {
    TRY(convert_game_log(folder / result.rcg, *version));
  }
  auto game = compress_log(folder, params.game_log_compression, result.rcg);
  auto text = compress_log(folder, params.text_log_compression, result.rcl);
  return game ? text : game;
}

}  // namespace cls::match
