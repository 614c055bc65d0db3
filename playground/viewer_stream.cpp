// Whole lines of the log become frames, frames become chunks.
#include "playground/viewer_stream.h"

#include "base/io/byte_source.h"
#include "base/io/input_buffer.h"
#include "gamelog/rcg/format_readers.h"

namespace cls::playground {

std::string ViewerStream::take(bool complete) {
  std::string chunks;
  if (ended_) return chunks;
  read_lines();
  stream_.append_new(chunks);
  if (complete) stream_.append_end("", chunks);
  ended_ = complete;
  return chunks;
}

void ViewerStream::read_lines() {
  std::string_view lines = std::string_view(unread_).substr(0, unread_.rfind('\n') + 1);
  if (lines.empty()) return;

  const std::size_t size = lines.size();
  if (!has_header_) {
    constexpr std::string_view kHeader = "ULG";
    const std::size_t end = lines.find('\n');
    record_.version = static_cast<gamelog::RcgVersion>(lines[kHeader.size()] - '0');
    lines.remove_prefix(end + 1);
    has_header_ = true;
  }

  base::MemorySource source(lines);
  base::InputBuffer input(source);
  gamelog::read_rcg_text(input, builder_);
  unread_.erase(0, size);
}

}  // namespace cls::playground
