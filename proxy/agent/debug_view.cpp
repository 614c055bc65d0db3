// Objects, texts and shapes as lists in parentheses.
#include "proxy/agent/debug_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <span>

#include "base/overloaded.h"
#include "base/text/decimal_text.h"
#include "proxy/actions/debug_lines.h"
#include "proxy/actions/log_member.h"

namespace cls::proxy {
namespace {

using player::PlayerState;
using player::WorldModel;

// Limits of soccerwindow2's parser.
constexpr std::size_t kMaxText = 1023;
constexpr std::size_t kMaxHeard = 255;
constexpr std::size_t kMaxColor = 31;

constexpr int kPositionDecimals = 2;
constexpr int kShapeDecimals = 3;
constexpr int kMaxVelocityAge = 100;
constexpr int kMaxPointAge = 10;

// A quoted text has no quotes, and is one line.
std::string quotable(std::string_view text, std::size_t limit) {
  std::string out(text.substr(0, limit));
  for (char& c : out) {
    if (c == '"') c = '\'';
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return out;
}

void append_number(double value, int decimals, std::string& out) {
  out += ' ';
  out += base::decimal_text(value, decimals);
}

void append_point(soccer::Vec2 point, int decimals, std::string& out) {
  append_number(point.x, decimals, out);
  append_number(point.y, decimals, out);
}

// "(1.25 -0.5)" of a velocity.
void append_velocity(soccer::Vec2 velocity, std::string& out) {
  out += fmt::format("({} {})", base::decimal_text(velocity.x, kShapeDecimals),
                     base::decimal_text(velocity.y, kShapeDecimals));
}

void append_self(const WorldModel& world, std::string& out) {
  const player::SelfState& self = world.self;
  if (!self.position_valid()) return;
  const char side = world.our_side == soccer::Side::kRight ? 'r' : 'l';
  fmt::format_to(std::back_inserter(out), " (s {} {} {}", side, world.unum, self.type_id);
  append_point(self.position, kPositionDecimals, out);
  append_point(self.velocity, kPositionDecimals, out);
  append_number(self.body.degrees(), 1, out);
  append_number(self.neck.degrees(), 1, out);

  fmt::format_to(std::back_inserter(out), " (c \"p{}v{}", self.pos_count, self.vel_count);
  if (self.velocity_valid()) append_velocity(self.velocity, out);
  fmt::format_to(std::back_inserter(out), "f{}", self.body_count);
  if (self.card == soccer::Card::kYellow) out += 'y';
  out += "\"))";
}

void append_ball(const player::BallState& ball, std::string& out) {
  if (!ball.position_valid()) return;
  out += " (b";
  append_point(ball.position, kPositionDecimals, out);
  if (ball.velocity_valid()) append_point(ball.velocity, kPositionDecimals, out);
  fmt::format_to(std::back_inserter(out), " (c \"g{}r{}v{}\"))", ball.pos_count,
                 ball.relative_pos_count, ball.vel_count);
}

// Ages of the estimates, and the cycles until the player reaches the ball.
void append_comment(const PlayerState& player, std::string& out) {
  out += " (c \"";
  if (player.goalie) out += 'G';
  if (player.unum != 0) fmt::format_to(std::back_inserter(out), "u{}", player.unum_count);
  fmt::format_to(std::back_inserter(out), "p{}v{}", player.pos_count, player.vel_count);
  if (player.vel_count <= kMaxVelocityAge) append_velocity(player.velocity, out);
  fmt::format_to(std::back_inserter(out), "f{}", player.face_count);

  if (player.tackling) {
    out += 't';
  } else if (player.kicking) {
    out += 'k';
  }

  fmt::format_to(std::back_inserter(out), ",{}\")", player.ball_reach_steps);
}

// `team` is 't' or 'o'; '\0': unknown.
void append_player(const PlayerState& player, char team, std::string& out) {
  out += " (";
  if (team == '\0' || player.unum == 0) out += 'u';
  if (team != '\0') out += team;

  if (team != '\0' && player.unum != 0) {
    fmt::format_to(std::back_inserter(out), " {} {}", player.unum, player.type_id);
  }

  append_point(player.position, kPositionDecimals, out);
  if (player.body_count < player::kPlayerFaceAgeLimit) {
    fmt::format_to(std::back_inserter(out), " (bd {})",
                   base::decimal_text(player.body.degrees(), 0));
  }

  if (player.point_count < kMaxPointAge) {
    fmt::format_to(std::back_inserter(out), " (pt {})",
                   base::decimal_text(player.point_direction.degrees(), 0));
  }
  append_comment(player, out);
  out += ')';
}

void append_players(const WorldModel& world, std::string& out) {
  for (const PlayerState& player : world.teammates) append_player(player, 't', out);
  for (const PlayerState& player : world.opponents) append_player(player, 'o', out);
  for (const PlayerState& player : world.unknowns) append_player(player, '\0', out);
}

// The text of the say command in a datagram.
std::string_view said(std::string_view sent) {
  constexpr std::string_view kSay = "(say \"";
  const std::size_t at = sent.find(kSay);
  if (at == std::string_view::npos) return {};
  const std::string_view text = sent.substr(at + kSay.size());
  return text.substr(0, text.find('"'));
}

void append_messages(const WorldModel& world, std::string_view sent, std::string& out) {
  if (const std::string_view text = said(sent); !text.empty()) {
    fmt::format_to(std::back_inserter(out), " (say \"{{{}}}\")", quotable(text, kMaxHeard));
  }
  std::string heard;
  for (const player::HeardMessage& message : world.heard) {
    if (message.coach || message.unum == 0 || message.text.empty()) continue;
    fmt::format_to(std::back_inserter(heard), "({} \"{}\")", message.unum,
                   quotable(message.text, kMaxHeard));
  }
  if (!heard.empty()) fmt::format_to(std::back_inserter(out), " (hear {})", heard);
}

void append_texts(const protos::PlayerActions& reply, std::uint32_t levels, std::string& out) {
  std::string all;
  for (const auto& action : reply.actions()) {
    if (action.has_debug_client()) {
      all += action.debug_client().message() + '|';
    } else if (action.has_log() && is_logged(action.log(), levels)) {
      if (action.log().has_add_text()) all += action.log().add_text().message() + '|';
      if (action.log().has_add_message()) all += action.log().add_message().message() + '|';
    }
  }
  if (all.empty()) return;
  fmt::format_to(std::back_inserter(out), " (message \"{}\")", quotable(all, kMaxText));
}

// A shape, unless the packet has no room for it.
void append_shape(std::string_view name, std::span<const float> numbers, std::string_view color,
                  std::string& out) {
  if (!std::ranges::all_of(numbers, [](float n) { return std::isfinite(n); })) return;

  std::string shape = fmt::format(" ({}", name);
  for (const float number : numbers) append_number(number, kShapeDecimals, shape);
  if (!color.empty()) {
    std::string quoted = quotable(color, kMaxColor);
    std::ranges::replace(quoted, ')', ' ');
    fmt::format_to(std::back_inserter(shape), " \"{}\"", quoted);
  }
  shape += ')';
  constexpr std::size_t kEnd = 2;  // the closing parenthesis and the NUL
  if (out.size() + shape.size() + kEnd <= kMaxDebugPacket) out += shape;
}

void append_shape(const protos::Log& log, std::string& out) {
  const auto append = [&out](std::string_view name, std::initializer_list<float> numbers,
                             const auto& m) {
    append_shape(name, {numbers.begin(), numbers.size()}, m.color(), out);
  };

  visit_member(
      log, base::Overloaded{
               [&](const protos::AddLine& m) {
                 append("line", {m.start().x(), m.start().y(), m.end().x(), m.end().y()}, m);
               },
               [&](const protos::AddTriangle& m) {
                 append("tri",
                        {m.point1().x(), m.point1().y(), m.point2().x(), m.point2().y(),
                         m.point3().x(), m.point3().y()},
                        m);
               },
               [&](const protos::AddRectangle& m) {
                 append("rect", {m.left(), m.top(), m.left() + m.length(), m.top() + m.width()}, m);
               },
               [&](const protos::AddCircle& m) {
                 append("circle", {m.center().x(), m.center().y(), m.radius()}, m);
               },
               [](const auto&) {},
           });
}

}  // namespace

void format_debug_view(const WorldModel& world, std::string_view sent,
                       const protos::PlayerActions* reply, std::uint32_t levels, std::string& out) {
  const player::GameTime now = world.game.time;
  const bool before_kick_off = world.game.mode == soccer::PlayMode::kBeforeKickOff;
  out = fmt::format("((debug (format-version 5)) (time {},{})", now.cycle,
                    before_kick_off ? 0 : now.stopped);
  append_self(world, out);
  append_ball(world.ball, out);
  append_players(world, out);
  append_messages(world, sent, out);

  if (reply != nullptr) {
    append_texts(*reply, levels, out);
    for (const auto& action : reply->actions()) {
      if (action.has_log() && is_logged(action.log(), levels)) append_shape(action.log(), out);
    }
  }

  out += ')';
}

}  // namespace cls::proxy
