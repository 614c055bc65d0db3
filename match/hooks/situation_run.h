// `--book`: a match of situations instead of two halves.
#pragma once

#include <cstdint>
#include <optional>

#include "analysis/situations/book.h"
#include "gamelog/record/match_record.h"
#include "gamelog/record/record_builder.h"
#include "match/hooks/match_hooks.h"
#include "match/hooks/situation_play.h"
#include "match/result/match_result.h"

namespace cls::match {

/// Plays situations (situation_play.h) in a match of `cls match`, and says what each was worth.
class SituationRun : public FolderHooks {
 public:
  /// `book` must outlive the run.
  SituationRun(const analysis::Book& book, std::uint64_t seed, int situations, int cycles);

  void arrange(simulator::World& world, simulator::Events& events) override;
  void after_step(simulator::World& world, simulator::Events& events) override;
  bool after_cycle(const MatchView& /*view*/) override { return !play_.over(); }
  void add_result(MatchResult& result) const override { result.book = this->result(); }

  /// The situations that were played to their end.
  BookResult result() const;

 private:
  void record_play(const simulator::World& world);
  void finish();

  const analysis::Book& book_;
  SituationPlay play_;
  gamelog::MatchRecord record_;  ///< of the situation that is played, from its moment
  std::optional<gamelog::RecordBuilder> builder_;  ///< of `record_`, while frames are added
  BookResult result_;
};

}  // namespace cls::match
