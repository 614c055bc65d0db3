// Actions of an agent as numbers: a named, versioned set that turns them into player commands.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "training/scene/cast.h"
#include "training/scene/column.h"
#include "training/skills/skills.h"

namespace cls::training {

/// Something that holds for an agent now, or does not.
using Condition = bool (*)(const PointOfView& view);

/// An action with an id and its own parameters.
struct Action {
  std::string_view name;
  Columns parameters;
  /// The command; `values` are the action's own parameters, within their bounds.
  PlayerCommand (*command)(const PointOfView& view, const float* values);
  /// True if the action has an effect now. Null: always. Actions that ask the same have the same
  /// function, so that masks ask it once.
  Condition legal = nullptr;
};

/// Either a list of actions, chosen by id, or (`box`) one vector of values from which
/// `choose` makes the command.
struct ActionSet {
  std::string_view name;
  int version = 1;
  std::string_view summary;
  std::vector<Action> actions{};  ///< empty for a box
  Columns box{};                  ///< empty for a list of actions
  PlayerCommand (*choose)(const PointOfView& view, const float* values) = nullptr;
  /// The ids are those of player/options: `command` and `legal` are null, PointOfView::options says
  /// what is legal, and the agent is a player of a match who decides by play_option().
  bool options = false;

  int id_count() const { return static_cast<int>(actions.size()); }
  /// All values of a step: those of the box, or the parameters of all actions one after the other.
  Columns values() const;
  /// Index in values() of the first parameter of action `id`.
  std::vector<int> offsets() const;
};

/// The legality of all actions of a set: each condition once, and the ids that it decides.
class Legality {
 public:
  Legality() = default;
  explicit Legality(const ActionSet& set);

  /// Writes 1 for each id that has an effect now, else 0.
  void fill(const PointOfView& view, std::uint8_t* mask) const;

 private:
  struct Run {
    std::size_t condition;  ///< index in conditions_
    std::size_t first;      ///< of consecutive ids
    std::size_t count;
  };

  bool options_ = false;
  std::vector<Condition> conditions_;  ///< null: always
  std::vector<Run> runs_;
};

// A change of ids, values or meanings needs a new version.
const ActionSet& low_actions();
const ActionSet& low_all_actions();
const ActionSet& low_flat_actions();
const ActionSet& low_discrete_actions();
const ActionSet& hfo_actions();
const ActionSet& skill_actions();
const ActionSet& option_actions();

const std::vector<const ActionSet*>& action_sets();

/// Null for unknown names.
const ActionSet* find_action_set(std::string_view name);

}  // namespace cls::training
