// What a match over UDP came to: from the server's log, its lines, and what our teams saw.
#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <variant>

#include "analysis/results/match_summary.h"
#include "base/system/version.h"
#include "gamelog/rcg/rcg_reader.h"
#include "orchestration/match/network_match.h"
#include "orchestration/match/result/match_folder.h"

namespace cls::orchestration::match {
namespace {

using Json = nlohmann::ordered_json;

std::optional<int> penalties(const analysis::MatchSummary& summary, std::size_t side) {
  if (!summary.penalties) return std::nullopt;
  return summary.teams[side].penalty_score;
}

Goal goal_of(const analysis::GoalSummary& goal) {
  return {goal.cycle, goal.side, goal.own_goal ? 0 : goal.unum};
}

}  // namespace

// The score that our players heard must be the one in the log.
void NetworkMatch::compare_with_own(MatchResult& result) const {
  for (const Side& side : sides_) {
    if (!side.own || side.own->moment().cycles_seen == 0) continue;
    const MatchProgress seen = side.own->moment().progress;
    if (seen.left_score == result.left.score && seen.right_score == result.right.score) continue;
    result.warnings.push_back(fmt::format(
        "the log says {} : {}, but the players of {} counted {} : {}", result.left.score,
        result.right.score, side.name, seen.left_score, seen.right_score));
  }
}

// A server of ours that left no log: nobody but our players can tell the score.
void NetworkMatch::do_without_log(MatchResult& result, const std::string& why) const {
  if (!plan_.server || !result.valid()) return;
  const bool seen = sides_[0].own || sides_[1].own;
  if (seen) {
    result.warnings.push_back(
        fmt::format("score and cycles are those that our players heard: {}", why));
    return;
  }
  result.end_reason = EndReason::kServerFailed;
  result.message = fmt::format("the result is not known: {}", why);
}

void NetworkMatch::read_log(MatchResult& result) const {
  const auto record = gamelog::read_rcg_file((folder_ / kGameLogFile).string());
  if (!record) return do_without_log(result, record.error().message);
  if (record->frames() == 0) return do_without_log(result, "the game log holds no cycle");
  const analysis::MatchSummary summary = analysis::summarize(*record, nullptr);
  const std::array<TeamResult*, 2> teams = {&result.left, &result.right};
  for (std::size_t i = 0; i < 2; ++i) {
    if (!summary.teams[i].name.empty()) teams[i]->name = summary.teams[i].name;
    teams[i]->score = summary.teams[i].score;
    teams[i]->penalty_score = penalties(summary, i);
  }
  result.cycles = summary.cycles;
  result.steps = summary.frames;
  for (const analysis::GoalSummary& goal : summary.goals) result.goals.push_back(goal_of(goal));
  result.rcg = kGameLogFile;
  std::error_code code;
  if (std::filesystem::exists(folder_ / kTextLogFile, code)) result.rcl = kTextLogFile;
  if (result.valid()) compare_with_own(result);
}

// Without a log of ours: as the players saw it.
void NetworkMatch::take_own_view(MatchResult& result) const {
  for (const Side& side : sides_) {
    if (!side.own) continue;
    const OwnTeam::Moment moment = side.own->moment();
    if (moment.progress.cycle < result.cycles) continue;
    result.cycles = moment.progress.cycle;
    result.steps = moment.cycles_seen;
    result.left.score = moment.progress.left_score;
    result.right.score = moment.progress.right_score;
  }
}

void NetworkMatch::write_events(EventLog& events, const MatchResult& result) const {
  events.add(0, "started",
             {{"left", result.left.name}, {"right", result.right.name}, {"seed", result.seed}});
  const auto record = gamelog::read_rcg_file((folder_ / kGameLogFile).string());
  auto goal = result.goals.begin();
  std::array<int, 2> score = {};
  const auto goals_until = [&](int time) {
    for (; goal != result.goals.end() && goal->cycle <= time; ++goal) {
      const bool left = goal->side == soccer::Side::kLeft;
      ++score[left ? 0 : 1];
      events.add(goal->cycle, "goal",
                 {{"side", left ? "left" : "right"},
                  {"unum", goal->unum == 0 ? Json(nullptr) : Json(goal->unum)},
                  {"score", score}});
    }
  };
  for (const gamelog::Note& note : record ? record->notes : std::vector<gamelog::Note>()) {
    const auto* mode = std::get_if<soccer::PlayMode>(&note.content);
    if (mode == nullptr) continue;
    goals_until(note.time);
    events.add(note.time, "play_mode", {{"mode", soccer::name(*mode)}});
  }
  goals_until(result.cycles);
  events.add(result.cycles, "ended",
             {{"end_reason", name(result.end_reason)},
              {"score", {result.left.score, result.right.score}}});
}

MatchResult NetworkMatch::result(MatchObserver& observer) const {
  MatchResult result;
  const std::array<TeamResult*, 2> teams = {&result.left, &result.right};
  for (std::size_t i = 0; i < 2; ++i) {
    const Side& side = sides_[i];
    if (side.own) *teams[i] = side.own->side().result();
    teams[i]->name = team_name(i);
    teams[i]->endpoint = side.endpoint;
    if (side.foreign) teams[i]->cpu_seconds = side.foreign->cpu_seconds();
  }
  if (sides_.size() > 2 && sides_[2].own) result.trainer = sides_[2].own->side().result().coach;
  const ServerNews news = output_.news();
  result.end_reason = end_->reason;
  result.message = end_->message;
  result.fault = fault_;
  result.failure = end_->failure;
  result.try_again = try_again_;
  result.signal = watch_.signal();
  result.seed = seed_;
  result.mode = name(mode_of(options_));
  result.deterministic = false;
  result.server_kind = options_.server_choice.text;
  const auto kind = options_.server_choice.kind;
  const bool embedded = kind == ServerChoice::Kind::kEmbedded;
  for (const Side& side : sides_) {
    // Somebody else has chosen the mode there.
    if (side.own && kind == ServerChoice::Kind::kAddress) result.mode = name(side.own->mode());
  }
  result.server_version = embedded ? std::string(base::kVersion) : news.version;
  result.server_seed = news.seed;
  result.server_missed_cycles = news.missed_cycles;
  result.processes = processes_;
  if (server_ != nullptr) result.server_cpu_seconds = server_->cpu_seconds();
  result.warnings = warnings_;
  take_own_view(result);
  read_log(result);
  for (std::size_t i = warnings_.size(); i < result.warnings.size(); ++i) {
    observer.on_warning(result.warnings[i]);
  }
  const double seconds = std::chrono::duration<double>(last_cycle_ - first_cycle_).count();
  if (seconds > 0.0) result.cycles_per_second = result.cycles / seconds;
  return result;
}

}  // namespace cls::orchestration::match
