// The members of the document `cls.match/1`, listed once for writing and parsing.
#include "match/result/match_result.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <type_traits>
#include <utility>

#include "base/catch_as_error.h"
#include "base/median.h"
#include "base/text/json.h"
#include "base/text/json_codec.h"
#include "base/text/json_text.h"
#include "base/text/stored_formats.h"

namespace cls::match {

using base::Json;
using base::Result;
using soccer::Side;

namespace {

template <class T, class Of>
concept Is = std::same_as<std::remove_const_t<T>, Of>;

constexpr double kDigits = 1e6;  // of values and figures of situations

// The inverse of side_name().
std::optional<Side> parse_side(std::string_view text) {
  if (text == side_name(Side::kNeutral)) return Side::kNeutral;
  return soccer::parse_side(text);
}

}  // namespace

static void members(auto& codec, Is<RpcLatency> auto& latency) {
  codec.rounded("p50", latency.p50, 1);
  codec.rounded("p95", latency.p95, 1);
  codec.rounded("p99", latency.p99, 1);
  codec.rounded("max", latency.max, 1);
}

static void members(auto& codec, Is<PlayerResult> auto& player) {
  codec.member("unum", player.unum);
  codec.member("decisions", player.decisions);
  codec.member("late", player.late);
  codec.member("missed", player.missed);
  codec.member("missed_by", player.missed_by);
  codec.member("reconnects", player.reconnects);
  codec.member("undecided", player.undecided);
  codec.member("lost_commands", player.lost_commands);
  codec.member("late_wakeups", player.late_wakeups);

  codec.member("rpc_us", player.rpc_us);
  codec.member("commands", player.commands);
  codec.member("unimplemented_actions", player.unimplemented_actions);
  codec.member("actions", player.actions);
  codec.member("automatic", player.automatic);
  codec.object("replies", [&](auto& replies) {
    replies.member("tried", player.lists);
    replies.member("empty", player.empty);
    replies.member("useless", player.useless);
  });
}

static void members(auto& codec, Is<FailedCall> auto& error) {
  codec.member("rpc", error.rpc);
  codec.member("status", error.status);
  codec.member("message", error.message);
  codec.member("cycle", error.cycle);
  codec.member("unum", error.unum);
  codec.text_or_null("recording", error.recording);
}

static void members(auto& codec, Is<ErrorResult> auto& errors) {
  codec.member("count", errors.count);
  codec.member("first", errors.first);
}

static void members(auto& codec, Is<PartResult> auto& part) {
  codec.member("agents", part.agents);
  codec.member("endpoint", part.endpoint);
  codec.member("decisions", part.decisions);
  codec.member("late", part.late);
  codec.member("missed", part.missed);
  codec.member("rpc_us", part.rpc_us);
  codec.rounded("cpu_seconds", part.cpu_seconds, 1000);
}

static void members(auto& codec, Is<TeamResult> auto& team) {
  codec.member("name", team.name);
  codec.member("endpoint", team.endpoint);
  codec.member("score", team.score);
  codec.member("penalty_score", team.penalty_score);
  codec.rounded("cpu_seconds", team.cpu_seconds, 1000);
  codec.member("players", team.players);
  codec.member("coach", team.coach);
  codec.member("errors", team.errors);
  codec.member("parts", team.parts);
}

static void members(auto& codec, Is<Goal> auto& goal) {
  codec.member("cycle", goal.cycle);
  codec.named("side", goal.side, soccer::side_name, parse_side);
  codec.number_or_null("unum", goal.unum);
}

static void members(auto& codec, Is<ProcessResult> auto& process) {
  codec.member("name", process.name);
  codec.member("command", process.command);
  codec.member("log", process.log);
  codec.member("exit", process.exit);
  codec.rounded("cpu_seconds", process.cpu_seconds, 1000);
  codec.text_or_null("exception", process.exception);
}

static void members(auto& codec, Is<ProcessFailure> auto& failure) {
  codec.member("process", failure.process);
  codec.member("exit", failure.exit);
  codec.member("log", failure.log);
  codec.member("output", failure.output);
  codec.text_or_null("rpc", failure.rpc);
  codec.number_or_null("unum", failure.unum);
  codec.member("cycle", failure.cycle);
}

static void members(auto& codec, Is<SpeedShares> auto& shares) {
  codec.member("server", shares.server);
  codec.member("agents", shares.agents);
  codec.member("left_playmaker", shares.left_playmaker);
  codec.member("right_playmaker", shares.right_playmaker);
  codec.member("trainer_playmaker", shares.trainer_playmaker);
  codec.member("clock", shares.clock);
}

static void members(auto& codec, Is<DecisionTimes> auto& times) {
  codec.rounded("p50", times.p50, 1000);
  codec.rounded("p99", times.p99, 1000);
  codec.rounded("max", times.max, 1000);
}

static void members(auto& codec, Is<SpeedResult> auto& speed) {
  codec.named(
      "limited_by", speed.limited_by, [](SpeedLimit limit) { return name(limit); },
      parse_speed_limit);
  codec.member("shares", speed.shares);
  codec.member("decision_ms", speed.decision_ms);
  codec.member("fits_100_ms", speed.fits_100_ms);
}

static void members(auto& codec, Is<SituationResult> auto& situation) {
  codec.member("class", situation.kind);
  codec.member("log", situation.log);
  codec.member("time", situation.time);
  codec.member("cycles", situation.cycles);
  codec.rounded("value", situation.value, kDigits);
  codec.member("figures", situation.figures);
}

static void members(auto& codec, Is<BookResult> auto& book) {
  codec.rounded("value", book.value, kDigits);
  codec.member("situations", book.situations);
}

// The seed of the server is written even where it is the seed of the match.
static void list_server(auto& codec, Is<MatchResult> auto& result) {
  std::optional<std::uint64_t> seed = result.server_seed.value_or(result.seed);
  codec.member("kind", result.server_kind);
  codec.member("version", result.server_version);
  codec.member("seed", seed);
  codec.member("missed_cycles", result.server_missed_cycles);
  codec.rounded("cpu_seconds", result.server_cpu_seconds, 1000);
  if constexpr (std::is_same_v<decltype(codec), base::JsonDecoder&>) {
    if (seed != result.seed) result.server_seed = seed;
  }
}

static void members(auto& codec, Is<MatchResult> auto& result) {
  codec.schema("schema", base::kMatchSchema);
  codec.member("left", result.left);
  codec.member("right", result.right);
  codec.member("trainer", result.trainer);

  codec.derived("winner", [&] { return base::JsonEncoder::encode(winner(result)); });
  codec.derived("valid", [&] { return result.valid(); });
  codec.named(
      "end_reason", result.end_reason, [](EndReason reason) { return name(reason); },
      soccer::parse_end_reason);
  codec.text_or_null("message", result.message);
  codec.named("fault", result.fault, soccer::side_name, parse_side);
  codec.member("failure", result.failure);

  codec.member("cycles", result.cycles);
  codec.member("steps", result.steps);
  codec.member("seed", result.seed);
  codec.member("mode", result.mode);
  codec.member("deterministic", result.deterministic);
  codec.object("server", [&](auto& server) { list_server(server, result); });

  codec.member("goals", result.goals);
  codec.member("book", result.book);
  codec.rounded("wall_seconds", result.wall_seconds, 1000);
  codec.rounded("cycles_per_second", result.cycles_per_second, 10);
  codec.member("speed", result.speed);
  codec.member("folder", result.folder);
  codec.object("log_files", [&](auto& files) {
    files.text_or_null("rcg", result.rcg);
    files.text_or_null("rcl", result.rcl);
  });

  codec.member("processes", result.processes);
  codec.member("warnings", result.warnings);
  codec.object("versions", [&](auto& versions) {
    versions.member("cls", result.cls_version);
    versions.member("wire", result.wire_version);
  });
}

std::string to_json(const std::vector<PlayerResult>& players) {
  return base::json_line(base::JsonEncoder::encode(players));
}

std::string to_json(const ErrorResult& errors) {
  return base::json_line(base::JsonEncoder::encode(errors));
}

ReplySummary reply_summary(const TeamResult& team) {
  constexpr std::array kSums = {std::pair(&ReplySummary::decisions, &PlayerResult::decisions),
                                std::pair(&ReplySummary::late, &PlayerResult::late),
                                std::pair(&ReplySummary::missed, &PlayerResult::missed),
                                std::pair(&ReplySummary::lists, &PlayerResult::lists),
                                std::pair(&ReplySummary::empty, &PlayerResult::empty),
                                std::pair(&ReplySummary::useless, &PlayerResult::useless)};
  constexpr double RpcLatency::*kMaxima[] = {&RpcLatency::p95, &RpcLatency::p99, &RpcLatency::max};

  ReplySummary summary;
  std::vector<double> medians;
  for (const PlayerResult& player : team.players) {
    for (const auto& [sum, member] : kSums) summary.*sum += player.*member;
    for (const auto member : kMaxima) {
      summary.rpc_us.*member = std::max(summary.rpc_us.*member, player.rpc_us.*member);
    }
    medians.push_back(player.rpc_us.p50);
  }
  summary.rpc_us.p50 = base::median(std::move(medians));
  return summary;
}

std::optional<std::string> winner(const MatchResult& result) {
  if (!result.valid()) return std::nullopt;
  const auto total = [](const TeamResult& team) {
    return std::pair(team.score, team.penalty_score.value_or(0));
  };
  if (total(result.left) == total(result.right)) return "draw";
  return total(result.left) > total(result.right) ? "left" : "right";
}

std::string to_json(const MatchResult& result) {
  // Messages may hold output of other programs: replace bytes that are not UTF-8.
  return base::json_document(base::JsonEncoder::encode(result));
}

Result<MatchResult> parse_match_result(std::string_view text) {
  return base::catch_as_error<std::exception>("", [&] {
    MatchResult result;
    base::JsonDecoder::decode(Json::parse(text), result);
    return result;
  });
}

}  // namespace cls::match
