// The eleven academy situations of Google Research Football on the pitch of the soccer server.
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "soccer/math.h"
#include "soccer/pitch.h"
#include "training/tasks/task.h"

namespace cls::training {
namespace {

using soccer::math::kPi;

/// Positions in the scale of that environment: x -1..1 and y -0.42..0.42, the left team attacks +x.
struct Place {
  double x;
  double y;
};

/// The players and their places. Goalies who stand at the other end of the pitch are left out.
struct Situation {
  std::string_view id;
  std::string_view summary;
  Place ball;
  std::vector<Place> left;
  std::vector<Place> right;   ///< a goalie stands on the goal line, and is the first one
  bool lazy = false;          ///< the right team stands, except its goalie
  bool ends_captured = true;  ///< the right team's possession ends the episode
  int cycles = 400;
};

// Eleven of the left team in their half; those of the right team mirrored.
const std::vector<Place> kLeftEleven = {
    {-1.0, 0.0},      {0.0, 0.02},          {0.0, -0.02},      {-0.422, -0.19576},
    {-0.5, -0.06356}, {-0.5, 0.063559},     {-0.422, 0.19576}, {-0.184212, -0.10568},
    {-0.267574, 0.0}, {-0.184212, 0.10568}, {-0.01, -0.2161}};
const std::vector<Place> kRightEleven = {
    {1.0, 0.0},      {0.05, 0.0},          {0.01, -0.216102}, {0.422, 0.19576},
    {0.5, 0.06356},  {0.5, -0.063559},     {0.422, -0.19576}, {0.184212, 0.10568},
    {0.267574, 0.0}, {0.184212, -0.10568}, {0.01, 0.2161}};

const std::vector<Place> kChasers = {
    {-0.12, -0.2}, {-0.12, -0.1}, {-0.12, 0.0}, {-0.12, 0.1}, {-0.12, 0.2}};
const std::vector<Place> kGoalieAndChasers = {{1.0, 0.0},   {-0.12, -0.2}, {-0.12, -0.1},
                                              {-0.12, 0.0}, {-0.12, 0.1},  {-0.12, 0.2}};

const std::vector<Place> kCounterattack = {
    {-1.0, 0.0},       {-0.672, -0.19576}, {-0.75, -0.06356}, {-0.75, 0.063559},
    {-0.672, 0.19576}, {-0.434, -0.10568}, {-0.434, 0.10568}, {0.5, -0.3161},
    {0.25, -0.1},      {0.25, 0.1},        {0.35, 0.316102}};

// Eleven whose center backs stand at `first` and `second`, the others before them.
std::vector<Place> countered(Place first, Place second) {
  return {{1.0, 0.0},    {-0.128, 0.19576},  first,
          second,        {-0.128, 0.19576},  {-0.365, 0.10568},
          {-0.282, 0.0}, {-0.365, -0.10568}, {-0.54, 0.3161},
          {-0.51, 0.0},  {-0.54, -0.316102}};
}

const std::vector<Place> kInTheMiddle = {{0.0, 0.0}};
const std::vector<Place> kTwoAttackers = {{0.7, 0.0}, {0.7, -0.3}};

const std::vector<Place> kCornerAttack = {{-1.0, 0.0},  {1.0, 0.42},  {0.7, 0.15}, {0.7, 0.05},
                                          {0.7, -0.05}, {0.0, 0.0},   {0.6, 0.35}, {0.8, 0.07},
                                          {0.8, -0.03}, {0.8, -0.13}, {0.7, -0.3}};
const std::vector<Place> kCornerDefense = {
    {1.0, 0.0},   {0.75, 0.18},  {0.75, 0.08},  {0.75, -0.02}, {1.0, 0.1}, {0.8, 0.25},
    {0.88, 0.07}, {0.88, -0.03}, {0.88, -0.13}, {0.75, -0.25}, {0.2, 0.0}};

const std::vector<Situation> kSituations = {
    {"Academy-EmptyGoalClose",
     "at the ball in front of an empty goal",
     {0.77, 0.0},
     {{0.75, 0.0}},
     {}},
    {"Academy-EmptyGoal", "at the ball in the middle, empty goal", {0.02, 0.0}, kInTheMiddle, {}},
    {"Academy-RunToScore",
     "run to an empty goal before five chasers",
     {0.02, 0.0},
     kInTheMiddle,
     kChasers},
    {"Academy-RunToScoreWithKeeper",
     "the same with a goalie",
     {0.02, 0.0},
     kInTheMiddle,
     kGoalieAndChasers},
    {"Academy-PassAndShootWithKeeper",
     "two attackers, the one without the ball is free",
     {0.7, -0.28},
     kTwoAttackers,
     {{1.0, 0.0}, {0.75, -0.3}}},
    {"Academy-RunPassAndShootWithKeeper",
     "two attackers, the one at the ball is free",
     {0.7, -0.28},
     kTwoAttackers,
     {{1.0, 0.0}, {0.75, -0.1}}},
    {"Academy-3Vs1WithKeeper",
     "three attackers, a defender and a goalie",
     {0.62, 0.0},
     {{0.6, 0.0}, {0.7, 0.2}, {0.7, -0.2}},
     {{1.0, 0.0}, {0.75, 0.0}}},
    {.id = "Academy-Corner",
     .summary = "a corner of eleven against eleven",
     .ball = {0.99, 0.41},
     .left = kCornerAttack,
     .right = kCornerDefense,
     .ends_captured = false},
    {"Academy-CounterattackEasy",
     "eleven against eleven, one defender and the goalie are back",
     {0.26, -0.11},
     kCounterattack,
     countered({-0.4, 0.06356}, {0.4, -0.063559})},
    {"Academy-CounterattackHard",
     "the same with two defenders",
     {0.26, -0.11},
     kCounterattack,
     countered({0.4, 0.06356}, {0.4, -0.063559})},
    {.id = "Academy-SingleGoalVersusLazy",
     .summary = "eleven against a goalie and ten who stand",
     .ball = {-0.48, -0.06356},
     .left = kLeftEleven,
     .right = kRightEleven,
     .lazy = true,
     .cycles = 3000}};

Vec2 to_pitch(Place place) {
  return {place.x * soccer::kHalfLength, place.y / 0.42 * soccer::kHalfWidth};
}

// Players stand up to half a meter from their places, so that episodes differ.
void place_situation(const Situation& situation, const Placing& start) {
  const double noise = 0.5 * start.options[0];
  const auto near = [&](Place place) {
    const double dx = start.random.uniform(-noise, noise);
    const double dy = start.random.uniform(-noise, noise);
    return to_pitch(place) + Vec2{dx, dy};
  };

  start.put_ball(to_pitch(situation.ball));
  for (std::size_t i = 0; i < start.cast.left.size(); ++i) {
    start.put(start.cast.left[i], near(situation.left[i]), 0.0);
  }
  for (std::size_t i = 0; i < start.cast.right.size(); ++i) {
    start.put(start.cast.right[i], near(situation.right[i]), kPi);
  }
}

template <std::size_t kIndex>
void place(const Placing& start) {
  place_situation(kSituations[kIndex], start);
}

template <std::size_t kIndex>
Status judge(const simulator::World& world, const OptionValues& /*options*/, TaskMemory& memory) {
  if (scored_against(world, Side::kRight, memory)) {
    ++memory.score[0];
    return Status::kGoal;
  }
  if (scored_against(world, Side::kLeft, memory)) {
    ++memory.score[1];
    return Status::kGoalConceded;
  }

  const Vec2 ball = world.ball.position;
  if (std::fabs(ball.x) > soccer::kHalfLength + 0.1 || std::fabs(ball.y) > soccer::kHalfWidth) {
    return Status::kOutOfBounds;
  }
  if (kSituations[kIndex].ends_captured && memory.taken >= 2) return Status::kCaptured;

  count_possession(world, memory);
  return Status::kInGame;
}

template <std::size_t kIndex>
Task make() {
  const Situation& situation = kSituations[kIndex];
  const int left = static_cast<int>(situation.left.size());
  const int right = static_cast<int>(situation.right.size());
  return {.id = situation.id,
          .summary = situation.summary,
          .offense = {left, left, left},
          .defense = {right, right, right},
          .right_goalie = right > 0 && situation.right.front().x >= 1.0,
          .max_cycles = situation.cycles,
          .options = {{"difficulty", 1, 0, 1,
                       "0: players start exactly at their places; 1: within 0.5 m"}},
          .place = place<kIndex>,
          .judge = judge<kIndex>,
          .lazy = situation.lazy};
}

template <std::size_t... kIndices>
std::vector<Task> make_all(std::index_sequence<kIndices...>) {
  return {make<kIndices>()...};
}

}  // namespace

std::vector<Task> academy() { return make_all(std::make_index_sequence<11>()); }

}  // namespace cls::training
