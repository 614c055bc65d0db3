// Expectations about the calls that a mock receives: checked while it serves, reported at the end.
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

/// One expectation of a script: an order of calls, or properties of the calls of one RPC.
struct Expectation {
  std::string name;  ///< names the failure
  std::vector<proto::Rpc> order;
  proto::Rpc rpc = proto::Rpc::kGetPlayerActions;
  SituationFilter when;
  std::optional<Comparison> count;            ///< of all agents together
  std::optional<Comparison> count_per_agent;  ///< of each agent that ever called
  std::vector<Condition> always;              ///< of each call
};

/// A list: [{"rpc": "SendPlayerType", "count_per_agent": 18}, {"order": [...]}].
base::Result<std::vector<Expectation>> parse_expectations(const base::JsonValue& json);

/// One expectation; `other_keys` are allowed and ignored.
base::Result<Expectation> parse_expectation(const base::JsonValue& json,
                                            const std::vector<std::string_view>& other_keys = {});

/// Counts calls and reports what was not as expected. Thread safe; the order of calls of different
/// agents does not matter.
class Expectations {
 public:
  explicit Expectations(std::vector<Expectation> list);

  void add(proto::Rpc rpc, const google::protobuf::Message& request);

  /// One line per failed expectation, in the order of the script.
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
  /// The earliest failing call; the lowest agent among equals.
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

  void add_violation(Entry& entry, Violation violation);
  std::string failure(const Entry& entry) const;
  std::string order_failure(const Entry& entry) const;
  std::string count_failure(const Entry& entry) const;

  mutable std::mutex mutex_;
  std::vector<Entry> entries_;
  std::map<Agent, std::vector<proto::Rpc>> calls_;  ///< without consecutive repetitions
};

}  // namespace cls::mock_server
