// Splits lines, counts repetitions, stops at the size limit.
#include "process/output_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>

#include "base/text/printable.h"

namespace cls::process {

OutputLog::OutputLog(base::UniqueFd file, std::size_t max_bytes,
                     std::function<void(std::string_view)> on_line)
    : file_(std::move(file)), room_(max_bytes), on_line_(std::move(on_line)) {}

void OutputLog::add(std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    const std::string_view piece = bytes.substr(0, end);
    if (!overlong_)
      partial_ += piece.substr(0, kMaxLineBytes - std::min(partial_.size(), kMaxLineBytes));

    if (partial_.size() >= kMaxLineBytes && !overlong_) {
      add_line(partial_);
      overlong_ = true;
    }

    if (end == std::string_view::npos) return;
    if (!overlong_) add_line(partial_);
    partial_.clear();
    overlong_ = false;
    bytes.remove_prefix(end + 1);
  }
}

void OutputLog::add_line(std::string_view line) {
  constexpr std::string_view kPadding("\0\r ", 3);  // programs print buffers of fixed size
  line = line.substr(0, line.find_last_not_of(kPadding) + 1);
  if (on_line_) on_line_(line);

  if (!last_.empty() && last_.back().text == line) {
    ++last_.back().times;
    return;
  }

  write_repetitions();
  last_.push_back({std::string(line), 1});
  if (last_.size() > kMaxLastLines) last_.pop_front();
  write(fmt::format("{}\n", line));
}

void OutputLog::write_repetitions() {
  if (!last_.empty() && last_.back().times > 1) write(fmt::format("  ×{}\n", last_.back().times));
}

void OutputLog::write(std::string_view text) {
  if (!file_) return;

  full_ = full_ || text.size() > room_;
  if (full_) {
    ++omitted_;
    return;
  }
  room_ -= text.size();

  while (!text.empty()) {
    const ssize_t written = ::write(file_.get(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      error_ = errno;
      file_.reset();
      return;
    }
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputLog::finish() {
  if (!partial_.empty() && !overlong_) add_line(partial_);
  partial_.clear();
  write_repetitions();

  if (full_) {
    std::string rest = fmt::format("[size limit of this log: {} lines left out]\n",
                                   omitted_ - std::min(omitted_, last_.size()));
    for (const std::string& line : last_lines()) rest += line + "\n";
    room_ = rest.size();
    full_ = false;
    write(rest);
  }
  file_.reset();
}

std::vector<std::string> OutputLog::last_lines(std::size_t count) const {
  std::vector<std::string> lines;
  for (std::size_t i = last_.size() - std::min(count, last_.size()); i < last_.size(); ++i) {
    lines.push_back(base::printable(last_[i].text));
    if (last_[i].times > 1) lines.back() += fmt::format(" ×{}", last_[i].times);
  }
  if (!partial_.empty() && !overlong_ && count > 0) lines.push_back(base::printable(partial_));
  return lines;
}

}  // namespace cls::process
