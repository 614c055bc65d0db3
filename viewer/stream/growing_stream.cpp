// Headers and frames in the order in which they come.
#include "viewer/stream/growing_stream.h"

namespace cls::viewer {

bool GrowingStream::append_new(std::string& out) {
  if (record_.frames() == writer_.frames()) return false;
  append_header(out);
  writer_.append_frames(record_, record_.frames(), out);
  return true;
}

void GrowingStream::append_statistics(std::string_view json, std::string& out) {
  writer_.append_statistics(json, out);
}

void GrowingStream::append_end(std::string_view statistics, std::string& out) {
  append_new(out);
  append_header(out);
  if (!statistics.empty()) append_statistics(statistics, out);
  writer_.append_end(record_, out);
}

// Parameters and player types come before the first frame, and rarely again.
void GrowingStream::append_header(std::string& out) {
  const std::size_t parts = 1 + record_.parameter_lines.size() + record_.types.size();
  if (parts == header_parts_) return;
  header_parts_ = parts;
  writer_.append_header(record_, out);
}

}  // namespace cls::viewer
