// events.jsonl of a tournament: one JSON object a line, synced to disk.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "base/system/unique_fd.h"
#include "base/text/json.h"

namespace cls::tournament {

/// Lines {"schema": "cls.events/1", "seq": n, "t": seconds since this run began, "time": UTC,
/// "type": ...}; `seq` continues over all runs of a tournament. A last line
/// that a crash or a full disk left incomplete is terminated first.
class EventFile {
 public:
  static base::Result<EventFile> open(const std::filesystem::path& file);

  /// Appends and syncs a line; `fields` follow the common members.
  base::Result<void> add(std::string_view type, const base::Json& fields);

 private:
  EventFile(base::UniqueFd file, std::string name, std::int64_t lines, bool whole);

  base::UniqueFd file_;
  std::string name_;
  std::int64_t next_ = 0;
  bool whole_ = true;  ///< the last line is complete
  std::chrono::steady_clock::time_point begin_;
};

/// Appends a line to a file that others append to. An error unless all of it was written.
base::Result<void> append_line(const std::filesystem::path& file, std::string_view line);

}  // namespace cls::tournament
