// Compares the world model of a transcript with the game log.
#include "checks/perception_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/text/json.h"
#include "base/text/json_text.h"
#include "soccer/side.h"

namespace cls::checks {
namespace {

using gamelog::MatchRecord;
using gamelog::RcgVersion;
using player::ErrorSummary;
using soccer::Side;

/// Frames by game time and index among the frames of that time.
using FrameIndex = std::map<std::pair<int, int>, std::size_t>;

FrameIndex index_frames(const MatchRecord& log) {
  FrameIndex index;
  std::map<int, int> repeated;
  for (std::size_t frame = 0; frame < log.frames(); ++frame) {
    index[{log.time[frame], repeated[log.time[frame]]++}] = frame;
  }
  return index;
}

player::GroundTruth truth_of(const MatchRecord& log, std::size_t frame) {
  player::GroundTruth truth;
  truth.ball_position = log.ball_position[frame];
  if (log.version != RcgVersion::kV1 && log.version != RcgVersion::kV2) {
    truth.ball_velocity = log.ball_velocity[frame];
  }

  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::size_t entry = frame * gamelog::kSlots + slot;
    truth.players[slot] = {is_enabled(log, entry), log.players.position[entry],
                           log.players.body[entry]};
  }
  return truth;
}

// Player types are random per match. Types the player did not receive equal the default type.
bool same_types(const player::MatchParameters& received, const MatchRecord& log) {
  constexpr double kRounding = 1e-4;  // of binary game logs
  for (std::size_t i = 1; i < std::min(received.types.size(), log.types.size()); ++i) {
    const double speed = received.types[i].player_speed_max;
    const double reach = received.types[i].kickable_margin;
    const bool is_default =
        speed == received.types[0].player_speed_max && reach == received.types[0].kickable_margin;

    if (is_default) continue;

    if (std::fabs(speed - log.types[i].player_speed_max) > kRounding ||
        std::fabs(reach - log.types[i].kickable_margin) > kRounding) {
      return false;
    }
  }
  return true;
}

base::Result<void> belong_together(const player::WorldModel& world, const MatchRecord& log) {
  if (world.unum == 0) {
    return base::Error{"no player connects (no valid reply to init or reconnect)"};
  }

  const gamelog::TeamFrames& teams = log.final_teams();
  const std::string_view recorded = teams[world.our_side == Side::kRight ? 1 : 0].name;
  const std::string_view name = world.our_team_name.view();
  if (!name.empty() && !recorded.empty() && name != recorded) {
    return base::Error{fmt::format("the player is of team '{}' on the {}, the log has '{}' there",
                                   name, side_name(world.our_side), recorded)};
  }

  if (!same_types(*world.parameters, log)) {
    return base::Error{"the player types differ from those of the log: another match"};
  }
  return {};
}

struct Row {
  const char* name;
  const char* unit;
  const char* key;
  ErrorSummary error;
};

std::vector<Row> rows(const player::PerceptionError& errors) {
  return {{"own position", "m", "self", errors.self()},
          {"body angle", "deg", "body_angle", errors.body_angle()},
          {"ball", "m", "ball", errors.ball()},
          {"ball velocity", "m/cycle", "ball_velocity", errors.ball_velocity()},
          {"teammates", "m", "teammates", errors.teammates()},
          {"opponents", "m", "opponents", errors.opponents()}};
}

}  // namespace

base::Result<PerceptionCheck> check_perception(std::string_view transcript, const MatchRecord& log,
                                               const WorldModelObserver& on_decision) {
  PerceptionCheck check;
  const FrameIndex frames = index_frames(log);
  player::TranscriptReplay replay =
      player::replay_transcript(transcript, [&](const player::WorldModel& world) {
        const auto frame = frames.find({world.game.time.cycle, world.game.time.stopped});
        if (frame == frames.end() || world.unum == 0) return;
        ++check.decisions;
        if (on_decision) on_decision(world);
        check.errors.add(world, truth_of(log, frame->second));
      });

  TRY(belong_together(replay.world, log));
  if (check.decisions == 0) {
    return base::Error{"no decision of the player matches a cycle of the log"};
  }

  check.team = replay.world.our_team_name.view();
  check.side = replay.world.our_side;
  check.unum = replay.world.unum;
  check.damage = std::move(replay.errors);
  return check;
}

std::string to_text(const PerceptionCheck& check) {
  std::string text = fmt::format("player {} of {} ({}), {} cycles of play_on\n\n", check.unum,
                                 check.team.empty() ? "an unnamed team" : check.team,
                                 side_name(check.side), check.errors.cycles());

  text += fmt::format("{:14} {:8} {:>9} {:>9} {:>9}\n", "error of", "in", "mean", "p95", "samples");
  for (const Row& row : rows(check.errors)) {
    if (row.error.n == 0) {
      text += fmt::format("{:14} {:8} {:>9} {:>9} {:>9}\n", row.name, row.unit, "-", "-", 0);
      continue;
    }
    text += fmt::format("{:14} {:8} {:9.3f} {:9.3f} {:9}\n", row.name, row.unit, row.error.mean,
                        row.error.p95, row.error.n);
  }
  return text;
}

std::string to_json(const PerceptionCheck& check) {
  base::Json document = {{"schema", "cls.perception/1"},
                         {"team", check.team},
                         {"side", side_name(check.side)},
                         {"player", check.unum},
                         {"cycles", check.errors.cycles()}};

  for (const Row& row : rows(check.errors)) {
    base::Json& error = document[row.key];
    error = {{"mean", nullptr}, {"p95", nullptr}, {"n", row.error.n}};

    if (row.error.n == 0) continue;
    error["mean"] = row.error.mean;
    error["p95"] = row.error.p95;
  }
  return base::json_document(document);
}

}  // namespace cls::checks
