// Situations in a running match.
#include "match/hooks/situation_run.h"

#include <cmath>
#include <utility>

#include "analysis/situations/situation_value.h"
#include "base/index.h"
#include "simulator/referee/referee.h"
#include "simulator/referee/substitution.h"
#include "simulator/sessions/match_recorder.h"
#include "soccer/math.h"

namespace cls::match {
namespace {

using simulator::Events;
using simulator::Player;
using simulator::World;

constexpr double kPerOne = 1e6;  // of figures in results
constexpr std::uint32_t kKept = simulator::state::kStand | simulator::state::kGoalie;

// The team's goalie takes the place of number 1, and number 1 that of the goalie.
std::size_t place_of(const World& world, std::size_t slot) {
  const std::size_t first = slot < soccer::kPlayersPerTeam ? 0 : soccer::kPlayersPerTeam;
  if (world.players[slot].goalie) return first;
  if (slot != first) return slot;
  for (std::size_t i = first; i < first + soccer::kPlayersPerTeam; ++i) {
    if (world.players[i].goalie) return i;
  }
  return slot;
}

// Removes the rest of an earlier situation: blocks, arms and cards.
void refresh(Player& player) {
  player.kick_cycles = player.dash_cycles = -1;
  player.tackle_cycles = player.foul_cycles = player.catch_ban = player.moves_since_catch = 0;
  player.cards = 0;
  player.state &= kKept;
}

void place(Player& player, const analysis::BookPlayer& at, const analysis::BookStamina& stamina) {
  player.position = at.position;
  player.velocity = at.velocity;
  player.acceleration = {};
  player.body = player.pending_body = soccer::math::to_radians(at.body);
  player.stamina = {stamina.stamina, stamina.effort, stamina.recovery,
                    stamina.capacity < 0 ? player.stamina.capacity : stamina.capacity};
  player.legs = {};
}

}  // namespace

SituationRun::SituationRun(const analysis::Book& book, std::uint64_t seed, int situations,
                           int cycles)
    : book_(book), situations_(analysis::situations_of(book, seed, situations)), cycles_(cycles) {}

void SituationRun::arrange(World& world, Events& events) { begin(world, events); }

void SituationRun::begin(World& world, Events& events) {
  const simulator::TimeState time = world.referee.time;
  world.referee = {};
  world.referee.time = time;
  world.ball_catcher = simulator::kNoPlayer;

  for (std::size_t slot = 0; slot < world.players.size(); ++slot) {
    Player& player = world.players[slot];
    refresh(player);
    const int type = situation().players[place_of(world, slot)].type;
    if (player.enabled && player.type != type) {
      simulator::substitute(world, static_cast<simulator::Slot>(slot), type, events);
    }
  }

  // Twice: the new mode clears players from the ball.
  shown_ = 0;
  show_step(world);
  simulator::change_mode(world, situation().mode, events);
  shown_ = 0;
  show_step(world);
}

void SituationRun::show_step(World& world) {
  const analysis::BookFrame& frame = situation().frames[shown_++];
  world.ball = {frame.ball, frame.ball_velocity, {}};
  world.referee.touch.previous_ball = frame.ball;

  const bool is_moment = shown_ == situation().frames.size();
  for (std::size_t slot = 0; slot < world.players.size(); ++slot) {
    Player& player = world.players[slot];
    if (!player.enabled) continue;

    const std::size_t from = place_of(world, slot);
    place(player, frame.players[from], situation().players[from]);
    player.command_done = !is_moment;
  }
  if (is_moment) record(world);
}

void SituationRun::record(const World& world) {
  if (!builder_) {
    builder_.emplace(record_);
    record_.server = world.rules->server;
    record_.player = world.rules->player;
    record_.types = world.rules->types;
  }
  gamelog::Frame frame;
  simulator::to_frame(world, frame);
  builder_->append_frame(frame);
}

void SituationRun::after_step(World& world, Events& events) {
  if (at_ >= situations_.size()) return;
  if (shown_ < situation().frames.size()) return show_step(world);

  record(world);
  const gamelog::TeamFrames& teams = gamelog::teams_at(record_, record_.frames() - 1);
  const gamelog::TeamFrames& before = gamelog::teams_at(record_, 0);
  const bool goal = teams[0].score != before[0].score || teams[1].score != before[1].score;
  if (goal || static_cast<int>(record_.frames()) > cycles_) finish(world, events);
}

void SituationRun::finish(World& world, Events& events) {
  const analysis::Flow flow = analysis::build_flow(record_);
  const analysis::SituationFigures figures = analysis::figures_of(flow, 0, record_.frames());
  const std::string& log = book_.logs[base::index(situation().log)].name;

  SituationResult played{std::string(name(situation().kind)),
                         log,
                         situation().time,
                         static_cast<int>(record_.frames()) - 1,
                         analysis::situation_value(figures),
                         {}};
  const auto values = figures.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    played.figures[std::string(analysis::kFigureNames[i])] =
        std::round(values[i] * kPerOne) / kPerOne;
  }

  result_.situations.push_back(std::move(played));
  record_ = {};
  builder_.reset();
  if (++at_ < situations_.size()) begin(world, events);
}

bool SituationRun::after_cycle(const MatchView& /*view*/) { return at_ < situations_.size(); }

BookResult SituationRun::result() const {
  BookResult result = result_;
  for (const SituationResult& one : result.situations) result.value += one.value;
  if (!result.situations.empty()) result.value /= static_cast<double>(result.situations.size());
  return result;
}

}  // namespace cls::match
