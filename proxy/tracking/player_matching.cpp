// Numbers first, then the cheapest assignment of the rest.
#include "proxy/tracking/player_matching.h"

#include <algorithm>
#include <cmath>

#include "proxy/tracking/assignment.h"
#include "proxy/tracking/player_tracking.h"
#include "soccer/math.h"
#include "soccer/pitch.h"

namespace cls::proxy {
namespace {

namespace math = soccer::math;
using soccer::Side;

// Squared deviations up to which a track and a sighting go together.
constexpr double kSameGate = 16.0;
constexpr double kClearlySame = 9.0;

double squared_misfit(const PlayerState& track, const PlayerSighting& sighting) {
  return misfit(belief_of(track), sighting.sight).squared;
}

PlayerState* find_number(PlayerList& list, Side side, int unum) {
  PlayerState* found = std::find_if(list.begin(), list.end(), [&](const PlayerState& p) {
    return p.unum == unum && p.side == side;
  });
  return found == list.end() ? nullptr : found;
}

/// The unclaimed track nearest to a sighting within the gate.
PlayerState* nearest_unclaimed(PlayerList& list, const PlayerSighting& sighting, double gate) {
  PlayerState* best = nullptr;
  double least = gate;
  for (PlayerState& track : list) {
    if (track.claimed) continue;
    const double squared = squared_misfit(track, sighting);
    if (squared < least) {
      least = squared;
      best = &track;
    }
  }
  return best;
}

void erase(PlayerList& list, const PlayerState* track) {
  list.erase(static_cast<std::size_t>(track - list.begin()));
}

/// Moves a lost player back among the tracks, under a new id.
PlayerState* revive(WorldModel& world, PlayerState* lost) {
  const PlayerState old = *lost;
  erase(world.lost, lost);
  PlayerState* track = new_player(world, old.side, old.unum);
  const int id = track->id;
  *track = old;
  track->id = id;
  return track;
}

/// Moves an anonymous track into a team.
PlayerState* join(WorldModel& world, PlayerState* unknown, Side side) {
  PlayerState moved = *unknown;
  erase(world.unknowns, unknown);
  PlayerState* track = new_player(world, side, 0);
  moved.side = side;
  *track = moved;
  return track;
}

/// The track that is to carry this number, made, found or renamed; never null.
PlayerState* track_for_number(WorldModel& world, const PlayerSighting& sighting) {
  PlayerList& list = list_of(world, sighting.side);
  const int unum = sighting.seen->unum;
  PlayerState* named = find_number(list, sighting.side, unum);
  PlayerState* lost = find_number(world.lost, sighting.side, unum);
  PlayerState* at_place = nearest_unclaimed(list, sighting, kClearlySame);
  if (at_place == named) at_place = nullptr;
  if (named == nullptr && at_place == nullptr) {
    if (PlayerState* unknown = nearest_unclaimed(world.unknowns, sighting, kClearlySame)) {
      at_place = join(world, unknown, sighting.side);
    }
  }
  if (at_place == nullptr) {
    if (named != nullptr) return named;
    if (lost != nullptr) return revive(world, lost);
    return new_player(world, sighting.side, unum);
  }
  // Somebody else was believed where this number stands: the names were wrong.
  if (named != nullptr) {
    std::swap(named->unum, at_place->unum);
    std::swap(named->goalie, at_place->goalie);
    std::swap(named->unum_count, at_place->unum_count);
    return at_place;
  }
  if (at_place->unum != 0) {
    PlayerState gone = *at_place;  // its number is somewhere, but not here
    world.lost.push_back(gone);
  }
  forget_lost(world, sighting.side, unum);
  at_place->unum = unum;
  return at_place;
}

void match_numbers(WorldModel& world, const Viewpoint& view, const SightingList& sightings,
                   TakeSighting take) {
  FixedList<const PlayerSighting*, 24> open;
  for (const PlayerSighting& sighting : sightings) {
    if (sighting.seen->unum == 0) continue;
    PlayerState* named =
        find_number(list_of(world, sighting.side), sighting.side, sighting.seen->unum);
    if (named != nullptr && squared_misfit(*named, sighting) < kSameGate) {
      take(*named, view, sighting);
    } else {
      open.push_back(&sighting);
    }
  }
  for (const PlayerSighting* sighting : open) {
    take(*track_for_number(world, *sighting), view, *sighting);
  }
}

// Cost of explaining a sighting by somebody new: minus twice the logarithm of the chance that a
// player without track turns up in that square metre.
constexpr double kNewcomerChance = 0.02;

double newcomer_cost() {
  static const double cost =
      -2.0 * math::log(kNewcomerChance / (soccer::kPitchLength * soccer::kPitchWidth));
  return cost;
}

/// Minus twice the logarithm of the density of the sighting, were it this track.
double track_cost(const PlayerState& track, const PlayerSighting& sighting) {
  constexpr double kTwoLogTwoPi = 3.6757541328186907;
  constexpr double kImpossible = 1e6;
  const Misfit m = misfit(belief_of(track), sighting.sight);
  if (m.squared > kSameGate) return kImpossible + m.squared;
  return m.squared + m.log_determinant + kTwoLogTwoPi;
}

using TrackPointers = FixedList<PlayerState*, CostTable::kMaxColumns>;

void add_unclaimed(PlayerList& list, Side side, TrackPointers& out) {
  for (PlayerState& track : list) {
    if (!track.claimed && (track.side == side || track.side == Side::kNeutral))
      out.push_back(&track);
  }
}

void match_team(WorldModel& world, const Viewpoint& view, const SightingList& sightings, Side side,
                TakeSighting take) {
  FixedList<const PlayerSighting*, CostTable::kMaxRows> rows;
  for (const PlayerSighting& sighting : sightings) {
    if (sighting.side == side && sighting.seen->unum == 0) rows.push_back(&sighting);
  }
  if (rows.empty()) return;
  TrackPointers columns;
  add_unclaimed(list_of(world, side), side, columns);
  const std::size_t tracked = columns.size();

  CostTable table;
  table.rows = rows.size();
  table.columns = tracked + rows.size();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < tracked; ++c) table.cost[r][c] = track_cost(*columns[c], *rows[r]);
    for (std::size_t c = tracked; c < table.columns; ++c) table.cost[r][c] = newcomer_cost();
  }
  const auto column_of = assign(table);

  // Known tracks first: the pointers into the lists hold until something is added or removed.
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (column_of[r] < tracked) take(*columns[column_of[r]], view, *rows[r]);
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (column_of[r] < tracked) continue;
    PlayerState* unknown = nearest_unclaimed(world.unknowns, *rows[r], kClearlySame);
    take(unknown != nullptr ? *join(world, unknown, side) : *new_player(world, side, 0), view,
         *rows[r]);
  }
}

/// When the goalie's number is known and nobody has it, the one in his penalty area behind all the
/// others is the goalie.
void number_the_goalie(WorldModel& world, Side side) {
  const bool ours = side == world.our_side;
  const int unum = ours ? world.our_goalie_unum : world.their_goalie_unum;
  PlayerList& list = list_of(world, side);
  if (unum == 0 || (ours && unum == world.unum) || find_number(list, side, unum) != nullptr) return;
  const double toward = ours ? -1.0 : 1.0;
  PlayerState* last = nullptr;
  for (PlayerState& track : list) {
    if (last == nullptr || toward * track.position.x > toward * last->position.x) last = &track;
  }
  if (last == nullptr || last->unum != 0) return;
  const bool in_area =
      toward * last->position.x > soccer::kHalfLength - soccer::kPenaltyAreaLength &&
      std::fabs(last->position.y) < 0.5 * soccer::kPenaltyAreaWidth;
  if (!in_area) return;
  last->unum = unum;
  last->goalie = true;
  forget_lost(world, side, unum);
}

/// When all numbers of a team but one are known, and one player without number is in sight, it is
/// that one.
void number_the_last(WorldModel& world, Side side) {
  PlayerList& list = list_of(world, side);
  constexpr int kRecent = 15;
  std::array<bool, soccer::kPlayersPerTeam + 1> taken{};
  if (side == world.our_side) taken[static_cast<std::size_t>(world.unum)] = true;
  PlayerState* nameless = nullptr;
  for (PlayerState& track : list) {
    if (track.unum != 0) {
      if (track.pos_count > kRecent) return;
      taken[static_cast<std::size_t>(track.unum)] = true;
    } else if (nameless != nullptr || !track.claimed) {
      return;
    } else {
      nameless = &track;
    }
  }
  if (nameless == nullptr) return;
  int missing = 0;
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    if (taken[static_cast<std::size_t>(unum)]) continue;
    if (missing != 0) return;
    missing = unum;
  }
  if (missing == 0) return;
  nameless->unum = missing;
  forget_lost(world, side, missing);
}

void match_anonymous(WorldModel& world, const Viewpoint& view, const SightingList& sightings,
                     TakeSighting take) {
  for (const PlayerSighting& sighting : sightings) {
    if (sighting.side != Side::kNeutral) continue;
    PlayerState* best = nullptr;
    double least = kSameGate;
    for (PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
      PlayerState* track = nearest_unclaimed(*list, sighting, least);
      if (track == nullptr) continue;
      least = squared_misfit(*track, sighting);
      best = track;
    }
    if (best == nullptr) best = new_player(world, Side::kNeutral, 0);
    take(*best, view, sighting);
  }
}

}  // namespace

void match(WorldModel& world, const Viewpoint& view, const SightingList& sightings,
           TakeSighting take) {
  match_numbers(world, view, sightings, take);
  match_team(world, view, sightings, Side::kLeft, take);
  match_team(world, view, sightings, Side::kRight, take);
  match_anonymous(world, view, sightings, take);
  number_the_goalie(world, Side::kLeft);
  number_the_goalie(world, Side::kRight);
  number_the_last(world, Side::kLeft);
  number_the_last(world, Side::kRight);
}

}  // namespace cls::proxy
