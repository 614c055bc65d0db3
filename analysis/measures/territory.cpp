// Computes ball positions by area, and pitch control.
#include "analysis/measures/territory.h"

#include <algorithm>
#include <limits>

#include "analysis/play/pitch_areas.h"
#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr double kQuarter = soccer::kPitchLength / 4;  // borders at -26.25, 0 and 26.25
constexpr int kControlStep = 10;
constexpr int kControlColumns = 21;
constexpr int kControlRows = 14;

std::size_t third_of(double x) { return x < -kThirdBorder ? 0 : x <= kThirdBorder ? 1 : 2; }

std::size_t quarter_of(double x) { return x < -kQuarter ? 0 : x < 0.0 ? 1 : x < kQuarter ? 2 : 3; }

// Squared times in which the first player of each team reaches a point; top speeds depend on the
// player type.
class ControlMap {
 public:
  ControlMap(const gamelog::MatchRecord& record, std::size_t frame) {
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      const std::size_t entry = entry_of(frame, slot);
      if (!gamelog::is_enabled(record, entry)) continue;
      const auto speed = static_cast<float>(type_of(record, entry).player_speed_max);
      runners_[team_of(slot)][count_[team_of(slot)]++] = {record.players.position[entry].x,
                                                          record.players.position[entry].y,
                                                          1.0F / (speed * speed)};
    }
  }

  // Share of the cells of each team, from 0 to 1; cells without a first team count for none.
  PerTeam<double> shares() const {
    PerTeam<int> cells = {};
    for (int column = 0; column < kControlColumns; ++column) {
      const float x = (static_cast<float>(column) + 0.5F) * 5.0F - 52.5F;
      for (int row = 0; row < kControlRows; ++row) {
        const float y = (static_cast<float>(row) + 0.5F) * 5.0F - 35.0F;
        const float left = fastest(0, x, y);
        const float right = fastest(1, x, y);
        cells[0] += left < right;
        cells[1] += right < left;
      }
    }

    constexpr double kCells = kControlColumns * kControlRows;
    return {cells[0] / kCells, cells[1] / kCells};
  }

 private:
  struct Runner {
    float x;
    float y;
    float inverse_squared_speed;
  };

  float fastest(std::size_t team, float x, float y) const {
    float best = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < count_[team]; ++i) {
      const Runner& runner = runners_[team][i];
      const float dx = runner.x - x;
      const float dy = runner.y - y;
      best = std::min(best, (dx * dx + dy * dy) * runner.inverse_squared_speed);
    }
    return best;
  }

  PerTeam<std::array<Runner, kTeamSize>> runners_ = {};
  PerTeam<std::size_t> count_ = {};
};

void add_pitch_control(const Flow& flow, Territory& result) {
  int samples = 0;
  int live = 0;

  for (std::size_t i = 0; i < flow.phase.size(); ++i) {
    if (!flow.is_live(i) || live++ % kControlStep != 0) continue;
    const PerTeam<double> shares = ControlMap(*flow.record, i).shares();
    ++samples;
    for (std::size_t team = 0; team < 2; ++team) result.teams[team].pitch_control += shares[team];
  }

  for (TeamTerritory& team : result.teams) {
    if (samples > 0) team.pitch_control /= samples;
  }
}

void add_touches(const Flow& flow, Territory& result) {
  for (const Touch& touch : flow.touches) {
    if (touch.live_phase < 0) continue;
    for (const std::int8_t player : touch.nearest) {
      if (player == kNoPlayer) continue;
      const Vec2 seen = touch.contact * attack_sign(player);
      TeamTerritory& team = result.teams[team_of(player)];
      team.box_touches += in_opponent_box(seen);
      team.final_third_touches += third_of(seen.x) == 2;
    }
  }
}

}  // namespace

double Territory::field_tilt() const {
  const int both = teams[0].final_third_touches + teams[1].final_third_touches;
  return both == 0 ? 0.5 : static_cast<double>(teams[0].final_third_touches) / both;
}

Territory measure_territory(const Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  Territory result;
  result.frames = static_cast<int>(record.frames());
  double sum_x = 0.0;

  for (std::size_t i = 0; i < record.frames(); ++i) {
    if (!flow.is_live(i)) continue;
    const Vec2 ball = record.ball_position[i];
    ++result.live_frames;
    ++result.thirds[third_of(ball.x)];
    ++result.quarters[quarter_of(ball.x)];
    sum_x += ball.x;

    if (flow.owner[i] == kNoPlayer) continue;
    const double sign = attack_sign(flow.owner[i]);
    TeamTerritory& team = result.teams[team_of(flow.owner[i])];
    ++team.thirds_owned[third_of(ball.x * sign)];
    const bool continues = i > 0 && flow.live_phase[i] == flow.live_phase[i - 1];
    team.box_entries += continues && in_opponent_box(ball * sign) &&
                        !in_opponent_box(Vec2(record.ball_position[i - 1]) * sign);
  }

  if (result.live_frames > 0) result.mean_ball_x = sum_x / result.live_frames;
  add_touches(flow, result);
  add_pitch_control(flow, result);
  return result;
}

}  // namespace cls::analysis
