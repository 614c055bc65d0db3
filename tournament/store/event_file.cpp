// Append, then fdatasync.
#include "tournament/store/event_file.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <optional>
#include <system_error>

#include "base/index.h"
#include "base/io/whole_file.h"
#include "base/system/host.h"
#include "base/text/json.h"
#include "base/text/json_text.h"

namespace cls::tournament {

using base::Error;
using base::Json;
using base::Result;

namespace {

base::UniqueFd open_to_append(const std::filesystem::path& file) {
  return base::UniqueFd(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
}

// One write appends a whole line, wherever the others are. Returns the bytes that were written;
// unless these are all, errno says why.
std::size_t append(const base::UniqueFd& file, std::string_view text) {
  const ssize_t written = ::write(file.get(), text.data(), text.size());
  if (written >= 0 && written != std::ssize(text)) errno = ENOSPC;
  return written < 0 ? 0 : base::index(written);
}

Error write_error(const std::string& file) {
  return Error{fmt::format("cannot write {}: {}", file, std::strerror(errno))};
}

}  // namespace

EventFile::EventFile(base::UniqueFd file, std::string name, std::int64_t lines, bool whole)
    : file_(std::move(file)),
      name_(std::move(name)),
      next_(lines + (whole ? 0 : 1)),
      whole_(whole),
      begin_(std::chrono::steady_clock::now()) {}

Result<EventFile> EventFile::open(const std::filesystem::path& file) {
  std::int64_t lines = 0;
  bool whole = true;
  std::error_code code;
  const bool regular = std::filesystem::is_regular_file(file, code);
  if (const auto text = regular ? base::read_file(file) : std::nullopt) {
    lines = std::ranges::count(*text, '\n');
    whole = text->empty() || text->back() == '\n';
  }

  base::UniqueFd opened = open_to_append(file);
  if (!opened) {
    return Error{fmt::format("cannot create {}: {}", file.string(), std::strerror(errno))};
  }
  return EventFile(std::move(opened), file.string(), lines, whole);
}

Result<void> EventFile::add(std::string_view type, const Json& fields) {
  const double t = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  Json line = {{"schema", "cls.events/1"},
               {"seq", next_++},
               {"t", std::round(t * 1000) / 1000},
               {"time", base::utc_now()},
               {"type", type}};
  line.update(fields);

  const std::string text = (whole_ ? "" : "\n") + base::json_line(line) + "\n";
  const std::size_t written = append(file_, text);
  if (written > 0) whole_ = text[written - 1] == '\n';
  if (written != text.size() || ::fdatasync(file_.get()) != 0) return write_error(name_);
  return {};
}

Result<void> append_line(const std::filesystem::path& file, std::string_view line) {
  const base::UniqueFd opened = open_to_append(file);
  const std::string text = std::string(line) + "\n";
  if (!opened || append(opened, text) != text.size()) return write_error(file.string());
  return {};
}

}  // namespace cls::tournament
