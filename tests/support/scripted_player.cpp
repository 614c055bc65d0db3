// A scripted player.
#include "tests/support/scripted_player.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text/number_text.h"
#include "soccer/messages/server_reply.h"
#include "soccer/pitch.h"

namespace cls::tests {
namespace {

void append_command(std::string_view name, double first, std::string& out) {
  out += '(';
  out += name;
  out += ' ';
  base::append_shortest(first, out);
  out += ')';
}

void append_command(std::string_view name, double first, double second, std::string& out) {
  out += '(';
  out += name;
  out += ' ';
  base::append_shortest(first, out);
  out += ' ';
  base::append_shortest(second, out);
  out += ')';
}

}  // namespace

ScriptedPlayer::ScriptedPlayer(std::unique_ptr<soccer::Channel> channel, std::string team,
                               int version)
    : channel_(std::move(channel)), team_(std::move(team)), version_(version) {}

void ScriptedPlayer::join(bool goalie) {
  send("(init " + team_ + " (version " + std::to_string(version_) + ")" +
       (goalie ? " (goalie))" : ")"));
}

bool ScriptedPlayer::act() {
  asked_ = false;
  while (channel_->receive(in_)) read(in_);
  if (asked_) think();
  return asked_;
}

int ScriptedPlayer::count(std::string_view beginning) const {
  return static_cast<int>(std::count_if(
      messages_.begin(), messages_.end(),
      [beginning](const std::string& message) { return message.starts_with(beginning); }));
}

void ScriptedPlayer::read(std::string_view message) {
  if (keep_) messages_.emplace_back(message);
  if (message == "(think)") {
    asked_ = true;
  } else if (message.starts_with("(see ")) {
    seen_ = soccer::parse(message, see_).ok();
  } else if (message.starts_with("(hear ")) {
    if (message.ends_with("before_kick_off)")) waiting_ = true;
    if (message.ends_with("referee time_over)")) time_over_ = true;
    if (message.find(" kick_off_") != std::string_view::npos) waiting_ = false;
  } else if (message.starts_with("(init ")) {
    soccer::ServerReply reply;
    if (!soccer::parse(message, reply)) return;
    if (const auto* init = std::get_if<soccer::PlayerInitReply>(&reply)) {
      unum_ = init->unum;
      is_left_ = init->side == soccer::Side::kLeft;
    }
  }
}

void ScriptedPlayer::think() {
  out_.clear();
  ++cycles_;
  if (waiting_) {
    append_command("move", place_.x, place_.y, out_);
  } else {
    chase();
  }
  append_command("turn_neck", cycles_ % 3 == 0 ? 20 : -10, out_);
  if (cycles_ % 10 == unum_ % 10) out_ += "(say \"here I am\")";
  if (cycles_ % 50 == 0) out_ += cycles_ % 100 == 0 ? "(change_view narrow)" : "(change_view wide)";
  out_ += "(done)";
  seen_ = false;
  send(out_);
}

// Runs to the ball and kicks it towards the opponents' goal or, if not seen, ahead.
void ScriptedPlayer::chase() {
  constexpr double kKickable = 0.9;
  constexpr double kAhead = 20.0;
  const int goal = *soccer::landmark_index(is_left_ ? "g r" : "g l");
  const soccer::Observation* ball = nullptr;
  double goal_direction = 0.0;

  if (seen_) {
    for (const soccer::Observation& object : see_.objects) {
      if (object.kind == soccer::ObservedKind::kBall ||
          object.kind == soccer::ObservedKind::kCloseBall) {
        ball = &object;
      }
      if (object.kind == soccer::ObservedKind::kLandmark && object.index == goal) {
        goal_direction = object.direction;
      }
    }
  }

  if (ball == nullptr) {
    append_command(seen_ ? "turn" : "dash", seen_ ? 70 : 40, out_);
  } else if (ball->distance < kKickable) {
    append_command("kick", 60, goal_direction, out_);
  } else if (std::abs(ball->direction) > kAhead) {
    append_command("turn", ball->direction, out_);
  } else {
    append_command("dash", 80, ball->direction, out_);
  }
}

std::vector<soccer::Vec2> formation(bool attacking) {
  return {{-50, 0},
          {-35, -15},
          {-35, -5},
          {-35, 5},
          {-35, 15},
          {-20, -10},
          {-20, 0},
          {-20, 10},
          {-5, -15},
          {-5, 15},
          attacking ? soccer::Vec2{-0.5, 0} : soccer::Vec2{-12, 0}};
}

}  // namespace cls::tests
