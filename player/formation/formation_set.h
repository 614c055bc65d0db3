// The formations of a team: one per kind of situation; the built-in ones.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/index.h"
#include "base/result.h"
#include "player/formation/formation.h"

namespace cls::player {

/// Kinds of situation (docs/spec/proxy-behavior.md 6.4). "Our" and "their" name the team that takes
/// the set play.
enum class FormationKind : std::uint8_t {
  kBeforeKickOff,
  kNormal,
  kDefense,
  kOffense,
  kGoalKickOur,
  kGoalKickTheir,
  kGoalieCatchOur,
  kGoalieCatchTheir,
  kKickInOur,
  kSetPlayOur,
  kSetPlayTheir,
  kIndirectOur,
  kIndirectTheir,
};
constexpr std::size_t kFormationKindCount = 13;

/// File name of the kind without extension, as in librcsc teams ("normal-formation").
std::string_view file_name(FormationKind kind);

/// Immutable; shared by all agents of a team.
class FormationSet {
 public:
  /// One formation per kind, in their order.
  explicit FormationSet(std::vector<Formation> formations) : formations_(std::move(formations)) {}

  const Formation& of(FormationKind kind) const { return formations_[base::index(kind)]; }

 private:
  std::vector<Formation> formations_;
};

/// The formations shipped with cls.
std::shared_ptr<const FormationSet> built_in_formations();

/// Reads one file per kind from a folder: NAME.formation, otherwise NAME.conf, otherwise NAME.
/// Fails when one is missing or does not parse; the error names the file.
base::Result<std::shared_ptr<const FormationSet>> read_formations(const std::string& folder);

/// Text of player/formation/built_in/<name>.formation, embedded by the build; empty for an unknown
/// name.
std::string_view built_in_formation(std::string_view name);

}  // namespace cls::player
