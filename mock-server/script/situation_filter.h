// Filter of a rule: cycle, play mode, uniform number, conditions on the State.
#pragma once

#include <google/protobuf/message.h>

#include <optional>
#include <vector>

#include "base/result.h"
#include "mock-server/script/field_path.h"
#include "proto/rpc.h"

namespace cls::mock_server {

/// Cycles first, first + every, ... up to last.
struct CycleRange {
  int first = 0;
  int last = 0;
  int every = 1;

  bool contains(int cycle) const {
    return cycle >= first && cycle <= last && (cycle - first) % every == 0;
  }
};

/// 10, [10, 20], or {"from": 10, "to": 20, "every": 5}.
base::Result<CycleRange> parse_cycles(const base::JsonValue& json);
/// 7 or [7, 9].
base::Result<std::vector<int>> parse_numbers(const base::JsonValue& json);
/// One or several uniform numbers: 1 to 11, 12 coach, 13 trainer.
base::Result<std::vector<int>> parse_unums(const base::JsonValue& json);

/// All of its parts must hold; an empty one matches everything.
class SituationFilter {
 public:
  /// `json` is the object of the key "when": cycle, mode, unum, state. The conditions of "state"
  /// apply to the request of `rpc`; cycle and mode require a State.
  static base::Result<SituationFilter> parse(const base::JsonValue& json, proto::Rpc rpc);

  bool matches(proto::Rpc rpc, const google::protobuf::Message& request) const;

 private:
  std::optional<CycleRange> cycles_;
  std::vector<Value> modes_;
  std::vector<int> unums_;
  std::vector<Condition> conditions_;
};

}  // namespace cls::mock_server
