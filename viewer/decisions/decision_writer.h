// Writes the decisions of a team as chunks (docs/formats/decisions.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/decisions/decision_columns.h"
#include "viewer/decisions/decision_texts.h"
#include "viewer/stream/chunk.h"

namespace cls::viewer {

constexpr std::string_view kDecisionsSchema = "cls.decisions/1";

/// The texts of a decision, by their kind in a chunk of texts.
constexpr std::array<std::string DecisionSample::*, 4> kDecisionTexts = {
    &DecisionSample::reply, &DecisionSample::commands, &DecisionSample::plan,
    &DecisionSample::drawings};

/// Decisions that a chunk holds at most.
constexpr std::size_t kDecisionBlock = 512;

/// The states of a player's columns. Writers and readers go through the same states.
std::vector<ColumnState> decision_states();

/// Each function appends complete chunks to `out`.
class DecisionWriter {
 public:
  /// Called first.
  void append_header(soccer::Side side, std::string_view team, std::string& out);
  /// A decision of player `unum`, in the order of the match; writes those of all players when a
  /// block is full. Like chunks are neighbors: together they compress better.
  void append(int unum, const DecisionSample& sample, std::string& out);
  /// Called last: writes what is left, and the end.
  void append_end(std::string& out);

 private:
  struct Player {
    std::vector<ColumnState> states = decision_states();
    std::array<TextShapes, kDecisionTexts.size()> shapes;
    std::array<UnnumberedPlayer, kUnnumberedSlots> unnumbered;  ///< as in the last sample
    std::vector<SlottedSample> samples;                         ///< not written yet
    DecisionSample last;                                        ///< the last written one
    std::int64_t last_latency = 0;
  };

  Player& player_of(int unum);
  void append(ChunkKind kind, std::string_view contents, std::string& out);
  void append_blocks(std::string& out);
  std::string numbers_of(int unum);
  std::string texts_of(int unum, std::size_t kind);
  std::string latencies_of(int unum);

  std::array<Player, soccer::kPlayersPerTeam> players_;
  std::int64_t decisions_ = 0;
  std::uint32_t checksum_ = 0;
};

}  // namespace cls::viewer
