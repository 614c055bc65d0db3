// The JSON members of fixtures and outcomes, listed once for writing and parsing.
#include "tournament/store/match_document.h"

#include <fmt/format.h>

#include "match/result/match_result.h"
#include "soccer/side.h"
#include "tournament/store/decisions_file.h"
#include "tournament/store/json_lines.h"

// The members of each type, where argument-dependent lookup finds them.
namespace cls::league {

template <typename Codec, typename T>
using Object = typename Codec::template Object<T>;

static base::Json winner_json(const Outcome& outcome) {
  if (!outcome.counts()) return nullptr;
  const int sign = winner_sign(outcome);
  return sign > 0 ? "left" : sign < 0 ? "right" : "draw";
}

template <typename Codec>
static void list_members(Codec& codec, Object<Codec, Fixture>& fixture) {
  codec.required("index", fixture.index);
  codec.required("round", fixture.round);
  codec.required("stage", fixture.stage);
  codec.required("pairing", fixture.pairing);
  codec.required("left", fixture.left);
  codec.required("right", fixture.right);
  codec.required("seed", fixture.seed);
  codec.required("decides", fixture.decides);
}

void members(base::JsonEncoder& codec, const Fixture& fixture) { list_members(codec, fixture); }
void members(base::JsonDecoder& codec, Fixture& fixture) { list_members(codec, fixture); }

template <typename Codec>
static void members(Codec& codec, Object<Codec, SideStats>& side) {
  codec.member("decisions", side.decisions);
  codec.member("late", side.late);
  codec.member("missed", side.missed);
  codec.rounded("rpc_p50_us", side.rpc_p50_us, 10);
  codec.rounded("rpc_p95_us", side.rpc_p95_us, 10);
  codec.rounded("rpc_p99_us", side.rpc_p99_us, 10);
  codec.rounded("rpc_max_us", side.rpc_max_us, 10);
  codec.rounded("cpu_seconds", side.cpu_seconds, 1000);
}

template <typename Codec>
static void members(Codec& codec, Object<Codec, Outcome>& outcome) {
  codec.named(
      "end_reason", outcome.end_reason, [](soccer::EndReason reason) { return name(reason); },
      soccer::parse_end_reason);

  codec.derived("valid", [&] { return outcome.played(); });
  codec.member("forfeit", outcome.forfeit);
  codec.pair("score", outcome.left_score, outcome.right_score);
  codec.pair("penalty_score", outcome.left_penalties, outcome.right_penalties);
  codec.rounded("value", outcome.value, 1e6);
  codec.derived("winner", [&] { return winner_json(outcome); });

  codec.named("fault", outcome.fault, soccer::side_name, soccer::parse_side);
  codec.text_or_null("message", outcome.message);
  codec.member("warnings", outcome.warnings);

  codec.member("attempts", outcome.attempts);
  codec.member("cycles", outcome.cycles);
  codec.rounded("wall_seconds", outcome.wall_seconds, 1000);
  codec.rounded("run_seconds", outcome.run_seconds, 1000);
  codec.rounded("cycles_per_second", outcome.cycles_per_second, 10);
  codec.member("deterministic", outcome.deterministic);

  codec.member("mode", outcome.mode);
  codec.member("started", outcome.started);
  codec.member("ended", outcome.ended);
  codec.member("host", outcome.host);
  codec.rounded("load", outcome.load, 100);
  codec.member("version", outcome.version);
  codec.member("server", outcome.server);
  codec.text_or_null("folder", outcome.folder);
  codec.member("left_figures", outcome.left);
  codec.member("right_figures", outcome.right);
}

}  // namespace cls::league

namespace cls::tournament {

using base::Json;
using base::JsonDecoder;
using base::JsonEncoder;
using base::Result;

static void members(JsonDecoder& codec, WorkResult& result) {
  codec.required("index", result.index);
  codec.required("seed", result.seed);
  members(codec, result.outcome);
}

namespace {

SideStats stats_of(const match::TeamResult& team) {
  const match::ReplySummary sums = match::reply_summary(team);
  return {sums.decisions,  sums.late,       sums.missed,     sums.rpc_us.p50,
          sums.rpc_us.p95, sums.rpc_us.p99, sums.rpc_us.max, team.cpu_seconds};
}

}  // namespace

Json json_of(const TournamentConfig& config, const ScheduledMatch& match) {
  const Fixture& fixture = match.fixture;

  Json json = JsonEncoder::encode(fixture);
  if (fixture.stage.empty()) json["stage"] = nullptr;
  json["left"] = config.competition.team(fixture.left);
  json["right"] = config.competition.team(fixture.right);
  if (match.outcome) {
    JsonEncoder codec(json);
    members(codec, *match.outcome);
  } else {
    json["end_reason"] = nullptr;
    json["score"] = nullptr;
  }
  if (match.decision) json["decision"] = json_of(*match.decision);
  if (!match.history.empty()) {
    json["decisions"] = Json::array();
    for (const MatchDecision& one : match.history) json["decisions"].push_back(json_of(one));
  }
  return json;
}

std::string format_fixture(const Fixture& fixture) { return format_json_line(fixture); }

Result<Fixture> parse_fixture(std::string_view line) { return parse_json<Fixture>(line); }

std::string format_outcome(const Outcome& outcome) {
  return base::json_line(JsonEncoder::encode(outcome));
}

Result<Outcome> parse_outcome(std::string_view text) { return parse_json<Outcome>(text); }

std::string format_work_result(const Fixture& fixture, const Outcome& outcome) {
  Json json = {{"schema", "cls.work/1"}, {"index", fixture.index}, {"seed", fixture.seed}};
  JsonEncoder codec(json);
  members(codec, outcome);
  return base::json_document(json);
}

Result<WorkResult> parse_work_result(std::string_view text) { return parse_json<WorkResult>(text); }

Outcome outcome_of(const match::MatchResult& result) {
  Outcome outcome;
  outcome.end_reason = result.end_reason;
  outcome.left_score = result.left.score;
  outcome.right_score = result.right.score;
  if (result.left.penalty_score && result.right.penalty_score) {
    outcome.left_penalties = result.left.penalty_score;
    outcome.right_penalties = result.right.penalty_score;
  }

  if (result.book) outcome.value = result.book->value;
  if (result.fault != soccer::Side::kNeutral) outcome.fault = result.fault;
  outcome.message = result.message;
  outcome.warnings = result.warnings;

  outcome.cycles = result.cycles;
  outcome.wall_seconds = result.wall_seconds;
  outcome.cycles_per_second = result.cycles_per_second;
  outcome.deterministic = result.deterministic;
  outcome.mode = result.mode;
  outcome.version = result.cls_version;
  outcome.server = fmt::format("{} {}", result.server_kind, result.server_version);

  outcome.left = stats_of(result.left);
  outcome.right = stats_of(result.right);
  return outcome;
}

}  // namespace cls::tournament
