// Replays a match step by step from two logs.
#include "simulator/replay/log_replay.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include "base/index.h"
#include "simulator/actions/actions.h"
#include "simulator/actions/trainer.h"
#include "simulator/referee/modes.h"
#include "simulator/referee/referee.h"
#include "simulator/referee/substitution.h"
#include "simulator/replay/frame_replay.h"
#include "simulator/replay/logged_match.h"
#include "simulator/replay/recorded_step.h"
#include "simulator/replay/step_comparison.h"
#include "simulator/replay/stronger_push.h"
#include "simulator/step.h"
#include "simulator/world/roster.h"
#include "soccer/commands/coach_command.h"
#include "soccer/commands/connection_request.h"
#include "soccer/commands/player_command.h"

namespace cls::simulator {
namespace {

using gamelog::Frame;
using gamelog::MatchRecord;
using gamelog::RcgVersion;
using gamelog::RclSource;

// Steps to wait for the end of half time beyond kick_off_wait.
constexpr int kMaxExtraWait = 300;
constexpr std::uint32_t kPersistentBits =
    state::kStand | state::kGoalie | state::kYellowCard | state::kRedCard | state::kDiscard;

bool is_noisy(const Rules& rules) {
  const soccer::ServerParams& server = rules.server;
  const bool windy = !server.wind_none && (server.wind_random || server.wind_rand != 0.0);

  return server.player_rand != 0.0 || server.ball_rand != 0.0 || windy ||
         std::ranges::any_of(rules.types,
                             [](const soccer::PlayerType& type) { return type.kick_rand != 0.0; });
}

class LogReplay {
 public:
  LogReplay(const MatchRecord& game, const TextLogIndex& text, std::shared_ptr<const Rules> rules)
      : game_(game),
        text_(text),
        world_(world_at_kick_off(std::move(rules), printed_frame(game, 0))),
        before_(world_) {
    world_.clock.stoppage = game.stopped[0];
    for (std::size_t i = 0; i < world_.teams.size(); ++i) {
      world_.teams[i].name = soccer::TeamName(game.final_teams()[i].name);
    }

    adopt_score(frame_at(game, 0));
    result_.has_noise = is_noisy(*world_.rules);
    result_.frames = static_cast<int>(game.frames());

    for (const auto& [when, step] : text.steps()) {
      all_calls_.insert(all_calls_.end(), step.calls.begin(), step.calls.end());
      for (const LoggedDatagram& sent : step.received) set_client_version(sent);
    }
  }

  LogAgreement run() {
    const Clock start = world_.clock;
    Frame now = printed_frame(game_, 0);
    const std::size_t frames = covered_frames(game_, text_);
    result_.skipped = static_cast<int>(game_.frames() - frames);

    for (std::size_t i = 0; i + 1 < frames; ++i) {
      Frame next = printed_frame(game_, i + 1);
      const Clock clock{next.time, game_.stopped[i + 1]};
      restore(world_, now);

      const Transition transition = step_to(next, follows(clock, {now.time, game_.stopped[i]}));
      fill_missing_fields(next);

      if (transition == Transition::kGap) {
        ++result_.skipped;
        // Calls in a gap are not compared.
        gaps_.push_back({{now.time, game_.stopped[i]}, clock});
      } else {
        compare_step({before_, world_, next, clock, transition == Transition::kHalfTime,
                      push_cut_off_, noise_decided_},
                     result_);
      }

      finish_step(world_, events_);
      collect_simulated_calls();
      adopt(next, clock);
      now = std::move(next);
    }

    compare_calls(start, game_.time[frames - 1]);
    return std::move(result_);
  }

 private:
  enum class Transition { kOneStep, kHalfTime, kGap };

  // Fields that the rcg version lacks continue as simulated.
  void fill_missing_fields(Frame& frame) const {
    if (game_.version >= RcgVersion::kV6) return;
    for (std::size_t i = 0; i < frame.players.size(); ++i) {
      frame.players[i].counts.change_focus = world_.players[i].counters.change_focus;
    }
  }

  // Between two frames lies one step, or a half time, which is not recorded.
  Transition step_to(const Frame& after, bool one_step) {
    const int max_steps = world_.params().kick_off_wait + kMaxExtraWait;
    for (int steps = 0; steps < max_steps; ++steps) {
      before_ = world_;
      set_overrides(after);
      apply_commands();
      if (result_.has_noise) override_arrivals(*world_.overrides, world_, after);
      discard_lost_pushes();
      record_push_limits();
      simulate_step(after);

      if (world_.mode != PlayMode::kBeforeKickOff || after.mode == PlayMode::kBeforeKickOff) {
        if (steps > 0) return Transition::kHalfTime;
        return one_step ? Transition::kOneStep : Transition::kGap;
      }

      finish_step(world_, events_);
      kick_off_as_recorded();
    }

    return Transition::kGap;
  }

  void simulate_step(const Frame& after) {
    noise_decided_ = {};
    if (!result_.has_noise) return step(world_, events_);

    update_contestants(after);
    noise_decided_ = step_as_recorded(world_, events_, after, contestants_);
  }

  // The last toucher may become visible many cycles later, when the ball leaves the pitch.
  void update_contestants(const Frame& after) {
    TouchState& state = world_.referee.touch;
    const bool is_contested =
        state.touch_time == world_.clock.time &&
        std::ranges::find(pushes_, state.toucher, &BallPush::slot) != pushes_.end();
    if (is_contested) {
      contestants_ = strongest_pushers(world_, pushes_, ball_displacement(after));
      contest_time_ = state.touch_time;
      if (contestants_.size() == 1) state.toucher = contestants_.front();
      // With noise, every push counts as stronger than a touch.
      state.touch_acceleration = std::max(state.touch_acceleration, soccer::math::kEps);
    }

    const bool is_one_of_them =
        std::ranges::find(contestants_, state.toucher) != contestants_.end();
    if (state.touch_time != contest_time_ || !is_one_of_them) contestants_.clear();
  }

  // No value if something other than kicks and noise moved the ball.
  std::optional<Vec2> ball_displacement(const Frame& after) const {
    constexpr double kSamePosition = 5e-4;
    if (shows_any(after, state::kBallCollide | state::kCatch) || after.ball_velocity.is_zero()) {
      return std::nullopt;
    }

    const Vec2 displacement = after.ball_position - world_.ball.position;
    const Vec2 expected = after.ball_velocity / world_.params().ball_decay;
    if (distance(displacement, expected) > kSamePosition) return std::nullopt;
    return displacement;
  }

  void set_overrides(const Frame& after) {
    world_.overrides.emplace(recorded_outcomes(after));
    for (std::size_t i = 0; i < recorded_contact_.size(); ++i) {
      recorded_contact_[i] = (after.players[i].state & state::kBallCollide) != 0;
    }

    override_shoot_out(*world_.overrides, all_calls_);
    if (const LoggedStep* step = text_.at(world_.clock)) {
      override_fouls(*world_.overrides, step->calls, step->called_after);
    }
  }

  // Without auto mode a monitor starts the half; the log records only the call.
  void kick_off_as_recorded() {
    const LoggedStep* step = text_.at(world_.clock);
    if (step == nullptr || world_.mode != PlayMode::kBeforeKickOff) return;

    const auto starts_half = [](const auto& call) { return call.starts_with("kick_off_"); };
    if (std::ranges::any_of(step->calls, starts_half)) kick_off(world_, events_);
  }

  void apply_commands() {
    pushes_.clear();
    const LoggedStep* step = text_.at(world_.clock);
    if (step == nullptr) return;

    for (const LoggedDatagram& sent : step->received) {
      if (sent.source == RclSource::kPlayer) apply_player(sent);
      if (sent.source == RclSource::kCoach) apply_coach(sent);
      if (sent.source == RclSource::kTrainer) apply_trainer(sent);
    }
  }

  void apply_player(const LoggedDatagram& sent) {
    commands_.clear();
    soccer::parse_player_commands(sent.text, commands_);
    const Slot slot = soccer::slot_of(sent.side, sent.unum);
    for (const soccer::PlayerCommand& command : commands_) {
      if (std::holds_alternative<soccer::Bye>(command)) {
        leave(world_, slot);
      } else if (std::holds_alternative<soccer::Catch>(command)) {
        apply_catch(slot, command);
      } else {
        const Vec2 given = world_.ball.acceleration;
        const double noise = world_.overrides->push_noise_max;
        apply(world_, slot, command, events_);

        const double more_noise = world_.overrides->push_noise_max - noise;
        if (more_noise > 0.0) {
          pushes_.push_back({slot, world_.ball.acceleration - given, more_noise});
        }
      }
    }
  }

  // A goalie moves until it exactly touches the ball, so the last bits decide whether they overlap,
  // which affects later collisions. The log records the contact as a state bit.
  void apply_catch(Slot slot, const soccer::PlayerCommand& command) {
    constexpr int kTries = 20;
    constexpr double kBelowRounding = 1e-8;
    const World start = world_;
    const std::size_t event_count = events_.size();
    const bool recorded = recorded_contact_[base::index(slot)];

    apply(world_, slot, command, events_);
    for (int i = 1; i <= kTries && world_.player(slot).has(state::kBallCollide) != recorded; ++i) {
      world_ = start;
      events_.resize(event_count);
      world_.ball.position.x += kBelowRounding * i;
      apply(world_, slot, command, events_);
    }
  }

  void apply_coach(const LoggedDatagram& sent) {
    soccer::CoachCommand command;
    if (soccer::parse(sent.text, soccer::CoachRole::kOnlineCoach, command)) return;

    const auto* change = std::get_if<soccer::ChangePlayerType>(&command);
    if (change == nullptr) return;

    if (change->type) {
      change_type(world_, sent.side, change->unum, *change->type, events_);
    } else {
      change_goalie(world_, sent.side, change->unum, events_);
    }
  }

  void apply_trainer(const LoggedDatagram& sent) {
    soccer::CoachCommand command;
    if (soccer::parse(sent.text, soccer::CoachRole::kTrainer, command)) return;
    apply(world_, command, events_);
  }

  // The parameter of tackle is a power before version 12, later an angle.
  void set_client_version(const LoggedDatagram& sent) {
    if (sent.source != RclSource::kPlayer || !sent.text.starts_with("(init ")) return;

    soccer::GameRequest request;
    if (soccer::parse(sent.text, request)) return;
    if (const auto* init = std::get_if<soccer::PlayerInit>(&request)) {
      world_.player(sent.side, sent.unum).client_version = static_cast<int>(init->version);
    }
  }

  // The ball was stopped or placed after it was kicked. Backward tackles add only noise.
  void discard_lost_pushes() {
    if (!world_.ball.acceleration.is_zero()) return;
    Vec2 sum;
    for (const BallPush& push : pushes_) sum += push.acceleration;

    const bool is_in_play = soccer::mode_class(world_.mode) == soccer::ModeClass::kRunning;
    if (!is_in_play || !sum.is_zero()) world_.overrides->push_noise_max = 0.0;
  }

  void record_push_limits() {
    const soccer::ServerParams& server = world_.params();
    const Ball& ball = world_.ball;
    const double noise = world_.overrides->push_noise_max;
    push_cut_off_ = ball.acceleration.length() + noise > server.ball_accel_max ||
                    (ball.velocity + ball.acceleration).length() + noise > server.ball_speed_max;
  }

  // Continues from the record, so that a difference is counted only once.
  void adopt(const Frame& frame, Clock clock) {
    if (world_.mode != frame.mode) {
      change_mode(world_, frame.mode, events_);
      events_.clear();
    }

    world_.clock = clock;
    adopt_score(frame);

    for (std::size_t i = 0; i < world_.players.size(); ++i) {
      const bool is_enabled = (frame.players[i].state & state::kStand) != 0;
      if (world_.players[i].enabled && !is_enabled) leave(world_, static_cast<Slot>(i));

      std::uint32_t& bits = world_.players[i].state;
      bits = (bits & ~kPersistentBits) | (frame.players[i].state & kPersistentBits);
    }
  }

  void adopt_score(const Frame& frame) {
    for (std::size_t i = 0; i < world_.teams.size(); ++i) {
      world_.teams[i].score = frame.teams[i].score;
      world_.teams[i].penalty_goals = frame.teams[i].penalty_scored;
      world_.teams[i].penalty_kicks = frame.teams[i].penalties_taken();
    }
  }

  void collect_simulated_calls() {
    for (const Event& event : events_) {
      if (const auto* message = std::get_if<RefereeMessage>(&event.what)) {
        simulated_calls_.insert({{event.clock.time, event.clock.stoppage}, message->text()});
      }
    }
    events_.clear();
  }

  using TimedCall = std::pair<std::pair<int, int>, std::string>;

  void compare_calls(Clock start, int end) {
    std::multiset<TimedCall> recorded_calls;
    for (const auto& [when, step] : text_.steps()) {
      if (when.first < start.time || when.first > end) continue;
      for (const std::string& call : step.calls) recorded_calls.insert({when, call});
    }

    const auto add_difference = [&](const std::multiset<TimedCall>& one,
                                    const std::multiset<TimedCall>& other,
                                    std::vector<std::string>& out) {
      std::vector<TimedCall> rest;
      std::ranges::set_difference(one, other, std::back_inserter(rest));
      for (const auto& [when, call] : rest) {
        if (is_in_gap(when)) continue;
        out.push_back(std::to_string(when.first) + ',' + std::to_string(when.second) + ' ' + call);
      }
    };

    add_difference(recorded_calls, simulated_calls_, result_.missing_calls);
    add_difference(simulated_calls_, recorded_calls, result_.extra_calls);

    result_.calls.steps = static_cast<int>(recorded_calls.size());
    result_.calls.agreed = result_.calls.steps - static_cast<int>(result_.missing_calls.size());
  }

  bool is_in_gap(const std::pair<int, int>& when) const {
    return std::ranges::any_of(gaps_, [&](const auto& gap) {
      return when >= std::pair{gap.first.time, gap.first.stoppage} &&
             when <= std::pair{gap.second.time, gap.second.stoppage};
    });
  }

  const MatchRecord& game_;
  const TextLogIndex& text_;
  World world_;
  World before_;  ///< before the commands of the step
  Events events_;
  std::vector<soccer::PlayerCommand> commands_;
  std::vector<std::string> all_calls_;
  std::multiset<TimedCall> simulated_calls_;
  std::vector<std::pair<Clock, Clock>> gaps_;
  bool push_cut_off_ = false;
  std::array<bool, soccer::kPlayersOnPitch> recorded_contact_ =
      {};                          ///< goalie touches the ball in the record
  std::vector<BallPush> pushes_;   ///< of the step, in command order
  std::vector<Slot> contestants_;  ///< candidates for the last toucher
  int contest_time_ = -1;
  NoiseDecisions noise_decided_;
  LogAgreement result_;
};

}  // namespace

base::Result<LogAgreement> replay_log(const MatchRecord& game, const gamelog::RclRecord& text) {
  if (game.version <= RcgVersion::kV3) {
    return base::Error{
        "rcg versions 1 to 3 lack the precision for replay; use version 4, 5, 6 or JSON"};
  }
  if (game.frames() < 2) return base::Error{"the game log has fewer than two frames"};

  const TextLogIndex index(text, game.final_teams());
  if (!index.knows_a_team()) {
    return base::Error{"the text log has no messages of the teams of the game log, '" +
                       game.final_teams()[0].name + "' and '" + game.final_teams()[1].name + "'"};
  }
  if (!same_match(game, index)) {
    return base::Error{"the logs are of different matches: their play modes differ"};
  }

  TRY_INIT(auto rules, make_rules(game.server, game.player, game.types));
  return LogReplay(game, index, std::move(rules)).run();
}

}  // namespace cls::simulator
