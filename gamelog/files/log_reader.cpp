// Detects text logs by their first bytes.
#include "gamelog/files/log_reader.h"

#include <string_view>

#include "base/io/input_buffer.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcl/rcl_reader.h"

namespace cls::gamelog {
namespace {

constexpr std::size_t kMaxStampLength = 24;

bool skip_digits(std::string_view& text) {
  const std::size_t size = text.size();
  while (!text.empty() && text.front() >= '0' && text.front() <= '9') text.remove_prefix(1);
  return text.size() < size;
}

// `time,stopped` and a tab, or only the time before server version 13.
bool starts_text_log(std::string_view text) {
  if (!skip_digits(text)) return false;

  if (text.starts_with(',')) {
    text.remove_prefix(1);
    if (!skip_digits(text)) return false;
  }

  return text.starts_with('\t');
}

}  // namespace

base::Result<AnyLog> read_log_file(const std::string& path) {
  TRY_INIT(auto source, base::open_source(path));
  base::InputBuffer input(*source);
  if (starts_text_log(input.peek(kMaxStampLength))) return AnyLog(read_rcl(input));
  return AnyLog(read_rcg(input));
}

}  // namespace cls::gamelog
