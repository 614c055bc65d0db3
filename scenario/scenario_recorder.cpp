// Sets up the initial situation and records the world after every step.
#include "scenario/scenario_recorder.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "simulator/actions/trainer.h"
#include "simulator/referee/referee.h"
#include "simulator/world/roster.h"
#include "soccer/math.h"

namespace cls::scenario {
namespace {

using simulator::Events;
using simulator::World;
using soccer::Side;
using soccer::Vec2;

// Kick-off positions of players that the scenario does not place, by number, for the left side.
constexpr std::array<Vec2, soccer::kPlayersPerTeam> kKickOffPlaces = {{{-50.0, 0.0},
                                                                       {-20.0, -8.0},
                                                                       {-20.0, 8.0},
                                                                       {-18.0, -18.0},
                                                                       {-18.0, 18.0},
                                                                       {-14.0, 0.0},
                                                                       {-11.0, -9.5},
                                                                       {-11.0, 9.5},
                                                                       {-0.8, -15.0},
                                                                       {-0.8, 15.0},
                                                                       {-9.5, 0.0}}};

StartingPlace kick_off_place(Side side, int unum) {
  const Vec2 place = kKickOffPlaces[static_cast<std::size_t>(unum - 1)];
  return {side == Side::kLeft ? place : -place, {}, {}, {}, 0};
}

ObjectFrame frame_of(const simulator::Player& player) {
  ObjectFrame frame;
  frame.position = player.position;
  frame.velocity = player.velocity;
  frame.on_pitch = player.enabled;
  frame.body = soccer::math::to_degrees(player.body);
  frame.stamina = player.stamina.value;
  frame.cards = player.cards;
  return frame;
}

// Agents derive the score from goal messages of the referee; a play mode must follow.
void announce_score(const World& world, Events& events) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const int score = world.team(side).score;
    if (score == 0) continue;
    report(events, world, simulator::RefereeMessage{"goal", side, score});
  }
  if (!events.empty() && world.mode == soccer::PlayMode::kBeforeKickOff) {
    report(events, world, simulator::RefereeMessage{name(world.mode)});
  }
}

}  // namespace

ReplyRecorder::ReplyRecorder(const Scenario& scenario, Side side, const int& step)
    : side_(side), step_(step) {
  for (const Check& check : scenario.checks) {
    if (const auto* actions = std::get_if<ActionCheck>(&check.what)) {
      if (actions->side == side) records_replies_ = true;
    }
    if (const auto* rpc = std::get_if<RpcCheck>(&check.what)) {
      if (rpc->side != side) continue;
      expectations_[rpc->index] = std::make_unique<mock_server::Expectations>(
          std::vector<mock_server::Expectation>{rpc->expectation});
    }
  }
}

void ReplyRecorder::on_call(const proxy::RpcCall& call) {
  for (const auto& [index, expectation] : expectations_) expectation->add(call.rpc, call.request);
  if (!records_replies_ || call.rpc != proto::Rpc::kGetPlayerActions || call.reply == nullptr)
    return;
  replies_.push_back({step_, call.agent, static_cast<const protos::PlayerActions&>(*call.reply)});
}

void ReplyRecorder::move_to(RunRecord& record) {
  std::ranges::sort(replies_, [](const auto& a, const auto& b) {
    return std::tie(a.step, a.unum) < std::tie(b.step, b.unum);
  });
  record.replies[index_of(side_)] = std::move(replies_);
  for (const auto& [index, expectation] : expectations_) {
    if (record.rpc_failures.size() <= index) record.rpc_failures.resize(index + 1);
    record.rpc_failures[index] = expectation->failures();
  }
}

ScenarioRecorder::ScenarioRecorder(const Scenario& scenario, const base::StringSink& text_log,
                                   RunRecord& record)
    : scenario_(scenario),
      text_log_(text_log),
      record_(record),
      reply_recorders_{ReplyRecorder(scenario, Side::kLeft, step_),
                       ReplyRecorder(scenario, Side::kRight, step_)} {}

match::SideListener* ScenarioRecorder::listener(Side side) {
  ReplyRecorder& recorder = reply_recorders_[index_of(side)];
  return recorder.has_work() ? &recorder : nullptr;
}

void ScenarioRecorder::place_side(World& world, Events& events, Side side) const {
  const auto& placed = scenario_.sides[index_of(side)].players;
  const bool at_bench = placed.empty() && scenario_.mode == soccer::PlayMode::kBeforeKickOff;

  for (int unum = 1; unum <= soccer::kPlayersPerTeam && !at_bench; ++unum) {
    const int slot = soccer::slot_of(side, unum);
    const auto found = placed.find(unum);
    if (!placed.empty() && found == placed.end()) {
      simulator::leave(world, slot);
      continue;
    }
    const StartingPlace place = placed.empty() ? kick_off_place(side, unum) : found->second;
    const double body = place.body.value_or(side == Side::kLeft ? 0.0 : 180.0);
    simulator::move_player(world, slot, place.position, body, place.velocity, events);
    simulator::Player& player = world.player(slot);
    if (place.stamina) player.stamina.value = *place.stamina;
    player.cards = place.cards;
    if (place.cards > 0) player.state |= simulator::state::kYellowCard;
  }
}

void ScenarioRecorder::arrange(World& world, Events& events) {
  world.clock.time = scenario_.cycle;
  simulator::move_ball(world, scenario_.ball, scenario_.ball_velocity);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    world.team(side).score = scenario_.score[index_of(side)];
    place_side(world, events, side);
  }

  announce_score(world, events);
  if (scenario_.mode != soccer::PlayMode::kBeforeKickOff) {
    simulator::change_mode(world, scenario_.mode, events);
  }

  setup_messages_ =
      static_cast<int>(std::ranges::count_if(events, [](const simulator::Event& event) {
        return std::holds_alternative<simulator::RefereeMessage>(event.what);
      }));
  record_frame(world);
}

void ScenarioRecorder::record_frame(const World& world) {
  StepFrame frame;
  frame.step = step_;
  frame.cycle = world.clock.time;
  frame.mode = world.mode;
  frame.score = {world.team(Side::kLeft).score, world.team(Side::kRight).score};
  frame.ball = {world.ball.position, world.ball.velocity, true, 0.0, 0.0, 0};
  for (std::size_t slot = 0; slot < frame.players.size(); ++slot) {
    frame.players[slot] = frame_of(world.players[slot]);
  }
  record_.frames.push_back(std::move(frame));
}

void ScenarioRecorder::record_touches(const World& world) {
  for (std::size_t slot = 0; slot < kicks_.size(); ++slot) {
    const int kicks = world.players[slot].counters.kick;
    if (std::exchange(kicks_[slot], kicks) == kicks) continue;
    record_.touches.push_back({step_, static_cast<int>(slot)});
  }

  // Tackles and collisions are known only to the referee, which stores one per cycle.
  const simulator::TouchState& memory = world.referee.touch;
  const bool fresh = memory.touch_time != touch_time_ || memory.toucher != toucher_;
  touch_time_ = memory.touch_time;
  toucher_ = memory.toucher;
  if (fresh) record_touch(memory.toucher);

  // A catch changes the play mode and resets the touch state of the referee.
  if (std::exchange(catcher_, world.ball_catcher) != world.ball_catcher) record_touch(catcher_);
}

void ScenarioRecorder::record_touch(int slot) {
  const bool known = !record_.touches.empty() && record_.touches.back().step == step_ &&
                     record_.touches.back().slot == slot;
  if (slot != simulator::kNoPlayer && !known) record_.touches.push_back({step_, slot});
}

void ScenarioRecorder::record_referee_messages() {
  static constexpr std::string_view kReferee = "(referee ";
  const std::string_view text = text_log_.bytes();
  for (std::size_t at = text.find(kReferee, text_read_); at != std::string_view::npos;
       at = text.find(kReferee, at)) {
    at += kReferee.size();
    const std::size_t end = text.find(')', at);
    if (setup_messages_-- > 0) continue;
    record_.referee_messages.push_back({step_, std::string(text.substr(at, end - at))});
  }
  text_read_ = text.size();
}

void ScenarioRecorder::before_decisions(const match::MatchView& view) {
  const World& world = *view.world;
  ++step_;
  record_frame(world);
  record_touches(world);
  record_referee_messages();
}

bool ScenarioRecorder::after_cycle(const match::MatchView& /*view*/) {
  if (step_ >= scenario_.steps) return false;
  return std::ranges::none_of(scenario_.until, [this](const StepTest& test) {
    return test.holds(record_.frames.back(), record_);
  });
}

void ScenarioRecorder::finish() {
  // A match that never started: add one frame, so that step checks see an empty pitch.
  if (record_.frames.empty()) record_.frames.emplace_back();
  for (ReplyRecorder& recorder : reply_recorders_) recorder.move_to(record_);
}

}  // namespace cls::scenario
