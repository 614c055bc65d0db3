// A book of situations: moments of recorded matches from which teams play for some cycles. Plain
// data (docs/formats/book.md).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/geometry.h"
#include "soccer/parameters/player_type.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::analysis {

/// The event of the moment, as the left team sees it.
enum class SituationClass : std::uint8_t {
  kAttack,    ///< it has the ball in the opponents' third
  kDefense,   ///< the opponents have the ball in its third
  kSetPlay,   ///< a team is about to take a free kick, kick-in, corner kick or goal kick
  kTurnover,  ///< a team has just lost the ball
  kBuildUp,   ///< a team has the ball in its own third or the middle
};
inline constexpr std::size_t kSituationClasses = 5;

/// Those of a book if nobody chooses.
inline constexpr std::array kDefaultClasses = {SituationClass::kAttack, SituationClass::kDefense,
                                               SituationClass::kSetPlay, SituationClass::kTurnover};

std::string_view name(SituationClass kind);
std::optional<SituationClass> parse_situation_class(std::string_view text);

/// Meters, meters per cycle and degrees in the coordinates of game logs.
struct BookPlayer {
  soccer::Vec2 position;
  soccer::Vec2 velocity;
  double body = 0.0;
};

/// Ball and players after a step.
struct BookFrame {
  soccer::Vec2 ball;
  soccer::Vec2 ball_velocity;
  std::array<BookPlayer, soccer::kPlayersOnPitch> players;  ///< by slot
};

/// The state of a player without its motion.
struct BookStamina {
  int type = 0;  ///< index into the types of the log
  double stamina = 0.0;
  double effort = 0.0;
  double recovery = 0.0;
  double capacity = 0.0;
};

struct Situation {
  SituationClass kind = SituationClass::kAttack;
  int log = 0;   ///< index into Book::logs
  int time = 0;  ///< game time of the moment in the recorded match
  std::array<int, 2> score = {};
  soccer::PlayMode mode = soccer::PlayMode::kPlayOn;
  std::array<BookStamina, soccer::kPlayersOnPitch> players;  ///< by slot; goalies have number 1
  /// The steps before the moment, which agents perceive and cannot change, and the moment last.
  std::vector<BookFrame> frames;
};

/// The recorded match of situations.
struct BookLog {
  std::string name;  ///< of its file
  std::array<std::string, 2> teams;
  std::vector<soccer::PlayerType> types;
};

struct Book {
  std::uint64_t seed = 0;  ///< of the choice of moments
  int warm_up = 0;         ///< steps before each moment
  std::vector<BookLog> logs;
  std::vector<Situation> situations;  ///< by log, time and class
};

/// Limits of a file.
inline constexpr int kMaxWarmUp = 50;
inline constexpr std::size_t kMaxSituations = 20'000;

/// The situations that a match with this seed plays: all of one log, because a match has one list
/// of player types, and of as many classes as possible. `count` is limited to those of the log. A
/// pure function.
std::vector<const Situation*> situations_of(const Book& book, std::uint64_t seed, int count);

/// The log of these situations, whose player types the match has.
const BookLog& log_of(const Book& book, std::uint64_t seed, int count);

}  // namespace cls::analysis
