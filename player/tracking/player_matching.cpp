// Matches by uniform number first, then by minimum-cost assignment.
#include "player/tracking/player_matching.h"

#include <algorithm>
#include <cmath>

#include "base/index.h"
#include "player/tracking/assignment.h"
#include "player/tracking/tracking.h"
#include "player/world/candidates.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

// Gates: maximum squared Mahalanobis distance of a match.
constexpr double kGate = 16.0;
constexpr double kStrictGate = 9.0;

double squared_mahalanobis(const PlayerState& track, const PlayerObservation& observation) {
  return mahalanobis_distance(track.position, track.covariance, observation.observed).squared;
}

/// Nearest unmatched track within the gate; null if none.
PlayerState* nearest_unmatched(PlayerList& list, const PlayerObservation& observation,
                               double gate) {
  Lowest<PlayerState*> best{gate};
  for (PlayerState& track : list) {
    if (!track.matched) best.offer(squared_mahalanobis(track, observation), &track);
  }
  return best.value;
}

/// Moves a lost player back to the tracks with a new id.
PlayerState* restore_lost(WorldModel& world, PlayerState* lost) {
  const PlayerState old = *lost;
  erase_track(world.lost, lost);
  PlayerState* track = new_player(world, old.side, old.unum);
  const int id = track->id;
  *track = old;
  track->id = id;
  return track;
}

/// Moves a track of unknown team into a team.
PlayerState* assign_team(WorldModel& world, PlayerState* unknown, Side side) {
  PlayerState moved = *unknown;
  erase_track(world.unknowns, unknown);
  PlayerState* track = new_player(world, side, 0);
  moved.side = side;
  *track = moved;
  return track;
}

/// Finds, renames or creates the track of this uniform number; never null.
PlayerState* track_for_number(WorldModel& world, const PlayerObservation& observation) {
  PlayerList& list = list_of(world, observation.side);

  const int unum = observation.seen->unum;
  PlayerState* named = find_number(list, observation.side, unum);
  PlayerState* lost = find_number(world.lost, observation.side, unum);
  PlayerState* at_position = nearest_unmatched(list, observation, kStrictGate);
  if (at_position == named) at_position = nullptr;

  if (named == nullptr && at_position == nullptr) {
    if (PlayerState* unknown = nearest_unmatched(world.unknowns, observation, kStrictGate)) {
      at_position = assign_team(world, unknown, observation.side);
    }
  }

  if (at_position == nullptr) {
    if (named != nullptr) return named;
    if (lost != nullptr) return restore_lost(world, lost);
    return new_player(world, observation.side, unum);
  }

  // Another player was tracked at this position: the numbers were swapped.
  if (named != nullptr) {
    std::swap(named->unum, at_position->unum);
    std::swap(named->goalie, at_position->goalie);
    std::swap(named->unum_count, at_position->unum_count);
    return at_position;
  }

  if (at_position->unum != 0) {
    world.lost.push_back(*at_position);  // that player is elsewhere
  }

  forget_lost(world, observation.side, unum);
  at_position->unum = unum;
  return at_position;
}

void match_numbers(WorldModel& world, const Viewpoint& view,
                   const PlayerObservationList& observations, UpdateTrack update) {
  base::FixedList<const PlayerObservation*, 24> open;

  for (const PlayerObservation& observation : observations) {
    if (observation.seen->unum == 0) continue;
    PlayerState* named =
        find_number(list_of(world, observation.side), observation.side, observation.seen->unum);
    if (named != nullptr && squared_mahalanobis(*named, observation) < kGate) {
      update(*named, view, observation);
    } else {
      open.push_back(&observation);
    }
  }

  for (const PlayerObservation* observation : open) {
    update(*track_for_number(world, *observation), view, *observation);
  }
}

// Cost of a new track: -2 log of the probability density of an untracked player at that position,
// per square meter.
constexpr double kNewTrackProbability = 0.02;

double new_track_cost() {
  static const double cost =
      -2.0 * math::log(kNewTrackProbability / (soccer::kPitchLength * soccer::kPitchWidth));
  return cost;
}

/// -2 log of the density of the observation given this track.
double track_cost(const PlayerState& track, const PlayerObservation& observation) {
  constexpr double kTwoLogTwoPi = 3.6757541328186907;
  constexpr double kImpossible = 1e6;
  const MahalanobisDistance m =
      mahalanobis_distance(track.position, track.covariance, observation.observed);
  if (m.squared > kGate) return kImpossible + m.squared;
  return m.squared + math::log(m.determinant) + kTwoLogTwoPi;
}

using TrackPointers = base::FixedList<PlayerState*, CostTable::kMaxColumns>;

void add_unmatched(PlayerList& list, Side side, TrackPointers& out) {
  for (PlayerState& track : list) {
    if (!track.matched && (track.side == side || track.side == Side::kNeutral))
      out.push_back(&track);
  }
}

void match_team(WorldModel& world, const Viewpoint& view, const PlayerObservationList& observations,
                Side side, UpdateTrack update) {
  base::FixedList<const PlayerObservation*, CostTable::kMaxRows> rows;
  for (const PlayerObservation& observation : observations) {
    if (observation.side == side && observation.seen->unum == 0) rows.push_back(&observation);
  }
  if (rows.empty()) return;
  TrackPointers columns;
  add_unmatched(list_of(world, side), side, columns);
  const std::size_t tracked = columns.size();

  CostTable table;
  table.rows = rows.size();
  table.columns = tracked + rows.size();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < tracked; ++c) table.cost[r][c] = track_cost(*columns[c], *rows[r]);
    for (std::size_t c = tracked; c < table.columns; ++c) table.cost[r][c] = new_track_cost();
  }
  const auto column_of = assign(table);

  // Known tracks first: adding or removing tracks invalidates the pointers.
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (column_of[r] < tracked) update(*columns[column_of[r]], view, *rows[r]);
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (column_of[r] < tracked) continue;
    PlayerState* unknown = nearest_unmatched(world.unknowns, *rows[r], kStrictGate);
    update(unknown != nullptr ? *assign_team(world, unknown, side) : *new_player(world, side, 0),
           view, *rows[r]);
  }
}

/// If no track has the known goalie number, assigns it to the rearmost player inside the penalty
/// area.
void number_the_goalie(WorldModel& world, Side side) {
  const bool our_team = side == world.our_side;
  const int unum = our_team ? world.our_goalie_unum : world.their_goalie_unum;
  PlayerList& list = list_of(world, side);
  if (unum == 0 || (our_team && unum == world.unum) || find_number(list, side, unum) != nullptr)
    return;

  const double toward = our_team ? -1.0 : 1.0;
  PlayerState* last = std::ranges::max_element(
      list, {}, [&](const PlayerState& track) { return toward * track.position.x; });
  if (last == list.end() || last->unum != 0) return;
  if (!in_own_box({-toward * last->position.x, last->position.y})) return;

  last->unum = unum;
  last->goalie = true;
  forget_lost(world, side, unum);
}

/// If all numbers of a team but one are tracked and one unnumbered player is visible, assigns it
/// the remaining number.
void number_the_last(WorldModel& world, Side side) {
  PlayerList& list = list_of(world, side);
  constexpr int kRecent = 15;

  std::array<bool, soccer::kPlayersPerTeam + 1> taken{};
  if (side == world.our_side) taken[base::index(world.unum)] = true;

  PlayerState* unnumbered = nullptr;
  for (PlayerState& track : list) {
    if (track.unum != 0) {
      if (track.pos_count > kRecent) return;
      taken[base::index(track.unum)] = true;
    } else if (unnumbered != nullptr || !track.matched) {
      return;
    } else {
      unnumbered = &track;
    }
  }
  if (unnumbered == nullptr) return;

  taken[0] = true;  // no number
  if (std::ranges::count(taken, false) != 1) return;
  unnumbered->unum = static_cast<int>(std::ranges::find(taken, false) - taken.begin());
  forget_lost(world, side, unnumbered->unum);
}

void match_anonymous(WorldModel& world, const Viewpoint& view,
                     const PlayerObservationList& observations, UpdateTrack update) {
  for (const PlayerObservation& observation : observations) {
    if (observation.side != Side::kNeutral) continue;

    PlayerState* best = nullptr;
    double least = kGate;
    for (PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
      PlayerState* track = nearest_unmatched(*list, observation, least);
      if (track == nullptr) continue;
      least = squared_mahalanobis(*track, observation);
      best = track;
    }

    if (best == nullptr) best = new_player(world, Side::kNeutral, 0);
    update(*best, view, observation);
  }
}

}  // namespace

void match_players(WorldModel& world, const Viewpoint& view,
                   const PlayerObservationList& observations, UpdateTrack update) {
  match_numbers(world, view, observations, update);
  match_team(world, view, observations, Side::kLeft, update);
  match_team(world, view, observations, Side::kRight, update);
  match_anonymous(world, view, observations, update);

  number_the_goalie(world, Side::kLeft);
  number_the_goalie(world, Side::kRight);
  number_the_last(world, Side::kLeft);
  number_the_last(world, Side::kRight);
}

}  // namespace cls::player
