// Counting calls and storing the first violation.
#include "mock-server/script/expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "proto/playmaker.pb.h"

namespace cls::mock_server {
namespace {

using base::Result;

// Maximum length of an order.
constexpr std::size_t kMaxOrder = 32;

Result<std::vector<proto::Rpc>> parse_order(const base::JsonValue& json) {
  if (!json.is_array() || json.size() == 0) return json.error("must be a list of RPCs");
  std::vector<proto::Rpc> order;
  for (std::size_t i = 0; i < json.size(); ++i) {
    TRY_INIT(const auto word, json[i].one_of(proto::agent_rpc_names()));
    order.push_back(*proto::rpc_from_name(word));
  }
  if (order.size() > kMaxOrder) return json.error("more than 32 calls");
  return order;
}

}  // namespace

Result<Expectation> parse_expectation(const base::JsonValue& json,
                                      const std::vector<std::string_view>& other_keys) {
  std::vector<std::string_view> keys = {"name",   "rpc",  "when", "count", "count_per_agent",
                                        "always", "order"};
  keys.insert(keys.end(), other_keys.begin(), other_keys.end());
  TRY(json.expect_keys(keys));

  Expectation what;
  what.name = fmt::format("line {}", json.line());
  if (json.has("name")) {
    TRY_INIT(const auto text, json["name"].string());
    what.name = text;
  }

  if (json.has("order")) {
    TRY_INIT(const auto order, parse_order(json["order"]));
    what.order = order;
    return what;
  }

  if (!json.has("rpc")) return json.error("needs \"rpc\" or \"order\"");
  TRY_INIT(const auto word, json["rpc"].one_of(proto::agent_rpc_names()));
  what.rpc = *proto::rpc_from_name(word);

  if (json.has("when")) {
    TRY_INIT(const auto when, SituationFilter::parse(json["when"], what.rpc));
    what.when = when;
  }
  for (const auto& [key, member] :
       {std::pair{"count", &what.count}, std::pair{"count_per_agent", &what.count_per_agent}}) {
    if (!json.has(key)) continue;
    TRY_INIT(const auto count, Comparison::parse_number(json[key]));
    *member = count;
  }

  if (json.has("always")) {
    TRY_INIT(auto always,
             parse_conditions(*request_prototype(what.rpc).GetDescriptor(), json["always"]));
    what.always = std::move(always);
  }

  if (!what.count && !what.count_per_agent && what.always.empty()) {
    return json.error("needs \"count\", \"count_per_agent\" or \"always\"");
  }
  return what;
}

Result<std::vector<Expectation>> parse_expectations(const base::JsonValue& json) {
  if (!json.is_array()) return json.error("must be a list");
  std::vector<Expectation> list;
  for (std::size_t i = 0; i < json.size(); ++i) {
    TRY_INIT(auto what, parse_expectation(json[i]));
    list.push_back(std::move(what));
  }
  return list;
}

std::string Expectations::Agent::text() const {
  const std::string who = unum == 12   ? "coach"
                          : unum == 13 ? "trainer"
                                       : fmt::format("player {}", unum);
  return team.empty() ? who : team + " " + who;
}

Expectations::Expectations(std::vector<Expectation> list) {
  for (Expectation& what : list) entries_.push_back({std::move(what), {}, {}, 0});
}

void Expectations::add_violation(Entry& entry, Violation violation) {
  ++entry.violations;
  const auto key = [](const Violation& v) { return std::tie(v.cycle, v.agent); };
  if (!entry.first || key(violation) < key(*entry.first)) entry.first = std::move(violation);
}

void Expectations::add(proto::Rpc rpc, const google::protobuf::Message& request) {
  const proto::Caller caller = caller_of(rpc, request);
  const Agent agent{std::string(caller.team), caller.unum};
  const std::lock_guard lock(mutex_);
  std::vector<proto::Rpc>& calls = calls_[agent];
  if (calls.size() < kMaxOrder && (calls.empty() || calls.back() != rpc)) calls.push_back(rpc);

  for (Entry& entry : entries_) {
    if (!entry.what.order.empty() || entry.what.rpc != rpc) continue;
    if (!entry.what.when.matches(rpc, request)) continue;
    ++entry.counts[agent];
    for (const Condition& condition : entry.what.always) {
      if (condition.holds(request)) continue;
      const int cycle =
          is_decision(rpc) ? static_cast<const protos::State&>(request).world_model().cycle() : 0;
      add_violation(entry, {cycle, agent, condition.complaint(request)});
      break;
    }
  }
}

std::string Expectations::order_failure(const Entry& entry) const {
  const auto names = [](const std::vector<proto::Rpc>& rpcs) {
    std::vector<std::string_view> words;
    for (const proto::Rpc rpc : rpcs) words.push_back(name(rpc));
    return fmt::format("{}", fmt::join(words, ", "));
  };

  const std::vector<proto::Rpc>& order = entry.what.order;
  if (calls_.empty()) return "no agent called";

  for (const auto& [agent, calls] : calls_) {
    const bool begins =
        calls.size() >= order.size() && std::equal(order.begin(), order.end(), calls.begin());
    if (!begins) {
      return fmt::format("{} called {}, not {}", agent.text(), names(calls), names(order));
    }
  }
  return {};
}

std::string Expectations::count_failure(const Entry& entry) const {
  std::int64_t total = 0;
  for (const auto& [agent, count] : entry.counts) total += count;
  const auto wrong = [](const Comparison& expected, std::int64_t count) {
    return !expected.holds(static_cast<double>(count));
  };

  const std::string_view what = name(entry.what.rpc);
  if (entry.what.count && wrong(*entry.what.count, total)) {
    return fmt::format("{} calls of {}, not {}", total, what, entry.what.count->text());
  }

  if (!entry.what.count_per_agent) return {};
  if (calls_.empty()) return "no agent called";
  for (const auto& [agent, unused] : calls_) {
    const auto found = entry.counts.find(agent);
    const std::int64_t count = found == entry.counts.end() ? 0 : found->second;
    if (!wrong(*entry.what.count_per_agent, count)) continue;
    return fmt::format("{} calls of {} by {}, not {}", count, what, agent.text(),
                       entry.what.count_per_agent->text());
  }
  return {};
}

std::string Expectations::failure(const Entry& entry) const {
  if (!entry.what.order.empty()) return order_failure(entry);
  if (entry.first) {
    return fmt::format(
        "{} of {} at cycle {}: {}{}", name(entry.what.rpc), entry.first->agent.text(),
        entry.first->cycle, entry.first->complaint,
        entry.violations > 1 ? fmt::format(" ({} calls in all)", entry.violations) : "");
  }
  return count_failure(entry);
}

std::vector<std::string> Expectations::failures() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> lines;
  for (const Entry& entry : entries_) {
    const std::string line = failure(entry);
    if (!line.empty()) lines.push_back(fmt::format("expected ({}): {}", entry.what.name, line));
  }
  return lines;
}

}  // namespace cls::mock_server
