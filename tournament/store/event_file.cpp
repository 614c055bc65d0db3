// Append, then fdatasync.
#include "tournament/store/event_file.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "base/io/whole_file.h"
#include "base/system/host.h"
#include "base/text/json_text.h"

namespace cls::tournament {

using base::Error;
using base::Result;
using Json = nlohmann::ordered_json;

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
    lines = std::count(text->begin(), text->end(), '\n');
    whole = text->empty() || text->back() == '\n';
  }
  base::UniqueFd opened(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
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
  const ssize_t written = ::write(file_.get(), text.data(), text.size());
  if (written > 0) whole_ = text[static_cast<std::size_t>(written) - 1] == '\n';
  if (written >= 0 && written != static_cast<ssize_t>(text.size())) errno = ENOSPC;
  if (written != static_cast<ssize_t>(text.size()) || ::fdatasync(file_.get()) != 0) {
    return Error{fmt::format("cannot write {}: {}", name_, std::strerror(errno))};
  }
  return {};
}

}  // namespace cls::tournament
