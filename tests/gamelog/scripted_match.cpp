// Simulates a rolling ball and standing players.
#include "tests/gamelog/scripted_match.h"

namespace cls::tests {

ScriptedMatch::ScriptedMatch() {
  next_.time = 1;
  next_.mode = soccer::PlayMode::kPlayOn;
  next_.teams[0].name = "A";
  next_.teams[1].name = "B";

  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    const int unum = soccer::unum_of_slot(slot);
    const double side = soccer::sign(soccer::side_of_slot(slot));
    gamelog::PlayerFrame& player_frame = player(slot);
    player_frame.state =
        unum == 1 ? gamelog::kStateEnabled | gamelog::kStateGoalie : gamelog::kStateEnabled;
    player_frame.position = {-40.0 * side, 3.0 * (unum - 6)};
    if (unum == 1) player_frame.position = {-50.0 * side, 0.0};
    player_frame.stamina = 8000;
    player_frame.effort = 1;
    player_frame.recovery = 1;
    player_frame.capacity = 130600;
    player_frame.view_width = 120;
  }

  append();
}

void ScriptedMatch::append() {
  builder_.append_frame(next_);
  for (gamelog::PlayerFrame& player_frame : next_.players) {
    player_frame.state &=
        ~(gamelog::kStateKick | gamelog::kStateTackle | gamelog::kStateTackleFailed |
          gamelog::kStateCatch | gamelog::kStateCatchFailed);
  }
}

void ScriptedMatch::step() {
  if (mode_class(next_.mode) == soccer::ModeClass::kRunning) ++next_.time;
  next_.ball_position += next_.ball_velocity;
  next_.ball_velocity *= record_.server.ball_decay;
  append();
}

void ScriptedMatch::steps(int count) {
  for (int i = 0; i < count; ++i) step();
}

void ScriptedMatch::kick(int slot, soccer::Vec2 launch) {
  ++player(slot).counts.kick;
  player(slot).state |= gamelog::kStateKick;
  next_.ball_velocity = launch;
  step();
}

void ScriptedMatch::tackle(int slot, soccer::Vec2 launch) {
  ++player(slot).counts.tackle;
  player(slot).state |= gamelog::kStateTackle;
  next_.ball_velocity = launch;
  step();
}

void ScriptedMatch::place_ball(soccer::Vec2 position) {
  next_.ball_position = position;
  next_.ball_velocity = {0, 0};
}

void ScriptedMatch::score(int left_score, int right_score) {
  next_.teams[0].score = left_score;
  next_.teams[1].score = right_score;
}

}  // namespace cls::tests
