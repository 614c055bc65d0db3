// Converts recorded frames to worlds and overrides, and compares worlds with frames.
#include "simulator/replay/frame_replay.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.h"
#include "base/text/number_text.h"
#include "simulator/referee/referee.h"
#include "soccer/protocol/protocol_version.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

constexpr std::uint32_t kTackles = state::kTackle | state::kTackleFault;

soccer::ViewWidth width_of(double degrees, double visible_angle) {
  if (degrees < visible_angle * 0.8) return soccer::ViewWidth::kNarrow;
  return degrees < visible_angle * 1.8 ? soccer::ViewWidth::kNormal : soccer::ViewWidth::kWide;
}

void restore_player(const World& world, Player& player, const gamelog::PlayerFrame& frame) {
  const bool has_capacity = frame.capacity >= 0.0 || world.params().stamina_capacity < 0.0;
  const double capacity = has_capacity ? frame.capacity : player.stamina.capacity;

  player.enabled = (frame.state & state::kStand) != 0;
  player.joined = player.joined || player.enabled;
  player.goalie = (frame.state & state::kGoalie) != 0;

  player.type = frame.type;
  player.position = frame.position;
  player.velocity = frame.velocity;
  player.acceleration = {};
  player.body = player.pending_body = math::to_radians(frame.body);
  player.neck = player.pending_neck = math::to_radians(frame.neck);
  player.stamina = {frame.stamina, frame.effort, frame.recovery, capacity};
  player.counters = frame.counts;

  player.view.width = width_of(frame.view_width, world.params().visible_angle);
  player.view.quality = frame.high_quality ? soccer::ViewQuality::kHigh : soccer::ViewQuality::kLow;
  player.view.focus_distance = frame.focus_distance;
  player.view.focus_direction = math::to_radians(frame.focus_direction);

  player.attention = frame.attention_side == Side::kNeutral
                         ? kNoPlayer
                         : soccer::slot_of(frame.attention_side, frame.attention_unum);
}

double largest(Vec2 difference) {
  return std::max(std::fabs(difference.x), std::fabs(difference.y));
}

double angle_between(double radians, double degrees) {
  return std::fabs(math::normalize_degrees(math::to_degrees(radians) - degrees));
}

}  // namespace

void restore(World& world, const gamelog::Frame& frame) {
  world.ball = {frame.ball_position, frame.ball_velocity, {}};
  for (std::size_t i = 0; i < world.players.size(); ++i) {
    restore_player(world, world.players[i], frame.players[i]);
  }
}

World world_at_kick_off(std::shared_ptr<const Rules> rules, const gamelog::Frame& frame) {
  World world = make_world(std::move(rules), 0);
  for (Team& team : world.teams) team.connected = true;
  world.clock = {frame.time, 0};
  restore(world, frame);
  for (std::size_t i = 0; i < world.players.size(); ++i) {
    Player& player = world.players[i];
    player.client_version = soccer::kMaxProtocolVersion;
    player.view.synchronous = true;
    player.substituted = player.type != 0;
    player.state = frame.players[i].state;
    ++world.teams[player.side == Side::kRight ? 1 : 0].used[base::index(player.type)];
  }

  Events ignored;
  change_mode(world, frame.mode, ignored);
  // The step after the kick-off has already counted once.
  --world.referee.free_kick.timer;
  return world;
}

ReplayOverrides recorded_outcomes(const gamelog::Frame& after) {
  ReplayOverrides overrides;
  for (std::size_t i = 0; i < after.players.size(); ++i) {
    const std::uint32_t bits = after.players[i].state;
    if ((bits & kTackles) != 0) overrides.tackle.recorded[i] = (bits & state::kTackleFault) == 0;
    if ((bits & state::kCatch) != 0)
      overrides.catch_ball.recorded[i] = (bits & state::kCatchFault) == 0;
    overrides.foul.recorded[i] = FoulCall::kNone;
    overrides.placement.recorded[i] = after.players[i].position;
    overrides.body[i] = math::to_radians(after.players[i].body);
  }

  return overrides;
}

void override_arrivals(ReplayOverrides& overrides, const World& world,
                       const gamelog::Frame& after) {
  // The factor of colliding objects (docs/spec/simulation-model.md 3.4).
  constexpr double kVelocityFactor = -0.1;
  constexpr double kSamePosition = 5e-4;  // exceeds the rounding error

  const auto before_contact = [](Vec2 from, Vec2 velocity, double decay) -> std::optional<Vec2> {
    if (decay == 0.0) return std::nullopt;
    return from + velocity / (kVelocityFactor * decay);
  };

  // Arrival by the velocity. The printed position is more exact unless the object was moved
  // afterwards.
  const auto after_motion = [](Vec2 from, Vec2 to, Vec2 velocity, double decay) {
    if (decay == 0.0) return to;
    const Vec2 arrival = from + velocity / decay;
    return distance(arrival, to) <= kSamePosition ? to : arrival;
  };

  // A ball in the goal is stopped in place.
  const bool is_stopped = after.ball_velocity.is_zero();
  overrides.ball.arrival = is_stopped
                               ? after.ball_position
                               : after_motion(world.ball.position, after.ball_position,
                                              after.ball_velocity, world.params().ball_decay);

  for (std::size_t i = 0; i < after.players.size(); ++i) {
    const gamelog::PlayerFrame& shown = after.players[i];
    const Player& player = world.players[i];
    overrides.players[i].arrival = after_motion(player.position, shown.position, shown.velocity,
                                                world.type_of(player).player_decay);

    if ((shown.state & (state::kBallCollide | state::kPlayerCollide)) != 0) {
      overrides.players[i].arrival =
          before_contact(player.position, shown.velocity, world.type_of(player).player_decay);
    }

    if ((shown.state & state::kBallCollide) != 0) {
      overrides.ball.arrival =
          before_contact(world.ball.position, after.ball_velocity, world.params().ball_decay);
    }
  }
}

void override_fouls(ReplayOverrides& overrides, const std::vector<std::string>& calls,
                    const std::vector<Slot>& called_after) {
  const auto charge = [&](Side side, Slot last) {
    const bool is_known = last != kNoPlayer && soccer::side_of_slot(last) == side &&
                          overrides.tackle.recorded[base::index(last)].value_or(false);
    for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
      const Slot slot = soccer::slot_of(side, unum);
      if (!is_known || slot == last) {
        overrides.foul.recorded[base::index(slot)] = FoulCall::kCharge;
      }
    }
  };

  const auto card = [&](const std::string& message, std::string_view prefix, FoulCall call) {
    if (!message.starts_with(prefix)) return;

    const Side side = message[prefix.size()] == 'l' ? Side::kLeft : Side::kRight;
    const int unum = base::parse_int(message.substr(prefix.size() + 2)).value_or(0);
    if (!soccer::is_unum(unum)) return;
    overrides.foul.recorded[base::index(soccer::slot_of(side, unum))] = call;
  };

  for (std::size_t i = 0; i < calls.size(); ++i) {
    const Slot last = i < called_after.size() ? called_after[i] : kNoPlayer;
    if (calls[i] == "foul_charge_l") charge(Side::kLeft, last);
    if (calls[i] == "foul_charge_r") charge(Side::kRight, last);
  }

  for (const std::string& message : calls) {
    card(message, "yellow_card_", FoulCall::kYellow);
    card(message, "red_card_", FoulCall::kRed);
  }
}

void override_shoot_out(ReplayOverrides& overrides, const std::vector<std::string>& calls) {
  const auto side_of_first = [&](std::string_view prefix) -> std::optional<Side> {
    const auto call = std::ranges::find_if(
        calls, [&](const std::string& message) { return message.starts_with(prefix); });
    if (call == calls.end()) return std::nullopt;
    return call->back() == 'l' ? Side::kLeft : Side::kRight;
  };

  overrides.shoot_out_goal = side_of_first("penalty_onfield_");
  overrides.first_penalty_taker = side_of_first("penalty_setup_");
}

Deviation ball_deviation(const World& world, const gamelog::Frame& frame) {
  return {.position = largest(world.ball.position - frame.ball_position),
          .velocity = largest(world.ball.velocity - frame.ball_velocity)};
}

Deviation player_deviation(const World& world, const gamelog::Frame& frame, Slot slot) {
  const Player& player = world.player(slot);
  const gamelog::PlayerFrame& recorded = frame.players[base::index(slot)];
  return {.position = largest(player.position - recorded.position),
          .velocity = largest(player.velocity - recorded.velocity),
          .body = angle_between(player.body, recorded.body),
          .neck = angle_between(player.neck, recorded.neck),
          .stamina = std::fabs(player.stamina.value - recorded.stamina),
          .effort = std::max(std::fabs(player.stamina.effort - recorded.effort),
                             std::fabs(player.stamina.recovery - recorded.recovery)),
          .capacity = std::fabs(player.stamina.capacity - recorded.capacity),
          .same_counters = player.counters == recorded.counts};
}

}  // namespace cls::simulator
