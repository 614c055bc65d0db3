// Attribution of wall time.
#include "match/result/speed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/index.h"
#include "soccer/per_side.h"

namespace cls::match {
namespace {

using soccer::Side;

// A Playmaker with this much of the other's share limits the speed as well.
constexpr double kComparable = 2.0 / 3.0;

// Left, right, trainer.
std::size_t place_of(Side side) { return side == Side::kNeutral ? 2 : soccer::side_index(side); }

// Rounds to a thousandth, the largest share so that the sum stays 1.
void round_shares(SpeedShares& shares) {
  constexpr double kSteps = 1000.0;
  std::array<double*, 6> all = {&shares.server,
                                &shares.agents,
                                &shares.left_playmaker,
                                &shares.right_playmaker,
                                &shares.trainer_playmaker,
                                &shares.clock};

  double sum = 0.0;
  for (double* share : all) sum += * share = std::round(*share * kSteps) / kSteps;
  double* largest = *std::ranges::max_element(all, {}, [](const double* share) { return *share; });
  *largest = std::round((*largest + 1.0 - sum) * kSteps) / kSteps;
}

/// Names of a limit, in the order of SpeedLimit: in result.json, and in a sentence.
struct LimitNames {
  std::string_view document;
  std::string_view sentence;
};
constexpr std::array<LimitNames, 9> kLimits = {{
    {"", ""},
    {"left playmaker", "the left Playmaker"},
    {"right playmaker", "the right Playmaker"},
    {"both playmakers", "both Playmakers"},
    {"trainer playmaker", "the trainer Playmaker"},
    {"agents", "the agents"},
    {"server", "the server"},
    {"clock", "the clock"},
    {"server and teams", "the server and the external teams"},
}};
static_assert(kLimits.size() == static_cast<std::size_t>(SpeedLimit::kServerAndTeams) + 1);

struct Party {
  double share;
  SpeedLimit limit;
};

Party largest_party(const SpeedShares& shares) {
  const auto [less, more] = std::minmax(shares.left_playmaker, shares.right_playmaker);
  const bool both = less >= kComparable * more;
  const bool left = shares.left_playmaker > shares.right_playmaker;
  const std::array<Party, 5> parties = {{
      {both ? less + more : more, both   ? SpeedLimit::kBothPlaymakers
                                  : left ? SpeedLimit::kLeftPlaymaker
                                         : SpeedLimit::kRightPlaymaker},
      {shares.trainer_playmaker, SpeedLimit::kTrainerPlaymaker},
      {shares.agents, SpeedLimit::kAgents},
      {shares.server, SpeedLimit::kServer},
      {shares.clock, SpeedLimit::kClock},
  }};
  return *std::ranges::max_element(parties, {}, &Party::share);
}

}  // namespace

double SpeedResult::limiting_share() const { return largest_party(shares).share; }

std::string_view name(SpeedLimit limit) { return kLimits[base::index(limit)].document; }

std::optional<SpeedLimit> parse_speed_limit(std::string_view name) {
  const auto* found = std::ranges::find(kLimits, name, &LimitNames::document);
  if (found == kLimits.end()) return std::nullopt;
  return static_cast<SpeedLimit>(found - kLimits.begin());
}

void SpeedMeter::add_turns(Duration wall, std::span<SideTurn> turns) {
  std::ranges::sort(turns, {}, [](const SideTurn& turn) { return turn.times.total; });
  Duration over{0};     // end of the turns so far
  Duration part{0};     // of each side that was at work until then
  Duration awaited{0};  // of all Playmakers
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const TurnTimes& times = turns[i].times;
    const Duration end = std::min(times.total, wall);
    part += (end - over) / static_cast<Duration::rep>(turns.size() - i);
    over = end;
    if (times.total.count() <= 0) continue;

    const double share = std::min(1.0, static_cast<double>(times.playmaker.count()) /
                                           static_cast<double>(times.total.count()));
    const auto waited = std::chrono::duration_cast<Duration>(part * share);
    playmakers_[place_of(turns[i].side)] += waited;
    awaited += waited;
  }
  agents_ += wall - awaited;
}

SpeedResult SpeedMeter::result() const {
  SpeedResult speed;
  const Duration sum =
      server_ + clock_ + agents_ + playmakers_[0] + playmakers_[1] + playmakers_[2];
  if (sum.count() <= 0) return speed;

  const auto share = [sum](Duration time) {
    return static_cast<double>(time.count()) / static_cast<double>(sum.count());
  };
  speed.shares = {share(server_),        share(agents_),        share(playmakers_[0]),
                  share(playmakers_[1]), share(playmakers_[2]), share(clock_)};

  round_shares(speed.shares);
  speed.limited_by = largest_party(speed.shares).limit;
  return speed;
}

std::string limiting_party(const SpeedResult& speed) {
  const std::string_view who = kLimits[base::index(speed.limited_by)].sentence;
  return fmt::format("limited by {} ({:.0f} %)", who, speed.limiting_share() * 100.0);
}

std::string describe(const SpeedResult& speed) {
  return fmt::format("{}, p99 {:.{}f} ms: {}", limiting_party(speed), speed.decision_ms.p99,
                     speed.decision_ms.p99 < 10.0 ? 1 : 0,
                     speed.fits_100_ms ? "fast enough for real time" : "too slow for real time");
}

}  // namespace cls::match
