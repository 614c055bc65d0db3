// When a rule of a script applies: cycle, play mode, number, conditions on the State.
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
/// A uniform number 1 to 13, or several.
base::Result<std::vector<int>> parse_unums(const base::JsonValue& json);

/// All of its parts must hold; an empty one matches everything.
class SituationFilter {
 public:
  /// `json` is the object after "when": cycle, mode, unum, state. The conditions of "state" are
  /// about the request of `rpc`; cycle and mode need a State.
  static base::Result<SituationFilter> parse(const base::JsonValue& json, proto::Rpc rpc);

  bool matches(proto::Rpc rpc, const google::protobuf::Message& request) const;

 private:
  std::optional<CycleRange> cycles_;
  std::vector<Value> modes_;
  std::vector<int> unums_;
  std::vector<Condition> conditions_;
};

}  // namespace cls::mock_server
