// Parsing faults, and drawing the fault of a call.
#include "mock-server/script/faults.h"

#include <fmt/format.h>
#include <algorithm>

#include "base/text/suggestion.h"
#include "mock-server/script/json_parts.h"
#include "proto/playmaker.pb.h"
#include "proto/status_name.h"
#include "soccer/random.h"

namespace cls::mock_server {
namespace {

using base::Error;
using base::Result;

constexpr int kMaxMs = 3'600'000;
constexpr int kMaxCycle = 1'000'000;

template <typename T, typename U>
Result<void> assign(const Result<T>& value, U& member) {
  if (!value) return value.error();
  member = *value;
  return {};
}

Result<void> parse_only(const base::JsonValue& json, Faults& faults) {
  TRY(json.expect_keys({"cycle", "unum"}));
  TRY(read_key(json, "cycle", faults.cycles, parse_cycles));
  return read_key(json, "unum", faults.unums, parse_unums);
}

Result<void> parse_fault(std::string_view key, const base::JsonValue& json, Faults& faults) {
  if (key == "delay_ms") return assign(json.integer(0, kMaxMs), faults.delay_ms);
  if (key == "jitter_ms") return assign(json.integer(0, kMaxMs), faults.jitter_ms);
  if (key == "drop") return assign(json.number(0, 1), faults.drop);
  if (key == "error") return assign(json.number(0, 1), faults.error);
  if (key == "garbage") return assign(json.number(0, 1), faults.garbage);
  if (key == "oversize") return assign(json.number(0, 1), faults.oversize);

  if (key == "status") return assign(json.one_of(proto::status_names()), faults.status);
  if (key == "message") return assign(json.string(), faults.message);
  if (key == "crash_at_cycle") return assign(json.integer(0, kMaxCycle), faults.crash_at_cycle);
  if (key == "hang_at_cycle") return assign(json.integer(0, kMaxCycle), faults.hang_at_cycle);
  if (key == "restart_at_cycle") return assign(json.integer(0, kMaxCycle), faults.restart_at_cycle);
  if (key == "restart_cycles") return assign(json.integer(0, kMaxCycle), faults.restart_cycles);

  if (key == "wrong_client_id") return assign(json.boolean(), faults.wrong_client_id);
  if (key == "unimplemented")
    return assign(list_of(json, parse_rpc, "must be a list of RPCs"), faults.unimplemented);
  if (key == "full_states") return assign(json.boolean(), faults.full_states);
  if (key == "slow_start_ms") return assign(json.integer(0, kMaxMs), faults.slow_start_ms);
  if (key == "seed") return assign(json.integer(0, kMaxMs), faults.seed);
  return parse_only(json, faults);
}

bool applies_to(const Faults& faults, int unum, int cycle) {
  if (faults.cycles && !faults.cycles->contains(cycle)) return false;
  return faults.unums.empty() || std::ranges::find(faults.unums, unum) != faults.unums.end();
}

}  // namespace

bool Faults::any() const {
  return delay_ms > 0 || jitter_ms > 0 || drop > 0 || error > 0 || garbage > 0 || oversize > 0 ||
         crash_at_cycle || hang_at_cycle || restart_at_cycle || wrong_client_id ||
         !unimplemented.empty() || full_states || slow_start_ms > 0;
}

Result<Faults> parse_faults(const base::JsonValue& json) {
  TRY(json.expect_keys({"delay_ms", "jitter_ms", "drop", "error", "garbage", "oversize", "status",
                        "message", "crash_at_cycle", "hang_at_cycle", "restart_at_cycle",
                        "restart_cycles", "wrong_client_id", "unimplemented", "full_states",
                        "slow_start_ms", "only", "seed"}));

  Faults faults;
  for (const std::string& key : json.keys()) TRY(parse_fault(key, json[key], faults));
  return faults;
}

Result<int> status_code(std::string_view name) {
  const auto& names = proto::status_names();
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    return Error{fmt::format("no gRPC status '{}'{}", name, base::did_you_mean(name, names))};
  }
  return static_cast<int>(found - names.begin());
}

Fault draw_fault(const Faults& faults, proto::Rpc rpc, const google::protobuf::Message& request) {
  if (std::ranges::find(faults.unimplemented, rpc) != faults.unimplemented.end()) {
    return {Fault::What::kUnimplemented, 0};
  }
  if (!is_decision(rpc)) return {};

  const protos::WorldModel& world = static_cast<const protos::State&>(request).world_model();
  const int unum = caller_of(rpc, request).unum;
  if (faults.crash_at_cycle && world.cycle() >= *faults.crash_at_cycle) {
    return {Fault::What::kCrash, 0};
  }
  if (faults.hang_at_cycle && world.cycle() >= *faults.hang_at_cycle) {
    return {Fault::What::kHang, 0};
  }

  if (!applies_to(faults, unum, world.cycle())) return {};
  const auto clock = static_cast<std::uint64_t>(world.cycle()) << 32U |
                     static_cast<std::uint32_t>(world.time_stopped());
  soccer::RandomStream draw(faults.seed, "mock faults", static_cast<std::uint64_t>(unum), clock);

  Fault fault;
  fault.delay_ms = faults.delay_ms + draw.integer(faults.jitter_ms + 1);
  for (const auto& [share, what] : {std::pair{faults.drop, Fault::What::kHang},
                                    {faults.error, Fault::What::kError},
                                    {faults.garbage, Fault::What::kGarbage},
                                    {faults.oversize, Fault::What::kOversize}}) {
    if (draw.bernoulli(share) && fault.what == Fault::What::kNone) fault.what = what;
  }
  return fault;
}

}  // namespace cls::mock_server
