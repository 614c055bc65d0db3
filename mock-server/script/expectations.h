// What a mock must be told and asked: checked while it serves, told at the end.
#pragma once

#include <google/protobuf/message.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "mock-server/script/situation_filter.h"

namespace cls::mock_server {

/// One demand of a script. Either an order of calls, or something about the calls of one rpc.
struct Expectation {
  std::string name;  ///< what a failure is called
  std::vector<proto::Rpc> order;
  proto::Rpc rpc = proto::Rpc::kGetPlayerActions;
  SituationFilter when;
  std::optional<Comparison> count;            ///< of all agents together
  std::optional<Comparison> count_per_agent;  ///< of each agent that ever called
  std::vector<Condition> always;              ///< true of each of the calls
};

/// The demands in a list: [{"rpc": "SendPlayerType", "count_per_agent": 18}, {"order": [...]}].
base::Result<std::vector<Expectation>> parse_expectations(const base::JsonValue& json);

/// One of them, beside other keys that are not its business.
base::Result<Expectation> parse_expectation(const base::JsonValue& json,
                                            const std::vector<std::string_view>& other_keys = {});

/// Notes calls and says in the end what was not as expected. Calls may come from several threads;
/// the order in which those of different agents come does not matter.
class Expectations {
 public:
  explicit Expectations(std::vector<Expectation> list);

  void note(proto::Rpc rpc, const google::protobuf::Message& request);

  /// One line each, in the order of the script; empty when all was as expected.
  std::vector<std::string> failures() const;
  std::size_t size() const { return entries_.size(); }

 private:
  struct Agent {
    std::string team;
    int unum = 0;
    bool operator<(const Agent& other) const {
      return std::tie(team, unum) < std::tie(other.team, other.unum);
    }
    std::string text() const;
  };
  /// The earliest call that was wrong; the lowest number of equal ones.
  struct Violation {
    int cycle = 0;
    Agent agent;
    std::string complaint;
  };
  struct Entry {
    Expectation what;
    std::map<Agent, std::int64_t> counts;
    std::optional<Violation> first;
    std::int64_t violations = 0;
  };

  void note_violation(Entry& entry, Violation violation);
  std::string failure(const Entry& entry) const;
  std::string order_failure(const Entry& entry) const;
  std::string count_failure(const Entry& entry) const;

  mutable std::mutex mutex_;
  std::vector<Entry> entries_;
  std::map<Agent, std::vector<proto::Rpc>> calls_;  ///< without repetitions in a row
};

}  // namespace cls::mock_server
