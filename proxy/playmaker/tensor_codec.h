// Feature sets and action sets of trained policies, as the agents offer them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "player/world/world_model.h"
#include "soccer/commands/player_command.h"

namespace cls::proxy {

/// A pair of sets that a Playmaker chose, and how many players an observation has.
struct TensorChoice {
  std::string feature_set;
  std::string action_set;
  int teammates = 0;
  int opponents = 0;
};

/// Sizes of the rows of a choice.
struct TensorSizes {
  int features = 0;
  int ids = 0;      ///< width of a mask; 0: the action set has no ids
  int actions = 0;  ///< width of a row of actions
};

/// Converts world models to rows of numbers, and rows of numbers to commands. The feature sets
/// belong to training/, which includes the agents; they do not include it.
class TensorCodec {
 public:
  virtual ~TensorCodec() = default;

  /// Another one for a Playmaker of its own.
  virtual std::shared_ptr<TensorCodec> clone() const = 0;

  /// NAME/VERSION, the same list for every match.
  virtual std::vector<std::string> feature_sets() const = 0;
  virtual std::vector<std::string> action_sets() const = 0;

  /// Selects the form of the rows; the error names what does not exist.
  virtual base::Result<TensorSizes> choose(const TensorChoice& choice) = 0;

  /// Appends the row of a player with a completed world model. After choose().
  virtual void encode(const player::WorldModel& world, std::vector<float>& features,
                      std::vector<std::uint8_t>& masks) = 0;

  /// The body command of a row; nullopt for a row that is not finite or has no such id.
  virtual std::optional<soccer::PlayerCommand> decode(const player::WorldModel& world,
                                                      const float* row) = 0;
};

}  // namespace cls::proxy
