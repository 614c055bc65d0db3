// Predicts, updates and drops player tracks.
#include "player/tracking/tracking.h"

#include <algorithm>
#include <utility>

#include "base/index.h"

#include "player/tracking/player_matching.h"
#include "player/world/view_cone.h"

namespace cls::player {
namespace {

using soccer::Observation;
using soccer::ObservedDetail;
using soccer::ObservedKind;

// Motion model fitted to recorded matches: players keep running, so a step regains
// kRunOn of the velocity lost to decay, with this noise per axis and step.
constexpr double kRunOn = 0.8;
constexpr double kStepDeviation = 0.14;
// The variance of players without any observed velocity.
constexpr double kUnknownVelocityVariance = 0.04;
constexpr double kLostDeviation = 12.0;  ///< of a lost player

void step(PlayerState& player, double decay) {
  ObjectEstimate b = estimate_of(player);
  const double carry = 1.0 + kRunOn * (1.0 / decay - 1.0);  // step length per velocity
  advance_estimate(b, carry, carry * decay, square(kStepDeviation), decay);
  set_estimate(player, b);
}

void age(PlayerState& player, int cycles) {
  for (int* count :
       {&player.unum_count, &player.pos_count, &player.seen_pos_count, &player.heard_pos_count,
        &player.vel_count, &player.seen_vel_count, &player.body_count, &player.face_count,
        &player.point_count, &player.kick_count, &player.tackle_count}) {
    *count = std::min(kNever, *count + cycles);
  }
  player.matched = false;
}

/// Stores a numbered player as lost: known to play, position unknown.
void move_to_lost(WorldModel& world, const PlayerState& player) {
  if (player.unum == 0) return;

  PlayerState lost = player;
  lost.matched = false;
  lost.covariance = {};
  lost.covariance[0] = lost.covariance[5] = square(kLostDeviation);
  lost.velocity = {};
  lost.covariance[10] = lost.covariance[15] = kUnknownVelocityVariance;

  world.lost.push_back(lost);
}

template <typename Predicate>
void drop_tracks_if(WorldModel& world, PlayerList& list, Predicate gone) {
  for (std::size_t i = list.size(); i-- > 0;) {
    if (!gone(list[i])) continue;
    move_to_lost(world, list[i]);
    list.erase(i);
  }
}

void update_track(PlayerState& track, const Viewpoint& view, const PlayerObservation& observation) {
  const Observation& seen = *observation.seen;
  ObjectEstimate estimate = estimate_of(track);

  constexpr double kMaxMahalanobis = 25.0;
  const bool known = track.pos_count < kNever;
  if (known && mahalanobis_distance(estimate, observation.observed).squared < kMaxMahalanobis) {
    update_estimate(estimate, view, observation.observed, seen);
  } else {
    estimate = initial_estimate(view, observation.observed, seen, {}, kUnknownVelocityVariance);
    track.vel_count = track.seen_vel_count = kNever;
  }

  set_estimate(track, estimate);
  track.matched = true;
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
    track.body = AngleDeg(view.face + seen.body);
    track.face = AngleDeg(view.face + seen.head);
    track.body_count = track.face_count = 0;
  }
  if (seen.pointing) {
    track.point_direction = AngleDeg(view.face + seen.point_direction);
    track.point_count = 0;
  }

  if (seen.mark == soccer::ActionMark::kKicked) track.kick_count = 0;
  if (seen.mark == soccer::ActionMark::kTackling) track.tackle_count = 0;
}

PlayerObservationList player_observations(const WorldModel& world, const soccer::See& see,
                                          const Viewpoint& view) {
  PlayerObservationList out;

  for (const Observation& seen : see.objects) {
    const bool player =
        seen.kind == ObservedKind::kPlayer || seen.kind == ObservedKind::kClosePlayer;
    if (!player || seen.detail == ObservedDetail::kDirection) continue;

    PlayerObservation observation;
    observation.seen = &seen;
    observation.observed = observed_position(view, world.parameters->object_distances, seen);
    if (!seen.team.empty()) {
      observation.side = seen.team == world.our_team_name ? world.our_side : world.their_side();
    }

    out.push_back(observation);
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

/// If a numbered ghost has exactly one other track nearby, unnumbered and matched, that track is
/// the ghost after an unpredicted move: transfers the number.
void renumber_ghosts(PlayerList& list) {
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
      if (other.unum == 0 && other.matched) found = &other;
    }

    if (found == nullptr || near > 1) continue;
    found->unum = ghost.unum;
    found->unum_count = ghost.unum_count;
    found->goalie = ghost.goalie;
    list.erase(i);
  }
}

}  // namespace

ObjectEstimate estimate_of(const PlayerState& player) {
  return {{player.position.x, player.position.y, player.velocity.x, player.velocity.y},
          player.covariance};
}

void set_estimate(PlayerState& player, const ObjectEstimate& estimate) {
  player.position = {estimate.mean[0], estimate.mean[1]};
  player.velocity = {estimate.mean[2], estimate.mean[3]};
  player.covariance = estimate.covariance;
}

PlayerList& list_of(WorldModel& world, Side side) {
  return side == Side::kNeutral   ? world.unknowns
         : side == world.our_side ? world.teammates
                                  : world.opponents;
}

PlayerState* find_number(PlayerList& list, Side side, int unum) {
  PlayerState* found = std::ranges::find_if(
      list, [&](const PlayerState& p) { return p.unum == unum && p.side == side; });
  return found == list.end() ? nullptr : found;
}

void erase_track(PlayerList& list, const PlayerState* track) {
  list.erase(base::index(track - list.begin()));
}

PlayerState* new_player(WorldModel& world, Side side, int unum) {
  PlayerState track;
  track.id = world.next_player_id++;
  track.side = side;
  track.unum = unum;

  PlayerList& list = list_of(world, side);
  if (!list.push_back(track)) {
    // Full: replace the track observed longest ago.
    erase_track(list, std::ranges::max_element(list, {}, &PlayerState::pos_count));
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
  const auto rank = [](const PlayerState& player) {
    return std::pair(player.unum == 0 ? soccer::kPlayersPerTeam + player.id : player.unum,
                     player.id);
  };
  if (!std::ranges::is_sorted(list, {}, rank)) std::ranges::sort(list, {}, rank);
}

void advance_players(WorldModel& world, int cycles) {
  for (PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
    for (PlayerState& player : *list) {
      age(player, cycles);
      for (int i = 0; i < cycles; ++i) step(player, world.type_of(player).player_decay);
    }
    drop_tracks_if(world, *list, [](const PlayerState& p) { return !p.position_valid(); });
  }

  for (PlayerState& player : world.lost) age(player, cycles);
}

void forget_positions(WorldModel& world) {
  for (PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
    drop_tracks_if(world, *list, [](const PlayerState&) { return true; });
  }
}

void observe_players(WorldModel& world, const soccer::See& see) {
  learn_team_name(world, see);
  for (PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns, &world.lost}) {
    for (PlayerState& player : *list) player.matched = false;
  }

  const Viewpoint view = viewpoint(world);
  const PlayerObservationList observations = player_observations(world, see, view);
  match_players(world, view, observations, update_track);

  constexpr int kMaxGhostCount = 2;
  const VisibleArea visible(world);
  for (PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
    for (PlayerState& player : *list) {
      if (player.matched) continue;
      if (visible.must_show(player.position, player.position_deviation())) ++player.ghost_count;
    }

    renumber_ghosts(*list);
    drop_tracks_if(world, *list,
                   [](const PlayerState& p) { return p.ghost_count >= kMaxGhostCount; });
    sort_players(*list);
  }
}

}  // namespace cls::player
