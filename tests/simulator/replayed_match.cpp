// The differential test of the simulator.
#include "tests/simulator/replayed_match.h"

#include <stdexcept>
#include <utility>

#include "simulator/actions.h"
#include "simulator/referee.h"
#include "simulator/step.h"
#include "simulator/substitution.h"
#include "soccer/protocol/coach_command.h"
#include "soccer/protocol/player_command.h"

namespace cls::tests {
namespace {

using namespace cls::simulator;

// What the rounding of the record allows; see the README of the data.
constexpr double kMotion = 2e-4;
constexpr double kRoughPosition = 5e-3;
constexpr double kRoughVelocity = 1e-2;
constexpr double kBody = 0.001;
constexpr double kBodyAfterTurn = 0.1;
constexpr double kNeck = 0.002;
constexpr double kStamina = 0.02;
constexpr double kEffort = 2e-6;
constexpr double kCapacity = 1.0;
constexpr double kRounding = 1e-9;
// A half that does not go on after so many steps never will.
constexpr int kLongestPause = 300;

std::string stamp(Clock clock) {
  return std::to_string(clock.time) + ',' + std::to_string(clock.stoppage);
}

class Replayer {
 public:
  Replayer(const RecordedMatch& match, Noise noise)
      : match_(match),
        noise_(noise),
        world_(world_at_kick_off(make_rules(match.server, match.player, match.types).value(),
                                 match.shows.front().frame)) {}

  ReplayResult run() {
    collect_their_words();
    for (std::size_t i = 0; i + 1 < match_.shows.size(); ++i) {
      restore(world_, match_.shows[i].frame);
      turned_.fill(false);
      step_to(match_.shows[i + 1].frame);
      compare(match_.shows[i + 1]);
      finish_step(world_, events_);
      collect_our_words();
      adopt(match_.shows[i + 1]);
    }
    return std::move(result_);
  }

 private:
  // Between two frames lies one step, or a whole half time, of which nothing is recorded.
  void step_to(const gamelog::Frame& after) {
    for (int steps = 0; steps < kLongestPause; ++steps) {
      world_.forced = shown_outcomes(after);
      force_shoot_out(*world_.forced, all_words_);
      if (noise_ == Noise::kFromRecord) force_arrivals(*world_.forced, after);
      apply_commands();
      step(world_, events_);
      if (world_.mode != PlayMode::kBeforeKickOff) return;
      finish_step(world_, events_);
    }
    throw std::runtime_error("no kick-off after " + stamp(world_.clock));
  }

  void apply_commands() {
    const auto found = match_.lines.find({world_.clock.time, world_.clock.stoppage});
    if (found == match_.lines.end()) return;
    std::vector<std::string> words;
    for (const RecordedMatch::Line& line : found->second) {
      if (const auto* called = std::get_if<RecordedMatch::Called>(&line)) {
        words.push_back(called->word);
      }
    }
    force_fouls(*world_.forced, words);
    for (const RecordedMatch::Line& line : found->second) {
      const auto* received = std::get_if<RecordedMatch::Received>(&line);
      if (received == nullptr) continue;
      if (received->unum == 0) {
        apply_coach(*received);
      } else {
        apply_player(*received);
      }
    }
  }

  void apply_player(const RecordedMatch::Received& received) {
    std::vector<soccer::PlayerCommand> commands;
    soccer::parse_player_commands(received.text, commands);
    const Slot slot = soccer::slot_of(received.side, received.unum);
    for (const soccer::PlayerCommand& command : commands) {
      const int turns = world_.player(slot).counters.turn;
      apply(world_, slot, command, events_);
      if (world_.player(slot).counters.turn > turns || world_.player(slot).has(state::kCatch)) {
        turned_[static_cast<std::size_t>(slot)] = true;
      }
    }
  }

  void apply_coach(const RecordedMatch::Received& received) {
    soccer::CoachCommand command;
    if (soccer::parse(received.text, soccer::CoachRole::kOnlineCoach, command)) return;
    const auto* change = std::get_if<soccer::ChangePlayerType>(&command);
    if (change != nullptr && change->type) {
      change_type(world_, received.side, change->unum, *change->type, events_);
    }
  }

  void compare(const RecordedMatch::Show& show) {
    const gamelog::Frame& frame = show.frame;
    const std::string now = std::to_string(frame.time) + ',' + std::to_string(show.stoppage);
    add("mode", world_.mode == frame.mode,
        now + ' ' + std::string(name(world_.mode)) + ' ' + std::string(name(frame.mode)));
    add("clock", world_.clock == Clock{frame.time, show.stoppage}, now + ' ' + stamp(world_.clock));
    for (std::size_t i = 0; i < 2; ++i) {
      const Team& ours = world_.teams[i];
      const gamelog::TeamFrame& theirs = frame.teams[i];
      add("score",
          ours.score == theirs.score && ours.penalty_goals == theirs.penalty_scored &&
              ours.penalty_kicks == theirs.penalties_taken(),
          now);
    }
    const Deviation ball = ball_deviation(world_, frame);
    compare_motion("ball", ball, now + " ball ");
    for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) compare_player(show, slot, now);
  }

  void compare_player(const RecordedMatch::Show& show, Slot slot, const std::string& now) {
    const Player& player = world_.player(slot);
    if (!player.enabled) return;
    const Deviation d = player_deviation(world_, show.frame, slot);
    const std::string who =
        now + ' ' + soccer::letter(player.side) + std::to_string(player.unum) + ' ';
    compare_motion("player", d, who);
    const double body = turned_[static_cast<std::size_t>(slot)] ? kBodyAfterTurn : kBody;
    add("body", within(d.body, body), who + std::to_string(d.body));
    add("neck", within(d.neck, kNeck), who + std::to_string(d.neck));
    add("stamina", within(d.stamina, kStamina), who + std::to_string(d.stamina));
    add("effort", within(d.effort, kEffort), who + std::to_string(d.effort));
    add("capacity", within(d.capacity, kCapacity), who + std::to_string(d.capacity));
    add("counters", d.same_counters, who);
    add("state", d.same_state,
        who + std::to_string(player.state) + ' ' +
            std::to_string(show.frame.players[static_cast<std::size_t>(slot)].state));
  }

  void compare_motion(const std::string& what, const Deviation& d, const std::string& who) {
    const std::string where = who + std::to_string(d.position) + ' ' + std::to_string(d.velocity);
    add(what, within(d.position, kMotion) && within(d.velocity, kMotion), where);
    add("roughly", within(d.position, kRoughPosition) && within(d.velocity, kRoughVelocity), where);
  }

  static bool within(double value, double limit) { return value <= limit + kRounding; }

  void add(const std::string& what, bool same, const std::string& where) {
    result_.agreements[what].add(same, where);
  }

  // A wrong clock or mode is counted once, not for the rest of the match.
  void adopt(const RecordedMatch::Show& show) {
    if (world_.mode != PlayMode::kBeforeKickOff) {
      world_.mode = show.frame.mode;
      world_.clock = {show.frame.time, show.stoppage};
    }
    for (std::size_t i = 0; i < 2; ++i) world_.teams[i].score = show.frame.teams[i].score;
  }

  void collect_our_words() {
    for (const Event& event : events_) {
      if (const auto* said = std::get_if<RefereeSaid>(&event.what)) {
        result_.our_words.push_back(stamp(event.clock) + ' ' + said->text);
      }
    }
    events_.clear();
  }

  void collect_their_words() {
    const Clock start = world_.clock;
    for (const auto& [when, lines] : match_.lines) {
      if (when.first < start.time) continue;
      for (const RecordedMatch::Line& line : lines) {
        if (const auto* called = std::get_if<RecordedMatch::Called>(&line)) {
          all_words_.push_back(called->word);
          result_.their_words.push_back(stamp({when.first, when.second}) + ' ' + called->word);
        }
      }
    }
  }

  const RecordedMatch& match_;
  Noise noise_;
  World world_;
  Events events_;
  std::vector<std::string> all_words_;
  std::array<bool, soccer::kPlayersOnPitch> turned_ = {};
  ReplayResult result_;
};

}  // namespace

void Agreement::add(bool same, const std::string& what) {
  ++compared;
  if (same) return;
  ++different;
  if (first_differences.size() < 20) first_differences.push_back(what);
}

ReplayResult replay(const RecordedMatch& match, Noise noise) {
  return Replayer(match, noise).run();
}

}  // namespace cls::tests
