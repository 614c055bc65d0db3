// Counting calls and storing the first violation.
#include "mock-server/script/expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "mock-server/script/json_parts.h"
#include "proto/playmaker.pb.h"

namespace cls::mock_server {
namespace {

using base::Result;

// Maximum length of an order.
constexpr std::size_t kMaxOrder = 32;

Result<std::vector<proto::Rpc>> parse_order(const base::JsonValue& json) {
  constexpr std::string_view kNoList = "must be a list of RPCs";
  TRY_INIT(auto order, list_of(json, parse_rpc, kNoList));
  if (order.empty()) return json.error(kNoList);
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
  TRY(read_key(json, "name", what.name, parse_text));
  TRY(read_key(json, "order", what.order, parse_order));
  if (json.has("order")) return what;

  if (!json.has("rpc")) return json.error("needs \"rpc\" or \"order\"");
  TRY_INIT(what.rpc, parse_rpc(json["rpc"]));
  TRY(read_key(json, "when", what.when, [&](const base::JsonValue& when) {
    return SituationFilter::parse(when, what.rpc);
  }));
  TRY(read_key(json, "count", what.count, Comparison::parse_number));
  TRY(read_key(json, "count_per_agent", what.count_per_agent, Comparison::parse_number));
  TRY(read_key(json, "always", what.always, [&](const base::JsonValue& always) {
    return parse_conditions(*request_prototype(what.rpc).GetDescriptor(), always);
  }));

  if (!what.count && !what.count_per_agent && what.always.empty()) {
    return json.error("needs \"count\", \"count_per_agent\" or \"always\"");
  }
  return what;
}

Result<std::vector<Expectation>> parse_expectations(const base::JsonValue& json) {
  return list_of(json, [](const base::JsonValue& each) { return parse_expectation(each); });
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
    const bool all = calls.size() >= order.size();
    if (all && std::equal(order.begin(), order.end(), calls.begin())) continue;
    return fmt::format("{} called {}, not {}", agent.text(), names(calls), names(order));
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
