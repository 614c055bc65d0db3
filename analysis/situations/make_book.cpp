// Moments of recorded matches by class, and a balanced choice of them.
#include "analysis/situations/make_book.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "analysis/play/flow.h"
#include "analysis/play/pitch_areas.h"
#include "soccer/pitch.h"
#include "soccer/random.h"

namespace cls::analysis {
namespace {

using gamelog::MatchRecord;
using soccer::PlayMode;

constexpr double kMaxX = soccer::kHalfLength - 1.0;
constexpr double kMaxTurnoverX = 40.0;
constexpr int kTurnoverAge = 3;  // cycles since the other team touched the ball
constexpr int kSetPlayAge = 10;  // cycles since the set play began, at least
constexpr int kMaxSetPlayAge = 30;
constexpr std::uint32_t kBlocked = gamelog::kStateTackle | gamelog::kStateTackleFailed |
                                   gamelog::kStateCharged | gamelog::kStateRedCard;

bool is_playable(PlayMode mode) {
  switch (soccer::without_side(mode)) {
    case PlayMode::kPlayOn:
    case PlayMode::kFreeKickLeft:
    case PlayMode::kKickInLeft:
    case PlayMode::kCornerKickLeft:
    case PlayMode::kGoalKickLeft:
      return true;
    default:
      return false;
  }
}

/// Finds the class of a frame.
class Moments {
 public:
  Moments(const MatchRecord& record, int warm_up)
      : record_(record), flow_(build_flow(record)), warm_up_(warm_up) {}

  std::optional<SituationClass> class_at(std::size_t frame) const {
    if (!is_complete(frame)) return std::nullopt;
    if (record_.mode[frame] != PlayMode::kPlayOn) return set_play(frame);

    const double side = owner_sign(frame);
    const double x = record_.ball_position[frame].x;
    if (side == 0.0 || std::fabs(x) > kMaxX) return std::nullopt;

    const std::size_t before = frame - base::index(std::min(warm_up_, kTurnoverAge));
    const double earlier = owner_sign(before);
    if (earlier != 0.0 && earlier != side) {
      if (std::fabs(x) > kMaxTurnoverX) return std::nullopt;
      return SituationClass::kTurnover;
    }

    if (side > 0 && x > kThirdBorder) return SituationClass::kAttack;
    if (side < 0 && x < -kThirdBorder) return SituationClass::kDefense;
    return SituationClass::kBuildUp;
  }

  /// Index of a team's goalie among its players; -1: it has none.
  int goalie_of(std::size_t frame, std::size_t team) const {
    for (std::size_t i = 0; i < kTeamSize; ++i) {
      if (is_goalie(record_, entry_of(frame, kTeamSlots[team][i]))) return static_cast<int>(i);
    }
    return -1;
  }

 private:
  double owner_sign(std::size_t frame) const {
    const std::int8_t owner = flow_.owner[frame];
    return owner == kNoPlayer ? 0.0 : attack_sign(owner);
  }

  // All players are there and can act, and the steps before are recorded without a gap, in one
  // mode.
  bool is_complete(std::size_t frame) const {
    const std::size_t steps = base::index(warm_up_);
    if (frame < steps || !is_playable(record_.mode[frame])) return false;

    for (std::size_t at = frame - steps; at <= frame; ++at) {
      if (record_.mode[at] != record_.mode[frame]) return false;
      const auto age = static_cast<int>(frame - at);
      if (record_.time[at] != record_.time[frame] - age || record_.stopped[at] != 0) return false;
    }

    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      const std::uint32_t state = record_.players.state[entry_of(frame, slot)];
      if ((state & gamelog::kStateEnabled) == 0 || (state & kBlocked) != 0) return false;
    }
    return goalie_of(frame, 0) >= 0 && goalie_of(frame, 1) >= 0;
  }

  std::optional<SituationClass> set_play(std::size_t frame) const {
    int age = 0;
    while (age <= kMaxSetPlayAge && base::index(age) < frame &&
           record_.mode[frame - base::index(age) - 1] == record_.mode[frame]) {
      ++age;
    }

    if (age < std::max(kSetPlayAge, warm_up_) || age > kMaxSetPlayAge) return std::nullopt;
    return SituationClass::kSetPlay;
  }

  const MatchRecord& record_;
  Flow flow_;
  int warm_up_;
};

BookFrame frame_of(const MatchRecord& record, std::size_t frame,
                   const std::array<std::size_t, gamelog::kSlots>& slots) {
  BookFrame result;
  result.ball = record.ball_position[frame];
  result.ball_velocity = record.ball_velocity[frame];
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const std::size_t entry = entry_of(frame, slots[i]);
    result.players[i] = {record.players.position[entry], record.players.velocity[entry],
                         record.players.body[entry]};
  }
  return result;
}

Situation situation_at(const MatchRecord& record, const Moments& moments, std::size_t frame,
                       int warm_up) {
  Situation situation;
  situation.time = record.time[frame];
  situation.mode = record.mode[frame];
  const gamelog::TeamFrames& teams = gamelog::teams_at(record, frame);
  situation.score = {teams[0].score, teams[1].score};

  // The goalie changes places with number 1.
  std::array<std::size_t, gamelog::kSlots> slots{};
  std::iota(slots.begin(), slots.end(), std::size_t{0});
  for (std::size_t team = 0; team < 2; ++team) {
    const std::size_t first = team * kTeamSize;
    std::swap(slots[first], slots[first + base::index(moments.goalie_of(frame, team))]);
  }

  const gamelog::PlayerColumns& players = record.players;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const std::size_t entry = entry_of(frame, slots[i]);
    situation.players[i] = {players.type[entry], players.stamina[entry], players.effort[entry],
                            players.recovery[entry], players.capacity[entry]};
  }
  for (std::size_t at = frame - base::index(warm_up); at <= frame; ++at) {
    situation.frames.push_back(frame_of(record, at, slots));
  }
  return situation;
}

}  // namespace

std::string BookMaker::add(const MatchRecord& record, std::string name) {
  if (record.version <= gamelog::RcgVersion::kV3) {
    return "game logs of versions 1 to 3 lack the stamina of players; use version 4, 5, 6 or JSON";
  }
  if (record.types.empty()) return "the log has no player types";

  const Moments moments(record, options_.warm_up);
  std::array<int, kSituationClasses> last{};
  last.fill(-options_.spacing);
  const auto log = static_cast<int>(book_.logs.size());
  bool found = false;

  for (std::size_t frame = 0; frame < record.frames(); ++frame) {
    const auto kind = moments.class_at(frame);
    if (!kind || std::ranges::find(options_.classes, *kind) == options_.classes.end()) continue;
    int& before = last[base::index(*kind)];
    if (record.time[frame] < before + options_.spacing) continue;
    before = record.time[frame];

    Situation situation = situation_at(record, moments, frame, options_.warm_up);
    situation.kind = *kind;
    situation.log = log;
    found_[base::index(*kind)].push_back(std::move(situation));
    found = true;
  }

  if (!found) return "the match has no moment with 22 players in play";
  const auto& teams = record.final_teams();
  book_.logs.push_back({std::move(name), {teams[0].name, teams[1].name}, record.types});
  return {};
}

std::size_t BookMaker::moments(SituationClass kind) const {
  return found_[base::index(kind)].size();
}

Book BookMaker::make() {
  std::size_t each = base::index(options_.count) / options_.classes.size();
  for (const SituationClass kind : options_.classes) each = std::min(each, moments(kind));
  book_.seed = options_.seed;
  book_.warm_up = options_.warm_up;

  soccer::RandomStream draw(options_.seed, "book");
  for (auto& list : found_) {
    if (list.empty()) continue;
    draw.shuffle(std::span<Situation>(list));

    // Matches take turns: by the number of the moment within its match.
    std::vector<std::size_t> of_log(book_.logs.size());
    std::vector<std::pair<std::size_t, std::size_t>> order;
    for (std::size_t i = 0; i < list.size(); ++i) {
      order.emplace_back(of_log[base::index(list[i].log)]++, i);
    }
    std::ranges::sort(order);

    for (std::size_t i = 0; i < each; ++i) {
      book_.situations.push_back(std::move(list[order[i].second]));
    }
    list.clear();
  }

  std::ranges::stable_sort(book_.situations, {}, [](const Situation& one) {
    return std::tuple(one.log, one.time, one.kind);
  });
  return std::exchange(book_, {});
}

}  // namespace cls::analysis
