// Empties the record whenever the reader asks for more bytes, because its frames are complete then.
#include "gamelog/rcg/frame_stream.h"

#include "gamelog/rcg/rcg_reader.h"

namespace cls::gamelog {
namespace {

// Readers compare the next frame with the time of the last one, and the play mode of the last frame
// tells whether a log is complete. The other columns of the frame that stays are not those of the
// last one.
void keep_last_frame(MatchRecord& record) {
  if (record.frames() < 2) return;
  record.time.front() = record.time.back();
  record.stopped.front() = record.stopped.back();
  record.mode.front() = record.mode.back();
  record.team_state.front() = record.team_state.back();
  resize_frames(record, 1);
}

}  // namespace

// Hands out the bytes of another source, and the frames of the record before each read.
class FrameStream::DrainingSource : public base::ByteSource {
 public:
  DrainingSource(base::ByteSource& inner, MatchRecord& record, FrameListener& listener)
      : inner_(inner), record_(record), listener_(listener) {}

  std::size_t read(char* to, std::size_t size) override {
    drain();
    const std::size_t count = inner_.read(to, size);
    if (count == 0 && !inner_.error().empty()) fail(inner_.error());
    return count;
  }

  void drain() {
    for (; kept_ < record_.frames(); ++kept_) {
      listener_.on_frame(record_, kept_);
      ++passed_on_;
    }

    keep_last_frame(record_);
    kept_ = record_.frames();
    std::erase_if(record_.notes, [](const Note& note) { return !is_result(note); });
  }

  std::size_t passed_on() const { return passed_on_; }

 private:
  base::ByteSource& inner_;
  MatchRecord& record_;
  FrameListener& listener_;
  std::size_t kept_ = 0;  // frames at the start of the record that were passed on
  std::size_t passed_on_ = 0;
};

FrameStream::FrameStream(base::ByteSource& source, FrameListener& listener)
    : draining_(std::make_unique<DrainingSource>(source, record_, listener)), input_(*draining_) {}

FrameStream::~FrameStream() = default;

const MatchRecord& FrameStream::read_all() {
  read_rcg(input_, record_);
  draining_->drain();
  resize_frames(record_, 0);
  return record_;
}

std::size_t FrameStream::frames() const { return draining_->passed_on(); }

}  // namespace cls::gamelog
