// `--record-choices`: what players with the ball observed and chose (docs/formats/choices.md), for
// programs that learn to choose so.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "match/hooks/side_hooks.h"
#include "player/options/options.h"
#include "training/policy/player_features.h"

namespace cls::match {

/// A decision of a field player with the ball in play.
struct RecordedChoice {
  std::int32_t cycle = 0;
  std::int32_t unum = 0;
  std::int32_t option = 0;        ///< of the action set "options"; -1: none is like it
  std::array<char, 32> action{};  ///< what was executed, filled up with zeros
  std::array<std::uint8_t, player::kOptionCount> legal{};
  std::vector<float> observed;  ///< the feature set "team"
};

/// Records one side.
class ChoicesOfSide : public SideDecisions {
 public:
  explicit ChoicesOfSide(std::filesystem::path file);

  void before_decision(const proxy::PlayerAgent& agent) override;
  void on_decision(const proxy::Decision& decision) override;
  /// Writes the file, if the side had players. Returns the error, or an empty string.
  std::string close();

 private:
  std::filesystem::path file_;
  bool heard_ = false;
  std::array<player::OptionTable, soccer::kPlayersPerTeam> tables_;  ///< of the players' decisions
  training::PlayerFeatures features_;
  std::vector<RecordedChoice> choices_;
};

/// Writes left-choices.npy and right-choices.npy into the match folder at its end. In lockstep the
/// same match gives the same bytes.
class ChoiceRecorder : public SideHooks<ChoicesOfSide> {
 public:
  explicit ChoiceRecorder(const std::filesystem::path& folder);
};

}  // namespace cls::match
