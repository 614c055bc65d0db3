// `--book`: a match of situations instead of two halves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/situations/book.h"
#include "gamelog/record/match_record.h"
#include "gamelog/record/record_builder.h"
#include "match/hooks/match_hooks.h"
#include "match/result/match_result.h"

namespace cls::match {

/// Plays situations one after the other. Before each, players perceive the recorded steps that led
/// to it, and body commands have no effect; heads, views and messages are theirs. Then the moment
/// is exact: positions, velocities, bodies, stamina, types and mode are those of the record. The
/// game time and the score of the match continue. A situation ends after its cycles or with a goal.
class SituationRun : public FolderHooks {
 public:
  /// `book` must outlive the run.
  SituationRun(const analysis::Book& book, std::uint64_t seed, int situations, int cycles);

  void arrange(simulator::World& world, simulator::Events& events) override;
  void after_step(simulator::World& world, simulator::Events& events) override;
  bool after_cycle(const MatchView& view) override;
  void add_result(MatchResult& result) const override { result.book = this->result(); }

  /// The situations that were played to their end.
  BookResult result() const;

 private:
  const analysis::Situation& situation() const { return *situations_[at_]; }
  void begin(simulator::World& world, simulator::Events& events);
  void show_step(simulator::World& world);
  void record(const simulator::World& world);
  void finish(simulator::World& world, simulator::Events& events);

  const analysis::Book& book_;
  std::vector<const analysis::Situation*> situations_;
  int cycles_;
  std::size_t at_ = 0;     ///< the situation that is played
  std::size_t shown_ = 0;  ///< its steps that players have perceived, the moment included
  gamelog::MatchRecord record_;
  std::optional<gamelog::RecordBuilder> builder_;  ///< of `record_`, while frames are added
  BookResult result_;
};

}  // namespace cls::match
