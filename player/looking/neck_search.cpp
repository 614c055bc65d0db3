// Scores neck angles by direction ages and stale players.
#include "player/looking/neck_search.h"

#include <algorithm>
#include <cmath>

#include "soccer/directions.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

/// Unit vectors along the middles of the sectors.
const std::array<Vec2, ViewMemory::kSectors>& sector_directions() {
  static const auto directions = [] {
    std::array<Vec2, ViewMemory::kSectors> table;
    for (int i = 0; i < ViewMemory::kSectors; ++i) {
      table[i] = soccer::polar_degrees(1.0, (i + 0.5) * ViewMemory::kSectorDegrees - 180.0);
    }
    return table;
  }();
  return directions;
}

/// Distance from `from` to the border of the pitch along `direction`; 0 outside.
double pitch_ahead(Vec2 from, Vec2 direction) {
  const auto one = [](double at, double step, double half) {
    if (std::fabs(step) < 1e-9) return 1000.0;
    return ((step > 0.0 ? half : -half) - at) / step;
  };
  return std::max(0.0, std::min(one(from.x, direction.x, soccer::kHalfLength),
                                one(from.y, direction.y, soccer::kHalfWidth)));
}

}  // namespace

SectorSums sector_sums(const std::array<int, ViewMemory::kSectors>& values) {
  SectorSums sums{};
  for (std::size_t i = 0; i + 1 < sums.size(); ++i)
    sums[i + 1] = sums[i] + values[i % values.size()];
  return sums;
}

NeckSearch::NeckSearch(const WorldModel& world, const ViewMemory& view, const CommandSlots& slots)
    : world_(world),
      view_(view),
      here_(slots.next_position()),
      half_view_(view_angle(world.server(), slots.next_view_width()) / 2.0),
      neck_now_(world.self.neck.degrees()),
      body_(slots.next_body()) {}

bool NeckSearch::knows_all_players() const {
  return world_.teammates.size() >= soccer::kPlayersPerTeam - 1 &&
         world_.opponents.size() >= soccer::kPlayersPerTeam;
}

SectorSums NeckSearch::field_sums() const {
  // Ignore directions in which the pitch ends within this distance.
  constexpr double kWorthwhile = 8.0;
  const auto& directions = sector_directions();

  std::array<int, ViewMemory::kSectors> field;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const bool worthwhile = pitch_ahead(here_, directions[i]) >= kWorthwhile;
    field[i] = worthwhile ? std::min(view_.ages[i], 100) : 0;
  }

  return sector_sums(field);
}

void NeckSearch::add_players(const PlayerList& list, bool ours, WeightedDirections& out) const {
  const InterceptTable& table = world_.intercept;
  const bool attack = world_.self.kickable || world_.kickable_teammate() ||
                      table.first_teammate_steps < table.first_opponent_steps;

  base::FixedList<Vec2, PlayerList::capacity()> relatives;
  for (const PlayerState& player : list) relatives.push_back(player.position - here_);
  std::array<double, PlayerList::capacity()> degrees;
  soccer::directions(relatives.begin(), relatives.size(), degrees.data());

  for (std::size_t i = 0; i < list.size(); ++i) {
    const PlayerState& player = list[i];
    const double age = std::min(player.seen_pos_count, 100) + 1.0;
    double weight = age * age * math::exp(-relatives[i].squared_length() / 800.0);
    if (ours && attack && player.position.x > here_.x) weight *= 4.0;
    out.push_back({(AngleDeg(degrees[i]) - body_).degrees(), weight});
  }
}

double NeckSearch::player_score(const WeightedDirections& players, double neck) const {
  double score = 0.0;
  for (const WeightedDirection& player : players) {
    // Both are between -180 and 180 degrees.
    const double apart = std::fabs(player.relative - neck);
    const double margin = half_view_ - (apart > 180.0 ? 360.0 - apart : apart);
    if (margin > 0.0) score += player.weight * (1.0 + margin / 90.0);
  }
  return score;
}

template <typename Score>
double NeckSearch::best(double low, double high, const Score& score) const {
  constexpr double kStep = 5.0;
  constexpr double kHalfTurn = 180.0;  // a faulty server may send larger limits
  low = std::clamp(low, -kHalfTurn, kHalfTurn);
  high = std::clamp(high, -kHalfTurn, kHalfTurn);

  const int steps = static_cast<int>(std::floor((high - low) / kStep + 1e-9));
  double best_neck = low;
  double best_score = -1.0;

  for (int i = 0; i <= steps; ++i) {
    const double neck = low + i * kStep;
    const double value = score(neck);
    // Ties: prefer the angle nearest to the current neck.
    const bool nearer = std::fabs(neck - neck_now_) < std::fabs(best_neck - neck_now_);
    if (value > best_score || (value == best_score && nearer)) {
      best_score = value;
      best_neck = neck;
    }
  }

  return best_neck;
}

double NeckSearch::best_field(double low, double high) const {
  const SectorSums sums = field_sums();
  return best(low, high, [&](double neck) {
    return static_cast<double>(sum_of(sums, sectors_around(body_ + neck, half_view_)));
  });
}

double NeckSearch::best_players(double low, double high) const {
  WeightedDirections players;
  if (knows_all_players()) {
    add_players(world_.teammates, true, players);
    add_players(world_.opponents, false, players);
  }
  return best(low, high, [&](double neck) { return player_score(players, neck); });
}

}  // namespace cls::player
