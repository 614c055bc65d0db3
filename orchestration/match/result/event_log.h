// events.jsonl: what happened in a match, one JSON object a line.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "base/io/byte_sink.h"

namespace cls::orchestration::match {

/// Writes lines {"schema": "cls.events/1", "seq": n, "t": game time, "type": ...}. `t` is game
/// time in cycles, never wall time, so that the same seed gives the same bytes.
class EventLog {
 public:
  /// `sink` must outlive the log.
  explicit EventLog(base::ByteSink& sink) : sink_(sink) {}

  /// Appends one event; `fields` is an object whose members follow the common ones.
  void add(int time, std::string_view type, const nlohmann::ordered_json& fields);

 private:
  base::ByteSink& sink_;
  std::int64_t next_ = 0;
};

}  // namespace cls::orchestration::match
