// Motion of tracks, what a sighting tells about one, and when one is given up.
#include "proxy/tracking/player_tracking.h"

#include <algorithm>
#include <cmath>

#include "proxy/tracking/player_matching.h"
#include "proxy/tracking/visibility.h"
#include "soccer/math.h"

namespace cls::proxy {
namespace {

using soccer::Observation;
using soccer::ObservedDetail;
using soccer::ObservedKind;
using soccer::Side;
using soccer::Vec2;

// How players move, from recorded matches: they go on running, so that the next step is more than
// the decayed velocity alone by this share of what it lost, with this deviation per axis and step.
constexpr double kRunOn = 0.8;
constexpr double kStepDeviation = 0.14;
// A player of whom only the place was ever seen.
constexpr double kUnknownVelocityVariance = 0.04;
constexpr double kLostDeviation = 12.0;  ///< of somebody whose place is not known

double square(double x) { return x * x; }

void step(PlayerState& player, double decay) {
  MovingBelief b = belief_of(player);
  const double carry = 1.0 + kRunOn * (1.0 / decay - 1.0);  // step length per velocity
  const double keep = carry * decay;                        // velocity after per velocity before
  for (std::size_t axis = 0; axis < 2; ++axis) {
    b.mean[axis] += carry * b.mean[axis + 2];
    b.mean[axis + 2] *= keep;
  }
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      b.at(axis, c) += carry * b.at(axis + 2, c);
      b.at(axis + 2, c) *= keep;
    }
  }
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      b.at(r, axis) += carry * b.at(r, axis + 2);
      b.at(r, axis + 2) *= keep;
    }
  }
  const double noise = square(kStepDeviation);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    b.at(axis, axis) += noise;
    b.at(axis, axis + 2) += noise * decay;
    b.at(axis + 2, axis) += noise * decay;
    b.at(axis + 2, axis + 2) += noise * decay * decay;
  }
  set_belief(player, b);
}

void age(PlayerState& player, int cycles) {
  for (int* count :
       {&player.unum_count, &player.pos_count, &player.seen_pos_count, &player.heard_pos_count,
        &player.vel_count, &player.seen_vel_count, &player.body_count, &player.face_count,
        &player.point_count, &player.kick_count, &player.tackle_count}) {
    *count = std::min(kNever, *count + cycles);
  }
  player.claimed = false;
}

/// Remembers that somebody with this number plays, though not where.
void lose(WorldModel& world, const PlayerState& player) {
  if (player.unum == 0) return;
  PlayerState lost = player;
  lost.claimed = false;
  lost.covariance = {};
  lost.covariance[0] = lost.covariance[5] = square(kLostDeviation);
  lost.velocity = {};
  lost.covariance[10] = lost.covariance[15] = kUnknownVelocityVariance;
  world.lost.push_back(lost);
}

template <typename Predicate>
void give_up_if(WorldModel& world, PlayerList& list, Predicate gone) {
  for (std::size_t i = list.size(); i-- > 0;) {
    if (!gone(list[i])) continue;
    lose(world, list[i]);
    list.erase(i);
  }
}

void take_sighting(PlayerState& track, const Viewpoint& view, const PlayerSighting& sighting) {
  const Observation& seen = *sighting.seen;
  MovingBelief belief = belief_of(track);
  constexpr double kElsewhere = 25.0;
  const bool known = track.pos_count < kNever;
  if (known && misfit(belief, sighting.sight).squared < kElsewhere) {
    observe(belief, view, sighting.sight, seen);
  } else {
    belief = first_belief(view, sighting.sight, seen, {}, kUnknownVelocityVariance);
    track.vel_count = track.seen_vel_count = kNever;
  }
  set_belief(track, belief);
  track.claimed = true;
  track.ghost_count = 0;
  track.seen_position = track.position;
  track.pos_count = track.seen_pos_count = 0;
  if (seen.unum != 0) {
    track.unum = seen.unum;
    track.unum_count = 0;
    track.goalie = seen.goalie;
  }
  if (seen.detail >= ObservedDetail::kMotion) {
    track.seen_velocity = track.velocity;
    track.vel_count = track.seen_vel_count = 0;
  }
  if (seen.detail == ObservedDetail::kPose) {
    track.body = soccer::AngleDeg(view.face + seen.body);
    track.face = soccer::AngleDeg(view.face + seen.head);
    track.body_count = track.face_count = 0;
  }
  if (seen.pointing) {
    track.point_direction = soccer::AngleDeg(view.face + seen.point_direction);
    track.point_count = 0;
  }
  if (seen.mark == soccer::ActionMark::kKicked) track.kick_count = 0;
  if (seen.mark == soccer::ActionMark::kTackling) track.tackle_count = 0;
}

SightingList sightings_of(const WorldModel& world, const soccer::See& see, const Viewpoint& view) {
  SightingList out;
  for (const Observation& seen : see.objects) {
    const bool player =
        seen.kind == ObservedKind::kPlayer || seen.kind == ObservedKind::kClosePlayer;
    if (!player || seen.detail == ObservedDetail::kDirection) continue;
    PlayerSighting sighting;
    sighting.seen = &seen;
    sighting.sight = sight_of(view, world.parameters->object_distances, seen);
    if (!seen.team.empty()) {
      sighting.side = seen.team == world.our_team_name ? world.our_side : world.their_side();
    }
    out.push_back(sighting);
  }
  return out;
}

void learn_team_name(WorldModel& world, const soccer::See& see) {
  if (!world.their_team_name.empty()) return;
  for (const Observation& seen : see.objects) {
    if (!seen.team.empty() && !(seen.team == world.our_team_name)) {
      world.their_team_name = seen.team;
      return;
    }
  }
}

/// A player who is not where he was believed, and somebody without number a little aside who was
/// not known before: that is him, after a step nobody expected.
void follow_ghosts(PlayerList& list) {
  constexpr double kAside = 4.0;
  for (std::size_t i = list.size(); i-- > 0;) {
    const PlayerState& ghost = list[i];
    if (ghost.unum == 0 || ghost.ghost_count == 0) continue;
    PlayerState* found = nullptr;
    int near = 0;
    for (PlayerState& other : list) {
      if (other.id == ghost.id || soccer::distance(other.position, ghost.position) > kAside)
        continue;
      ++near;
      if (other.unum == 0 && other.claimed) found = &other;
    }
    if (found == nullptr || near > 1) continue;
    found->unum = ghost.unum;
    found->unum_count = ghost.unum_count;
    found->goalie = ghost.goalie;
    list.erase(i);
  }
}

}  // namespace

MovingBelief belief_of(const PlayerState& player) {
  return {{player.position.x, player.position.y, player.velocity.x, player.velocity.y},
          player.covariance};
}

void set_belief(PlayerState& player, const MovingBelief& belief) {
  player.position = {belief.mean[0], belief.mean[1]};
  player.velocity = {belief.mean[2], belief.mean[3]};
  player.covariance = belief.covariance;
}

PlayerList& list_of(WorldModel& world, Side side) {
  return side == Side::kNeutral   ? world.unknowns
         : side == world.our_side ? world.teammates
                                  : world.opponents;
}

PlayerState* new_player(WorldModel& world, Side side, int unum) {
  PlayerState track;
  track.id = world.next_player_id++;
  track.side = side;
  track.unum = unum;
  PlayerList& list = list_of(world, side);
  if (!list.push_back(track)) {
    // Full of tracks: the one without news for the longest time makes room.
    std::size_t oldest = 0;
    for (std::size_t i = 1; i < list.size(); ++i) {
      if (list[i].pos_count > list[oldest].pos_count) oldest = i;
    }
    list.erase(oldest);
    list.push_back(track);
  }
  return &list.back();
}

void forget_lost(WorldModel& world, Side side, int unum) {
  for (std::size_t i = world.lost.size(); i-- > 0;) {
    if (world.lost[i].side == side && world.lost[i].unum == unum) world.lost.erase(i);
  }
}

void sort_players(PlayerList& list) {
  const auto before = [](const PlayerState& a, const PlayerState& b) {
    const int left = a.unum == 0 ? soccer::kPlayersPerTeam + a.id : a.unum;
    const int right = b.unum == 0 ? soccer::kPlayersPerTeam + b.id : b.unum;
    return left != right ? left < right : a.id < b.id;
  };
  if (!std::is_sorted(list.begin(), list.end(), before))
    std::sort(list.begin(), list.end(), before);
}

void advance_players(WorldModel& world, int cycles) {
  for (PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
    for (PlayerState& player : *list) {
      age(player, cycles);
      for (int i = 0; i < cycles; ++i) step(player, world.type_of(player).player_decay);
    }
    give_up_if(world, *list, [](const PlayerState& p) { return !p.position_valid(); });
  }
  for (PlayerState& player : world.lost) age(player, cycles);
}

void forget_places(WorldModel& world) {
  for (PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
    give_up_if(world, *list, [](const PlayerState&) { return true; });
  }
}

void observe_players(WorldModel& world, const soccer::See& see) {
  learn_team_name(world, see);
  for (PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns, &world.lost}) {
    for (PlayerState& player : *list) player.claimed = false;
  }
  const Viewpoint view = viewpoint(world);
  const SightingList sightings = sightings_of(world, see, view);
  match(world, view, sightings, take_sighting);
  constexpr int kTakenForGone = 2;
  for (PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
    for (PlayerState& player : *list) {
      if (player.claimed) continue;
      if (must_be_visible(world, player.position, player.position_deviation())) {
        ++player.ghost_count;
      }
    }
    follow_ghosts(*list);
    give_up_if(world, *list, [](const PlayerState& p) { return p.ghost_count >= kTakenForGone; });
    sort_players(*list);
  }
}

}  // namespace cls::proxy
