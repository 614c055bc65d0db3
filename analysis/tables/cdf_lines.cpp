// Events as JSON objects; frames as text, because a match has a hundred thousand places.
#include "analysis/tables/cdf_match.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/statistics/event_list.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/number_text.h"
#include "soccer/play_mode.h"

namespace cls::analysis {
namespace {

using base::Json;
using soccer::PlayMode;

std::string text_of(const Json& json) { return base::json_line(json); }

// A restart names the kick; otherwise the first property of the event does.
Json sub_type(const Event& event, PlayMode before) {
  switch (soccer::without_side(before)) {
    case PlayMode::kKickInLeft:
      return "throw_in";
    case PlayMode::kCornerKickLeft:
      return "corner_kick";
    case PlayMode::kFreeKickLeft:
    case PlayMode::kIndirectFreeKickLeft:
      return "free_kick";
    case PlayMode::kGoalKickLeft:
      return "goal_kick";
    case PlayMode::kKickOffLeft:
      return "kick_off";
    default:
      return event.marks.empty() ? Json() : Json(event.marks.front());
  }
}

bool is_successful(const MatchStatistics& all, const Event& event) {
  switch (event.kind) {
    case EventKind::kPass:
      return all.passes[event.index].completed();
    case EventKind::kShot:
      return all.shots[event.index].outcome == ShotOutcome::kGoal;
    case EventKind::kGoal:
      return !all.goals[event.index].own_goal;
    case EventKind::kFoul:
      return false;
    case EventKind::kCarry:
    case EventKind::kTackle:
      break;
  }
  return true;
}

// "07:03.40": minutes, seconds and hundredths of game time.
std::string match_clock(const gamelog::MatchRecord& record, std::size_t frame) {
  const double seconds = record.time[frame] * cycle_seconds(record.server);
  const int minutes = static_cast<int>(seconds / 60.0);
  return fmt::format("{:02}:{:05.2f}", minutes, seconds - minutes * 60.0);
}

// With six significant digits, as logs have it: floats as doubles have digits that mean nothing.
double as_logged(double value) {
  std::string text;
  base::append_g(value, text);
  return base::parse_number(text).value_or(value);
}

Json event_object(const CdfMatch& match, const Event& event, std::size_t index) {
  const auto& record = match.record;
  const MatchStatistics& all = match.statistics;
  const Pass* pass = event.kind == EventKind::kPass ? &all.passes[event.index] : nullptr;
  const bool received = pass != nullptr && pass->completed();
  const std::size_t end = event.frame + (pass != nullptr ? pass->frames : 0);
  const std::size_t end_frame = std::min(end, record.frames() - 1);

  Json one = {
      {"id", fmt::format("{}_{}", match.id, index)},
      {"time", match.time_of(event.frame)},
      {"period", cdf_name(period_of(match.periods, event.frame).kind)},
      {"type", name(event.kind)},
      {"sub_type", event.frame == 0 ? Json() : sub_type(event, record.mode[event.frame - 1])},
      {"is_successful", is_successful(all, event)},
      {"outcome_type", event.result},
      {"player_id", match.player_id(slot_index(event.slot))},
      {"team_id", match.teams[team_of(event.slot)]},
      {"receiver_id", received ? Json(match.player_id(slot_index(event.other))) : Json()},
      {"receiver_time", received ? Json(match.time_of(end_frame)) : Json()},
      {"x", as_logged(event.from.x)},
      {"y", as_logged(0.0 - event.from.y)},
      {"x_end", as_logged(event.to.x)},
      {"y_end", as_logged(0.0 - event.to.y)},
      {"body_part", "other"},
      {"related_event_ids", nullptr},
      {"match_clock", match_clock(record, event.frame)}};
  if (event.kind == EventKind::kShot) {
    one["metrics"] = {{"xg", as_logged(all.expected[event.index])}};
  }

  return {{"match", {{"id", match.id}}},
          {"meta", {{"is_synced", true}}},
          {"event", one},
          {"tracking", {{"frame_id", event.frame}, {"frame_id_end", end_frame}}}};
}

// Writes the frames; texts that every frame repeats are made once.
class TrackingLines {
 public:
  explicit TrackingLines(const CdfMatch& match) : match_(match), record_(match.record) {
    match_text_ = R"(","match":{"id":)" + text_of(match.id) + "}";
    for (std::size_t team = 0; team < 2; ++team) teams_[team] = text_of(match.teams[team]);
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      players_[slot] = R"({"id":)" + text_of(match.player_id(slot));
    }
  }

  const std::string& line(std::size_t frame) {
    out_.clear();
    out_ += R"({"frame_id":)";
    base::append_int(static_cast<std::int64_t>(frame), out_);
    out_ += R"(,"timestamp":")" + match_.time_of(frame);
    out_ += R"(","period":")";
    out_ += cdf_name(period_of(match_.periods, frame).kind);
    out_ += match_text_;

    out_ += R"(,"teams":{"home":)";
    add_team(frame, 0);
    out_ += R"(,"away":)";
    add_team(frame, 1);
    out_ += R"(},"ball":)";
    add_ball(frame);

    out_ += match_.statistics.flow.is_live(frame) ? R"(,"ball_status":true)"
                                                  : R"(,"ball_status":false)";
    const std::int8_t owner = match_.statistics.flow.owner[frame];
    if (owner != kNoPlayer) out_ += R"(,"ball_poss_team_id":)" + teams_[team_of(owner)];
    out_ += "}\n";
    return out_;
  }

 private:
  void add_point(const gamelog::Point& point) {
    out_ += R"("x":)";
    base::append_g(point.x, out_);
    out_ += R"(,"y":)";
    base::append_g(0.0 - point.y, out_);
  }

  void add_team(std::size_t frame, std::size_t team) {
    out_ += R"({"id":)" + teams_[team] + R"(,"players":[)";
    bool first = true;
    for (const std::size_t slot : kTeamSlots[team]) {
      const std::size_t entry = entry_of(frame, slot);
      if (!gamelog::is_enabled(record_, entry)) continue;
      if (!first) out_ += ',';
      first = false;
      out_ += players_[slot] + ',';
      add_point(record_.players.position[entry]);
      const soccer::Vec2 velocity = record_.players.velocity[entry];
      out_ += R"(,"vel":)";
      base::append_g(velocity.length() / cycle_seconds(record_.server), out_);
      out_ += '}';
    }
    out_ += "]}";
  }

  void add_ball(std::size_t frame) {
    out_ += '{';
    add_point(record_.ball_position[frame]);
    out_ += R"(,"z":)";
    base::append_g(record_.ball_height[frame], out_);
    out_ += '}';
  }

  const CdfMatch& match_;
  const gamelog::MatchRecord& record_;
  std::string match_text_;
  std::array<std::string, 2> teams_;
  std::array<std::string, gamelog::kSlots> players_;
  std::string out_;
};

}  // namespace

std::string cdf_events(const CdfMatch& match) {
  std::string lines;
  std::size_t index = 0;
  for (const Event& event : list_events(match.statistics)) {
    const std::size_t number = index++;
    if (event.slot == kNoPlayer) continue;
    lines += text_of(event_object(match, event, number)) + "\n";
  }
  return lines;
}

void write_cdf_tracking(const CdfMatch& match, base::ByteSink& sink) {
  TrackingLines lines(match);
  for (std::size_t i = 0; i < match.record.frames(); ++i) sink.write(lines.line(i));
}

}  // namespace cls::analysis
