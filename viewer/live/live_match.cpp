// A source that waits for its input, and writes what was read so far whenever it waits.
#include "viewer/live/live_match.h"

#include <sys/resource.h>
#include <unistd.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "base/io/byte_source.h"
#include "base/io/input_buffer.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcl/rcl_reader.h"
#include "gamelog/record/match_record.h"
#include "viewer/page/match_page.h"
#include "viewer/stream/growing_stream.h"

namespace cls::viewer {
namespace {

constexpr std::chrono::milliseconds kPollInterval{20};
constexpr std::chrono::milliseconds kRestAfterResult{500};

// The result comes after the last frame; rcssserver writes the teams once more after it.
bool has_result(const gamelog::MatchRecord& record) {
  for (auto note = record.notes.rbegin(); note != record.notes.rend(); ++note) {
    if (note->frame < record.frames()) return false;
    const auto* message = std::get_if<gamelog::Message>(&note->content);
    if (message != nullptr && message->text.starts_with("(result ")) return true;
  }
  return false;
}

/// Appends the frames of a growing record to a feed.
class Publisher {
 public:
  Publisher(const gamelog::MatchRecord& record, LiveFeed& feed,
            std::chrono::milliseconds statistics_interval)
      : record_(record), feed_(feed), statistics_interval_(statistics_interval) {}

  void publish() {
    std::string bytes;
    if (!stream_.append_new(bytes)) return;

    const auto now = std::chrono::steady_clock::now();
    if (now - counted_ >= statistics_interval_) {
      counted_ = now;
      stream_.append_statistics(match_statistics(record_, nullptr, ""), bytes);
    }
    feed_.append(bytes);
  }

  void end(const gamelog::RclRecord* text) {
    std::string bytes;
    stream_.append_end(record_.frames() > 0 ? match_statistics(record_, text, "") : "", bytes);
    feed_.append(bytes);
  }

 private:
  const gamelog::MatchRecord& record_;
  LiveFeed& feed_;
  std::chrono::milliseconds statistics_interval_;
  std::chrono::steady_clock::time_point counted_ = std::chrono::steady_clock::now();
  GrowingStream stream_{record_};
};

class WaitingSource : public base::ByteSource {
 public:
  WaitingSource(LiveInput& input, const gamelog::MatchRecord& record, Publisher& publisher,
                const std::atomic<bool>& stop)
      : input_(input), record_(record), publisher_(publisher), stop_(stop) {}

  std::size_t read(char* to, std::size_t size) override {
    for (int polls = 0; !stop_.load(); std::this_thread::sleep_for(kPollInterval)) {
      const std::size_t count = input_.read(to, size);
      if (count > 0) return count;
      if (polls++ == 0) publisher_.publish();
      if (input_.state() == LiveInput::State::kEnded || rests_after_result(polls)) return 0;
    }
    return 0;
  }

 private:
  // Some lines follow the result, on a busy host a moment later.
  bool rests_after_result(int polls) const {
    return !input_.knows_its_end() && polls > kRestAfterResult / kPollInterval &&
           has_result(record_);
  }

  LiveInput& input_;
  const gamelog::MatchRecord& record_;
  Publisher& publisher_;
  const std::atomic<bool>& stop_;
};

// The match needs the processor cores more than those who watch it.
void yield_to_others() {
  constexpr int kNice = 10;
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
}

std::optional<gamelog::RclRecord> read_text_log(const std::filesystem::path& file) {
  std::error_code code;
  if (file.empty() || !std::filesystem::exists(file, code)) return std::nullopt;
  auto text = gamelog::read_rcl_file(file.string());
  if (!text) return std::nullopt;
  return *std::move(text);
}

}  // namespace

LiveMatch::LiveMatch(std::unique_ptr<LiveInput> input, std::filesystem::path text_log,
                     std::chrono::milliseconds statistics_interval)
    : input_(std::move(input)),
      text_log_(std::move(text_log)),
      statistics_interval_(statistics_interval),
      feed_(std::make_shared<LiveFeed>()),
      readers_(feed_),
      thread_([this] { follow(); }) {}

LiveMatch::~LiveMatch() {
  stop_.store(true);
  thread_.join();
}

// False when no reader came until the object ends.
bool LiveMatch::wait_for_reader() {
  while (input_->knows_its_end() && !feed_->wait_for_reader(kPollInterval)) {
    if (input_->state() == LiveInput::State::kEnded) over_.store(true);
    if (stop_.load()) return false;
  }
  return true;
}

void LiveMatch::follow() {
  yield_to_others();
  if (!wait_for_reader()) return feed_->finish();

  gamelog::MatchRecord record;
  Publisher publisher(record, *feed_, statistics_interval_);
  // Detecting gzip reads from the source, which waits until the log begins.
  const auto source =
      base::decompress(std::make_unique<WaitingSource>(*input_, record, publisher, stop_));
  base::InputBuffer buffer(*source);
  gamelog::read_rcg(buffer, record);

  const auto text = read_text_log(text_log_);
  publisher.end(text ? &*text : nullptr);
  feed_->finish();
  over_.store(true);
}

}  // namespace cls::viewer
