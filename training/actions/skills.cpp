// Action set "skills": skills without parameters, so that a learner chooses what to do and need not
// learn how. Directions are those of the pitch: 0 is towards the opponents' goal line.
#include <array>
#include <cmath>
#include <string>

#include "soccer/math.h"
#include "training/actions/family.h"
#include "training/actions/shared_actions.h"

namespace cls::training {
namespace {

constexpr std::size_t kDirections = 16;

/// Radians of direction `i` of sixteen, in the scene's coordinates.
double direction(std::size_t i) {
  return soccer::math::to_radians(22.5 * static_cast<double>(i) - 180.0);
}

Vec2 ahead(Vec2 from, std::size_t i, double meters) {
  return from + soccer::rotated_radians(Vec2{meters, 0.0}, direction(i));
}

struct Passes {
  static constexpr std::size_t kCount = soccer::kPlayersPerTeam - 1;

  static Seat receiver(const PointOfView& view, std::size_t i) {
    const Seats mates = teammates_of(view);
    return i < mates.size() ? mates[i] : kNoSeat;
  }
  static std::string name(std::size_t i) { return "pass_" + std::to_string(i + 1); }
  static PlayerCommand command(const PointOfView& view, std::size_t i) {
    return pass_to(view.scene, view.self, view.scene.player(receiver(view, i)).position);
  }
  static bool legal(const PointOfView& view, std::size_t i) {
    const Seat seat = receiver(view, i);
    return has_ball(view) && seat != kNoSeat && view.scene.player(seat).seen;
  }
};

struct Kicks {
  static constexpr std::array<double, 2> kSpeeds = {1.2, 2.7};  // m/cycle
  static constexpr std::array<std::string_view, 2> kNames = {"soft", "hard"};
  static constexpr std::size_t kCount = kDirections * kSpeeds.size();

  static std::string name(std::size_t i) {
    return "kick_" + std::string(kNames[i % 2]) + "_" + std::to_string(i / 2);
  }
  static PlayerCommand command(const PointOfView& view, std::size_t i) {
    return kick_to(view.scene, view.self, ahead(view.scene.ball, i / 2, 20.0), kSpeeds[i % 2]);
  }
  static constexpr Condition kLegal = has_ball;
};

struct Dribbles {
  static constexpr std::size_t kCount = kDirections;

  static std::string name(std::size_t i) { return "dribble_" + std::to_string(i); }
  static PlayerCommand command(const PointOfView& view, std::size_t i) {
    return dribble_to(view.scene, view.self, ahead(view.me().position, i, 10.0));
  }
  // Without the ball too: between two kicks it rolls ahead.
  static constexpr Condition kLegal = sees_ball;
};

struct Runs {
  static constexpr std::size_t kCount = kDirections;

  static std::string name(std::size_t i) { return "run_" + std::to_string(i); }
  static PlayerCommand command(const PointOfView& view, std::size_t i) {
    return go_to(view.scene, view.self, ahead(view.me().position, i, 10.0), 0.0);
  }
};

// Goes to the ball and stops it.
PlayerCommand take_ball(const PointOfView& view, const float*) {
  if (has_ball(view)) return kick_to(view.scene, view.self, view.scene.ball, 0.0);
  return intercept(view.scene, view.self);
}

PlayerCommand mark(const PointOfView& view, const float*) {
  const Seat rival = opponent_to_mark(view);
  return go_to(view.scene, view.self, marking_position(view, rival), 0.5);
}
bool can_mark(const PointOfView& view) {
  return view.scene.ball_seen && opponent_to_mark(view) != kNoSeat;
}

PlayerCommand tackle_forward(const PointOfView& view, const float*) {
  return soccer::Tackle{bearing_degrees(view.me(), {1.0, 0.0}), false};
}

}  // namespace

const ActionSet& skill_actions() {
  static const ActionSet set = [] {
    ActionSet all = {
        .name = "skills",
        .summary =
            "shoot, take the ball, support, defend, ten passes, 32 kicks, 16 dribbles and 16 "
            "runs; dribble_I has direction 22.5 I - 180 degrees on the pitch",
        .actions = {{"noop", {}, nothing},
                    {"shoot", {}, shoot_at_goal, has_ball},
                    {"take_ball", {}, take_ball, sees_ball},
                    {"face_ball", {}, face_ball, sees_ball},
                    {"support", {}, support, sees_ball},
                    {"guard", {}, guard, sees_ball},
                    {"mark", {}, mark, can_mark},
                    {"tackle", {}, tackle_forward, tackle_reaches},
                    {"catch", {}, catch_now, catch_reaches}}};
    append_family<Passes>(all.actions);
    append_family<Kicks>(all.actions);
    append_family<Dribbles>(all.actions);
    append_family<Runs>(all.actions);
    return all;
  }();
  return set;
}

}  // namespace cls::training
