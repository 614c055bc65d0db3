// One reader per way in which languages print exceptions.
#include "process/printed_exception.h"

#include <algorithm>
#include <vector>

#include "base/index.h"
#include "base/text/lines.h"
#include "base/text/number_text.h"
#include "base/text/printable.h"
#include "base/text/trimmed.h"

namespace cls::process {
namespace {

using Lines = std::vector<std::string_view>;

constexpr std::string_view kTraceback = "Traceback (most recent call last):";
constexpr std::string_view kCount = "  ×";

bool is_indented(std::string_view line) {
  return !line.empty() && (line.front() == ' ' || line.front() == '\t');
}

// "    at decide (playmaker.js:12:3)", "\tat Playmaker.decide(Playmaker.java:12)".
bool is_stack_frame(std::string_view line) {
  return is_indented(line) && base::trimmed(line).starts_with("at ") &&
         line.find_first_of("(:") != std::string_view::npos;
}

// The line that ends the traceback; of chained exceptions the last.
std::string_view python_exception(const Lines& lines, std::size_t traceback) {
  std::size_t at = traceback + 1;
  while (at < lines.size() && (lines[at].empty() || is_indented(lines[at]))) ++at;
  if (at >= lines.size()) return {};

  const bool chained = at + 2 < lines.size() && lines[at + 1].empty() &&
                       (lines[at + 2].starts_with("During handling of the above exception") ||
                        lines[at + 2].starts_with("The above exception was the direct cause"));
  for (std::size_t next = at + 3; chained && next < lines.size(); ++next) {
    if (lines[next] != kTraceback) continue;
    const std::string_view last = python_exception(lines, next);
    return last.empty() ? lines[at] : last;
  }

  return lines[at];
}

// The line before the frames; of causes the last.
std::string_view stack_trace_exception(const Lines& lines, std::size_t first_frame) {
  constexpr std::string_view kCausedBy = "Caused by: ";
  std::string_view exception = base::trimmed(lines[first_frame - 1]);

  for (std::size_t i = first_frame; i < lines.size(); ++i) {
    if (lines[i].starts_with(kCausedBy)) {
      exception = lines[i].substr(kCausedBy.size());
    } else if (!is_indented(lines[i])) {
      break;
    }
  }
  return exception;
}

bool is_go_panic(const Lines& lines, std::size_t at) {
  if (!lines[at].starts_with("panic: ") && !lines[at].starts_with("fatal error: ")) return false;
  for (std::size_t i = at + 1; i < std::min(at + 6, lines.size()); ++i) {
    if (lines[i].starts_with("goroutine ")) return true;
  }
  return false;
}

// The exception that line `at` begins; empty: none.
std::string_view exception_at(const Lines& lines, std::size_t at) {
  const std::string_view line = lines[at];
  const std::string_view next = at + 1 < lines.size() ? lines[at + 1] : std::string_view();

  if (line == kTraceback) return python_exception(lines, at);
  if (is_go_panic(lines, at)) return line;
  if (line.starts_with("terminate called ")) {
    return base::trimmed(next).starts_with("what():") ? base::trimmed(next) : line;
  }
  if (line.starts_with("thread '") && line.find("panicked at") != std::string_view::npos) {
    return next.empty() ? line : next;
  }

  const bool titles_frames = !line.empty() && !is_stack_frame(line) && is_stack_frame(next);
  return titles_frames ? stack_trace_exception(lines, at + 1) : std::string_view();
}

}  // namespace

std::string printed_exception(std::string_view log) {
  const Lines lines = base::lines_of(log);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view found = exception_at(lines, i);
    if (!found.empty()) return base::printable(found);
  }
  return {};
}

RepeatedLine most_repeated_line(std::string_view log) {
  RepeatedLine most;
  std::string_view before;
  for (const std::string_view line : base::lines_of(log)) {
    int times = 0;
    if (line.starts_with(kCount)) base::parse_int_prefix(line.substr(kCount.size()), times);
    if (const std::size_t count = base::index(std::max(times, 0)); count > most.times) {
      most = {base::printable(before), count};
    }
    before = line;
  }
  return most;
}

}  // namespace cls::process
