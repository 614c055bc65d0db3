// Tracking of the agent, the ball and the other players: prediction, update by see messages.
#pragma once

#include "player/tracking/observed_object.h"
#include "player/world/world_model.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"

namespace cls::player {

/// Dead reckoning: updates pose, velocity and neck for the step before this sense_body, from the
/// own commands confirmed by the counters, and the sensed speed and its direction. `world.self`
/// must still hold the previous counters. `cycles` is 1 unless sense_body messages were lost;
/// motion in lost cycles is unknown.
void advance_self(WorldModel& world, const soccer::SenseBody& sense, int cycles);

/// Corrects the pose by all landmarks and lines of a see message. Reinitializes it without a pose,
/// or when the landmarks contradict it (the referee moved the agent). False when the message has
/// too few landmarks.
bool localize(WorldModel& world, const soccer::See& see);

/// Predicts the ball `cycles` (at least 1) ahead. `world.self` is still the state before the step
/// in which own kicks and tackles were executed.
void advance_ball(WorldModel& world, const soccer::SenseBody& sense, int cycles);

/// Updates the ball by a see message that shows it or not. The own pose must be current.
void observe_ball(WorldModel& world, const soccer::See& see);

/// Sets the ball to a position at rest, as placed by the referee.
void place_ball(WorldModel& world, Vec2 position, double deviation);

/// Copies the tracker's estimate into BallState.
void publish_ball(WorldModel& world);

/// Predicts all tracks `cycles` ahead; moves those with an expired position to `lost`.
void advance_players(WorldModel& world, int cycles);

/// Matches the players of a see message with tracks, updates and creates tracks, and counts ghosts:
/// tracks that should have been visible. The own pose must be current.
void observe_players(WorldModel& world, const soccer::See& see);

/// Drops all positions, because players are being placed for a kick-off; the numbers are retained
/// as lost players.
void forget_positions(WorldModel& world);

/// Player list of a side (neutral: unknown team).
PlayerList& list_of(WorldModel& world, Side side);

/// The track with this number of a side; null if none.
PlayerState* find_number(PlayerList& list, Side side, int unum);

/// Removes a track of the list.
void erase_track(PlayerList& list, const PlayerState* track);

/// Appends a track with a new id; a full list drops the track observed longest ago.
PlayerState* new_player(WorldModel& world, Side side, int unum);

/// Removes a lost player that was found again.
void forget_lost(WorldModel& world, Side side, int unum);

/// Sorts numbered tracks by number, then the others by id.
void sort_players(PlayerList& list);

/// Conversion between a track and its Gaussian estimate.
ObjectEstimate estimate_of(const PlayerState& player);
void set_estimate(PlayerState& player, const ObjectEstimate& estimate);

}  // namespace cls::player
