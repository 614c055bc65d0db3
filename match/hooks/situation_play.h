// Situations of a book in a running match.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "analysis/situations/book.h"
#include "simulator/world/event.h"
#include "simulator/world/world.h"

namespace cls::match {

/// Plays situations one after the other. Before each, players perceive the recorded steps that led
/// to it, and body commands have no effect; heads, views and messages are theirs. Then the moment
/// is exact: positions, velocities, bodies, stamina, types and mode are those of the record. The
/// game time and the score of the match continue. A situation ends after its cycles or with a goal.
///
///     play.begin(world, events);    // before the first step
///     play.after_step(world);       // after each step, before players perceive it
///     if (play.ended()) play.next(world, events);
class SituationPlay {
 public:
  /// `book` must outlive this object.
  SituationPlay(const analysis::Book& book, std::uint64_t seed, int situations, int cycles);

  /// Puts ball and players where the situation begins.
  void begin(simulator::World& world, simulator::Events& events);
  /// Shows the next recorded step, or counts the one that was played. Not after the last situation.
  void after_step(simulator::World& world);
  /// Goes to the following situation, if there is one, and begins it.
  void next(simulator::World& world, simulator::Events& events);

  /// The last situation has ended.
  bool over() const { return at_ >= situations_.size(); }
  /// The moment has been reached: what happens is played.
  bool in_play() const { return shown_ == situation().frames.size(); }
  /// The situation has had its cycles or a goal.
  bool ended() const { return ended_; }
  /// That is played.
  const analysis::Situation& situation() const { return *situations_[at_]; }

 private:
  void show_step(simulator::World& world);

  std::vector<const analysis::Situation*> situations_;
  int cycles_;
  std::size_t at_ = 0;     ///< the situation that is played
  std::size_t shown_ = 0;  ///< its steps that players have perceived, the moment included
  int played_ = 0;         ///< steps since the moment
  int goals_ = 0;          ///< of both teams at the moment
  bool ended_ = false;
};

}  // namespace cls::match
