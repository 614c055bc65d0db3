// The result document.
#include "orchestration/match/result/match_result.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/system/version.h"
#include "soccer/side_name.h"

namespace cls::orchestration::match {
namespace {

using Json = nlohmann::ordered_json;

// To a number of decimals that divides evenly: rounding by multiplication prints as 83.30000001.
double rounded(double value, double per_one) { return std::round(value * per_one) / per_one; }

Json json_of(const PlayerResult& player) {
  return {{"unum", player.unum},
          {"decisions", player.decisions},
          {"late", player.late},
          {"missed", player.missed},
          {"missed_by", player.missed_by},
          {"reconnects", player.reconnects},
          {"undecided", player.undecided},
          {"lost_commands", player.lost_commands},
          {"late_wakeups", player.late_wakeups},
          {"rpc_us",
           {{"p50", rounded(player.rpc_us.p50, 1)},
            {"p95", rounded(player.rpc_us.p95, 1)},
            {"p99", rounded(player.rpc_us.p99, 1)},
            {"max", rounded(player.rpc_us.max, 1)}}},
          {"commands", player.commands},
          {"unimplemented_actions", player.unimplemented_actions}};
}

Json json_of(const TeamResult& team) {
  Json players = Json::array();
  for (const PlayerResult& player : team.players) players.push_back(json_of(player));
  return {{"name", team.name},
          {"endpoint", team.endpoint},
          {"score", team.score},
          {"penalty_score", team.penalty_score ? Json(*team.penalty_score) : Json(nullptr)},
          {"cpu_seconds", rounded(team.cpu_seconds, 1000)},
          {"players", std::move(players)},
          {"coach", team.coach ? json_of(*team.coach) : Json(nullptr)}};
}

Json json_of(const Goal& goal) {
  return {{"cycle", goal.cycle},
          {"side", side_name(goal.side)},
          {"unum", goal.unum == 0 ? Json(nullptr) : Json(goal.unum)}};
}

Json json_of(const ProcessResult& process) {
  return {{"name", process.name},
          {"command", process.command},
          {"log", process.log},
          {"exit", process.exit},
          {"cpu_seconds", rounded(process.cpu_seconds, 1000)}};
}

Json json_of(const ProcessFailure& failure) {
  return {{"process", failure.process},
          {"exit", failure.exit},
          {"log", failure.log},
          {"output", failure.output}};
}

}  // namespace

std::string to_json(const std::vector<PlayerResult>& players) {
  Json list = Json::array();
  for (const PlayerResult& player : players) list.push_back(json_of(player));
  return list.dump();
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
  const auto won = winner(result);
  Json goals = Json::array();
  for (const Goal& goal : result.goals) goals.push_back(json_of(goal));
  Json processes = Json::array();
  for (const ProcessResult& process : result.processes) processes.push_back(json_of(process));
  const auto& cpu = result.server_cpu_seconds;
  const Json document = {{"schema", "cls.match/1"},
                         {"left", json_of(result.left)},
                         {"right", json_of(result.right)},
                         {"trainer", result.trainer ? json_of(*result.trainer) : Json(nullptr)},
                         {"winner", won ? Json(*won) : Json(nullptr)},
                         {"valid", result.valid()},
                         {"end_reason", name(result.end_reason)},
                         {"message", result.message.empty() ? Json(nullptr) : Json(result.message)},
                         {"fault", result.fault ? Json(side_name(*result.fault)) : Json(nullptr)},
                         {"failure", result.failure ? json_of(*result.failure) : Json(nullptr)},
                         {"cycles", result.cycles},
                         {"steps", result.steps},
                         {"seed", result.seed},
                         {"mode", result.mode},
                         {"deterministic", result.deterministic},
                         {"server",
                          {{"kind", result.server_kind},
                           {"version", result.server_version},
                           {"seed", result.server_seed.value_or(result.seed)},
                           {"missed_cycles", result.server_missed_cycles},
                           {"cpu_seconds", cpu ? Json(rounded(*cpu, 1000)) : Json(nullptr)}}},
                         {"goals", std::move(goals)},
                         {"wall_seconds", rounded(result.wall_seconds, 1000)},
                         {"cycles_per_second", rounded(result.cycles_per_second, 10)},
                         {"folder", result.folder},
                         {"log_files",
                          {{"rcg", result.rcg.empty() ? Json(nullptr) : Json(result.rcg)},
                           {"rcl", result.rcl.empty() ? Json(nullptr) : Json(result.rcl)}}},
                         {"processes", std::move(processes)},
                         {"warnings", result.warnings},
                         {"versions", {{"cls", base::kVersion}, {"wire", base::kWireVersion}}}};
  // Bytes of a foreign program may stand in a message: replace what is not UTF-8.
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cls::orchestration::match
