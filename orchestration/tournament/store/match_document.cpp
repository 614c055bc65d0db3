// JSON in and out, all field names in one place.
#include "orchestration/tournament/store/match_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "soccer/side_name.h"

namespace cls::orchestration::tournament {
namespace {

using Json = nlohmann::ordered_json;
using base::Error;
using base::Result;

double rounded(double value, double per_one) { return std::round(value * per_one) / per_one; }

Json json_of(const SideFigures& side) {
  return {{"decisions", side.decisions},
          {"late", side.late},
          {"missed", side.missed},
          {"rpc_p50_us", rounded(side.rpc_p50_us, 10)},
          {"rpc_p99_us", rounded(side.rpc_p99_us, 10)},
          {"cpu_seconds", rounded(side.cpu_seconds, 1000)}};
}

SideFigures side_from(const Json& json) {
  SideFigures side;
  side.decisions = json.at("decisions").get<std::int64_t>();
  side.late = json.at("late").get<std::int64_t>();
  side.missed = json.at("missed").get<std::int64_t>();
  side.rpc_p50_us = json.at("rpc_p50_us").get<double>();
  side.rpc_p99_us = json.at("rpc_p99_us").get<double>();
  side.cpu_seconds = json.at("cpu_seconds").get<double>();
  return side;
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

std::string text_in(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() || !found->is_string() ? "" : found->get<std::string>();
}

Json winner_json(const Outcome& outcome) {
  if (!outcome.counts()) return nullptr;
  const int sign = winner_sign(outcome);
  return sign > 0 ? "left" : sign < 0 ? "right" : "draw";
}

void add_outcome(Json& json, const Outcome& outcome) {
  const bool penalties = outcome.left_penalties && outcome.right_penalties;
  json["end_reason"] = outcome.end_reason;
  json["valid"] = outcome.played();
  json["forfeit"] = outcome.forfeit;
  json["score"] = {outcome.left_score, outcome.right_score};
  json["penalty_score"] =
      penalties ? Json({*outcome.left_penalties, *outcome.right_penalties}) : Json(nullptr);
  json["winner"] = winner_json(outcome);
  json["fault"] = outcome.fault ? Json(side_name(*outcome.fault)) : Json(nullptr);
  json["message"] = text_or_null(outcome.message);
  json["attempts"] = outcome.attempts;
  json["cycles"] = outcome.cycles;
  json["wall_seconds"] = rounded(outcome.wall_seconds, 1000);
  json["run_seconds"] = rounded(outcome.run_seconds, 1000);
  json["cycles_per_second"] = rounded(outcome.cycles_per_second, 10);
  json["deterministic"] = outcome.deterministic;
  json["mode"] = outcome.mode;
  json["started"] = outcome.started;
  json["ended"] = outcome.ended;
  json["host"] = outcome.host;
  json["load"] = rounded(outcome.load, 100);
  json["version"] = outcome.version;
  json["server"] = outcome.server;
  json["folder"] = text_or_null(outcome.folder);
  json["left_figures"] = json_of(outcome.left);
  json["right_figures"] = json_of(outcome.right);
}

Outcome outcome_from(const Json& json) {
  Outcome outcome;
  outcome.end_reason = json.at("end_reason").get<std::string>();
  outcome.forfeit = json.at("forfeit").get<bool>();
  outcome.left_score = json.at("score").at(0).get<int>();
  outcome.right_score = json.at("score").at(1).get<int>();
  if (const Json& penalties = json.at("penalty_score"); !penalties.is_null()) {
    outcome.left_penalties = penalties.at(0).get<int>();
    outcome.right_penalties = penalties.at(1).get<int>();
  }
  outcome.fault = soccer::side_named(text_in(json, "fault"));
  outcome.message = text_in(json, "message");
  outcome.attempts = json.at("attempts").get<int>();
  outcome.cycles = json.at("cycles").get<int>();
  outcome.wall_seconds = json.at("wall_seconds").get<double>();
  outcome.run_seconds = json.at("run_seconds").get<double>();
  outcome.cycles_per_second = json.at("cycles_per_second").get<double>();
  outcome.deterministic = json.at("deterministic").get<bool>();
  outcome.mode = text_in(json, "mode");
  outcome.started = text_in(json, "started");
  outcome.ended = text_in(json, "ended");
  outcome.host = text_in(json, "host");
  outcome.load = json.at("load").get<double>();
  outcome.version = text_in(json, "version");
  outcome.server = text_in(json, "server");
  outcome.folder = text_in(json, "folder");
  outcome.left = side_from(json.at("left_figures"));
  outcome.right = side_from(json.at("right_figures"));
  return outcome;
}

// The middle player's median and the worst player's 99th percentile, sums of the rest.
SideFigures figures_of(const Json& team) {
  SideFigures side;
  std::vector<double> medians;
  for (const Json& player : team.at("players")) {
    side.decisions += player.at("decisions").get<std::int64_t>();
    side.late += player.at("late").get<std::int64_t>();
    side.missed += player.at("missed").get<std::int64_t>();
    medians.push_back(player.at("rpc_us").at("p50").get<double>());
    side.rpc_p99_us = std::max(side.rpc_p99_us, player.at("rpc_us").at("p99").get<double>());
  }
  if (!medians.empty()) {
    const auto middle = medians.begin() + static_cast<long>(medians.size() / 2);
    std::nth_element(medians.begin(), middle, medians.end());
    side.rpc_p50_us = *middle;
  }
  side.cpu_seconds = team.at("cpu_seconds").get<double>();
  return side;
}

Outcome outcome_of_match(const Json& json) {
  Outcome outcome;
  outcome.end_reason = json.at("end_reason").get<std::string>();
  const Json& left = json.at("left");
  const Json& right = json.at("right");
  outcome.left_score = left.at("score").get<int>();
  outcome.right_score = right.at("score").get<int>();
  if (!left.at("penalty_score").is_null() && !right.at("penalty_score").is_null()) {
    outcome.left_penalties = left.at("penalty_score").get<int>();
    outcome.right_penalties = right.at("penalty_score").get<int>();
  }
  outcome.fault = soccer::side_named(text_in(json, "fault"));
  outcome.message = text_in(json, "message");
  outcome.cycles = json.at("cycles").get<int>();
  outcome.wall_seconds = json.at("wall_seconds").get<double>();
  outcome.cycles_per_second = json.at("cycles_per_second").get<double>();
  outcome.deterministic = json.at("deterministic").get<bool>();
  outcome.mode = text_in(json, "mode");
  outcome.version = text_in(json.at("versions"), "cls");
  outcome.server = fmt::format("{} {}", text_in(json.at("server"), "kind"),
                               text_in(json.at("server"), "version"));
  outcome.left = figures_of(left);
  outcome.right = figures_of(right);
  return outcome;
}

// What the library throws becomes an error.
template <typename Read>
auto guarded(Read read) -> Result<decltype(read())> {
  try {
    return read();
  } catch (const nlohmann::json::exception& error) {
    return Error{error.what()};
  }
}

}  // namespace

Json json_of(const TournamentConfig& config, const ScheduledMatch& match) {
  const Fixture& fixture = match.fixture;
  const auto team = [&config](int index) {
    return config.teams[static_cast<std::size_t>(index)].name;
  };
  Json json = {{"index", fixture.index},
               {"round", fixture.round},
               {"stage", text_or_null(fixture.stage)},
               {"pairing", fixture.pairing},
               {"left", team(fixture.left)},
               {"right", team(fixture.right)},
               {"seed", fixture.seed},
               {"decides", fixture.decides}};
  if (match.outcome) {
    add_outcome(json, *match.outcome);
  } else {
    json["end_reason"] = nullptr;
    json["score"] = nullptr;
  }
  return json;
}

std::string schedule_line(const Fixture& fixture) {
  const Json json = {{"index", fixture.index}, {"round", fixture.round},
                     {"stage", fixture.stage}, {"pairing", fixture.pairing},
                     {"left", fixture.left},   {"right", fixture.right},
                     {"seed", fixture.seed},   {"decides", fixture.decides}};
  return json.dump() + "\n";
}

Result<Fixture> fixture_from_line(const std::string& line) {
  return guarded([&] {
    const Json json = Json::parse(line);
    Fixture fixture;
    fixture.index = json.at("index").get<int>();
    fixture.round = json.at("round").get<int>();
    fixture.stage = json.at("stage").get<std::string>();
    fixture.pairing = json.at("pairing").get<int>();
    fixture.left = json.at("left").get<int>();
    fixture.right = json.at("right").get<int>();
    fixture.seed = json.at("seed").get<std::uint64_t>();
    fixture.decides = json.at("decides").get<bool>();
    return fixture;
  });
}

std::string outcome_document(const Fixture& fixture, const Outcome& outcome) {
  Json json = {{"schema", "cls.work/1"}, {"index", fixture.index}, {"seed", fixture.seed}};
  add_outcome(json, outcome);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<DeliveredOutcome> outcome_from_document(const std::string& text) {
  return guarded([&] {
    const Json json = Json::parse(text);
    return DeliveredOutcome{json.at("index").get<int>(), json.at("seed").get<std::uint64_t>(),
                            outcome_from(json)};
  });
}

Result<Outcome> outcome_from_result(const std::string& text) {
  return guarded([&] { return outcome_of_match(Json::parse(text)); });
}

}  // namespace cls::orchestration::tournament
