// Step by step through two logs.
#include "simulator/replay/log_replay.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include "simulator/actions/actions.h"
#include "simulator/actions/trainer.h"
#include "simulator/referee/modes.h"
#include "simulator/referee/referee.h"
#include "simulator/referee/substitution.h"
#include "simulator/replay/logged_frames.h"
#include "simulator/replay/recorded_step.h"
#include "simulator/replay/replay.h"
#include "simulator/replay/step_comparison.h"
#include "simulator/replay/stronger_push.h"
#include "simulator/replay/text_log_index.h"
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

// A pause that lasts longer than the wait for the kick-off never ends.
constexpr int kPatience = 300;
constexpr std::uint32_t kLasting =
    state::kStand | state::kGoalie | state::kYellowCard | state::kRedCard | state::kDiscard;

bool is_noisy(const Rules& rules) {
  const soccer::ServerParams& server = rules.server;
  const bool windy = !server.wind_none && (server.wind_random || server.wind_rand != 0.0);
  return server.player_rand != 0.0 || server.ball_rand != 0.0 || windy ||
         std::any_of(rules.types.begin(), rules.types.end(),
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
    for (const auto& [when, moment] : text.moments()) {
      all_words_.insert(all_words_.end(), moment.words.begin(), moment.words.end());
      for (const SentText& sent : moment.sent) note_version(sent);
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
      const Way way = step_to(next, follows(clock, {now.time, game_.stopped[i]}));
      complete(next);
      if (way == Way::kBroken) {
        ++result_.skipped;
        // Calls of what is missing are nobody's mistake.
        unheard_.push_back({{now.time, game_.stopped[i]}, clock});
      } else {
        compare_step({before_, world_, next, clock, way == Way::kHalfTime, pushed_cut_off_, open_},
                     result_);
      }
      finish_step(world_, events_);
      collect_our_words();
      adopt(next, clock);
      now = std::move(next);
    }
    compare_words(start, game_.time[frames - 1]);
    return std::move(result_);
  }

 private:
  enum class Way { kOneStep, kHalfTime, kBroken };

  // What the log's version does not show goes on as we reckon it.
  void complete(Frame& frame) const {
    if (game_.version == RcgVersion::kV6 || game_.version == RcgVersion::kJson) return;
    for (std::size_t i = 0; i < frame.players.size(); ++i) {
      const Counters& ours = world_.players[i].counters;
      gamelog::CommandCounts& counts = frame.players[i].counts;
      counts.change_focus = ours.change_focus;
    }
  }

  // Between two frames lies one step, or a whole half time, of which nothing is recorded.
  Way step_to(const Frame& after, bool one_step) {
    const int most = world_.params().kick_off_wait + kPatience;
    for (int steps = 0; steps < most; ++steps) {
      before_ = world_;
      force(after);
      apply_commands();
      if (result_.has_noise) force_arrivals(*world_.forced, world_, after);
      forget_lost_pushes();
      note_push();
      step_like(after);
      if (world_.mode != PlayMode::kBeforeKickOff || after.mode == PlayMode::kBeforeKickOff) {
        if (steps > 0) return Way::kHalfTime;
        return one_step ? Way::kOneStep : Way::kBroken;
      }
      finish_step(world_, events_);
      kick_off_as_recorded();
    }
    return Way::kBroken;
  }

  void step_like(const Frame& after) {
    open_ = {};
    if (!result_.has_noise) return step(world_, events_);
    note_contest(after);
    open_ = step_as_recorded(world_, events_, after, contestants_);
  }

  // Who touched the ball last may show only when it leaves the pitch, many cycles later.
  void note_contest(const Frame& after) {
    TouchRule& memory = world_.referee.touch;
    const bool counts = memory.touch_time == world_.clock.time &&
                        std::any_of(pushes_.begin(), pushes_.end(), [&](const BallPush& push) {
                          return push.slot == memory.toucher;
                        });
    if (counts) {
      contestants_ = strongest_pushers(world_, pushes_, way_of_ball(after));
      contest_time_ = memory.touch_time;
      if (contestants_.size() == 1) memory.toucher = contestants_.front();
      // With noise no push is so weak that a mere touch outdoes it.
      memory.touch_acceleration = std::max(memory.touch_acceleration, soccer::math::kEps);
    }
    const bool is_one_of_them =
        std::find(contestants_.begin(), contestants_.end(), memory.toucher) != contestants_.end();
    if (memory.touch_time != contest_time_ || !is_one_of_them) contestants_.clear();
  }

  // Nothing if something else than kicks and noise moved it.
  std::optional<Vec2> way_of_ball(const Frame& after) const {
    constexpr double kSamePlace = 5e-4;
    if (shows_any(after, state::kBallCollide | state::kCatch) || after.ball_velocity.is_zero()) {
      return std::nullopt;
    }
    const Vec2 way = after.ball_position - world_.ball.position;
    const Vec2 kept = after.ball_velocity / world_.params().ball_decay;
    if (distance(way, kept) > kSamePlace) return std::nullopt;
    return way;
  }

  void force(const Frame& after) {
    world_.forced = shown_outcomes(after);
    for (std::size_t i = 0; i < meets_ball_.size(); ++i) {
      meets_ball_[i] = (after.players[i].state & state::kBallCollide) != 0;
    }
    force_shoot_out(*world_.forced, all_words_);
    if (const LogMoment* moment = text_.at(world_.clock)) {
      force_fouls(*world_.forced, moment->words, moment->called_after);
    }
  }

  // Without auto mode somebody at a monitor starts the half, of which only the call is recorded.
  void kick_off_as_recorded() {
    const LogMoment* moment = text_.at(world_.clock);
    if (moment == nullptr || world_.mode != PlayMode::kBeforeKickOff) return;
    const bool called = std::any_of(moment->words.begin(), moment->words.end(),
                                    [](const auto& word) { return word.starts_with("kick_off_"); });
    if (called) kick_off(world_, events_);
  }

  void apply_commands() {
    pushes_.clear();
    const LogMoment* moment = text_.at(world_.clock);
    if (moment == nullptr) return;
    for (const SentText& sent : moment->sent) {
      if (sent.source == RclSource::kPlayer) apply_player(sent);
      if (sent.source == RclSource::kCoach) apply_coach(sent);
      if (sent.source == RclSource::kTrainer) apply_trainer(sent);
    }
  }

  void apply_player(const SentText& sent) {
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
        const double noise = world_.forced->push_noise_max;
        apply(world_, slot, command, events_);
        const double more_noise = world_.forced->push_noise_max - noise;
        if (more_noise > 0.0) {
          pushes_.push_back({slot, world_.ball.acceleration - given, more_noise});
        }
      }
    }
  }

  // A goalie comes to touch the ball exactly, and the last digit decides whether they overlap: then
  // the ball, too, says how far the goalie gives way to somebody else. A record shows it by a bit.
  void apply_catch(Slot slot, const soccer::PlayerCommand& command) {
    constexpr int kTries = 20;
    constexpr double kBelowRounding = 1e-8;
    const World start = world_;
    const std::size_t said = events_.size();
    const bool recorded = meets_ball_[static_cast<std::size_t>(slot)];
    apply(world_, slot, command, events_);
    for (int i = 1; i <= kTries && world_.player(slot).has(state::kBallCollide) != recorded; ++i) {
      world_ = start;
      events_.resize(said);
      world_.ball.position.x += kBelowRounding * i;
      apply(world_, slot, command, events_);
    }
  }

  void apply_coach(const SentText& sent) {
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

  void apply_trainer(const SentText& sent) {
    soccer::CoachCommand command;
    if (soccer::parse(sent.text, soccer::CoachRole::kTrainer, command)) return;
    obey(world_, command, events_);
  }

  // Before version 12 a tackle says its power, later its angle.
  void note_version(const SentText& sent) {
    if (sent.source != RclSource::kPlayer || !sent.text.starts_with("(init ")) return;
    soccer::GameRequest request;
    if (soccer::parse(sent.text, request)) return;
    if (const auto* init = std::get_if<soccer::PlayerInit>(&request)) {
      world_.player(sent.side, sent.unum).client_version = static_cast<int>(init->version);
    }
  }

  // Somebody stopped or placed the ball after it was kicked. Tackles backwards give noise alone.
  void forget_lost_pushes() {
    if (!world_.ball.acceleration.is_zero()) return;
    Vec2 sum;
    for (const BallPush& push : pushes_) sum += push.acceleration;
    const bool is_in_play = soccer::mode_class(world_.mode) == soccer::ModeClass::kRunning;
    if (!is_in_play || !sum.is_zero()) world_.forced->push_noise_max = 0.0;
  }

  void note_push() {
    const soccer::ServerParams& server = world_.params();
    const Ball& ball = world_.ball;
    const double noise = world_.forced->push_noise_max;
    pushed_cut_off_ = ball.acceleration.length() + noise > server.ball_accel_max ||
                      (ball.velocity + ball.acceleration).length() + noise > server.ball_speed_max;
  }

  // What differs is counted once, not for the rest of the match.
  void adopt(const Frame& frame, Clock clock) {
    if (world_.mode != frame.mode) {
      change_mode(world_, frame.mode, events_);
      events_.clear();
    }
    world_.clock = clock;
    adopt_score(frame);
    for (std::size_t i = 0; i < world_.players.size(); ++i) {
      const bool is_there = (frame.players[i].state & state::kStand) != 0;
      if (world_.players[i].enabled && !is_there) leave(world_, static_cast<Slot>(i));
      std::uint32_t& bits = world_.players[i].state;
      bits = (bits & ~kLasting) | (frame.players[i].state & kLasting);
    }
  }

  void adopt_score(const Frame& frame) {
    for (std::size_t i = 0; i < world_.teams.size(); ++i) {
      world_.teams[i].score = frame.teams[i].score;
      world_.teams[i].penalty_goals = frame.teams[i].penalty_scored;
      world_.teams[i].penalty_kicks = frame.teams[i].penalties_taken();
    }
  }

  void collect_our_words() {
    for (const Event& event : events_) {
      if (const auto* said = std::get_if<RefereeSaid>(&event.what)) {
        our_words_.insert({{event.clock.time, event.clock.stoppage}, said->text()});
      }
    }
    events_.clear();
  }

  using Word = std::pair<std::pair<int, int>, std::string>;

  void compare_words(Clock start, int end) {
    std::multiset<Word> theirs;
    for (const auto& [when, moment] : text_.moments()) {
      if (when.first < start.time || when.first > end) continue;
      for (const std::string& word : moment.words) theirs.insert({when, word});
    }
    const auto keep = [&](const std::multiset<Word>& one, const std::multiset<Word>& other,
                          std::vector<std::string>& out) {
      std::vector<Word> rest;
      std::set_difference(one.begin(), one.end(), other.begin(), other.end(),
                          std::back_inserter(rest));
      for (const auto& [when, word] : rest) {
        if (is_in_gap(when)) continue;
        out.push_back(std::to_string(when.first) + ',' + std::to_string(when.second) + ' ' + word);
      }
    };
    keep(theirs, our_words_, result_.missing_words);
    keep(our_words_, theirs, result_.added_words);
    result_.words.steps = static_cast<int>(theirs.size());
    result_.words.agreed = result_.words.steps - static_cast<int>(result_.missing_words.size());
  }

  bool is_in_gap(const std::pair<int, int>& when) const {
    return std::any_of(unheard_.begin(), unheard_.end(), [&](const auto& gap) {
      return when >= std::pair{gap.first.time, gap.first.stoppage} &&
             when <= std::pair{gap.second.time, gap.second.stoppage};
    });
  }

  const MatchRecord& game_;
  const TextLogIndex& text_;
  World world_;
  World before_;  ///< ahead of the step's commands
  Events events_;
  std::vector<soccer::PlayerCommand> commands_;
  std::vector<std::string> all_words_;
  std::multiset<Word> our_words_;
  std::vector<std::pair<Clock, Clock>> unheard_;
  bool pushed_cut_off_ = false;
  std::array<bool, soccer::kPlayersOnPitch> meets_ball_ = {};  ///< by the record
  std::vector<BallPush> pushes_;   ///< of the step, in the order of the commands
  std::vector<Slot> contestants_;  ///< each may be who touched the ball last
  int contest_time_ = -1;
  OpenOutcomes open_;
  LogAgreement result_;
};

}  // namespace

base::Result<LogAgreement> replay_log(const MatchRecord& game, const gamelog::RclRecord& text) {
  if (game.version <= RcgVersion::kV3) {
    return base::Error{
        "game logs of versions 1 to 3 hold too few digits to reckon with; 4 to 6 and JSON do"};
  }
  if (game.frames() < 2) return base::Error{"the game log has no two frames"};
  const TextLogIndex index(text, game.final_teams());
  if (!index.knows_a_team()) {
    return base::Error{"no team of the game log ('" + game.final_teams()[0].name + "', '" +
                       game.final_teams()[1].name + "') sent anything in the text log"};
  }
  if (!same_match(game, index)) {
    return base::Error{"the logs are of different matches: the text log calls other play modes"};
  }
  auto rules = make_rules(game.server, game.player, game.types);
  if (!rules) return rules.error();
  return LogReplay(game, index, *std::move(rules)).run();
}

}  // namespace cls::simulator
