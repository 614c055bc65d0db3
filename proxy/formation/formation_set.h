// The formations a team plays in: one for each kind of situation.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "proxy/formation/formation.h"

namespace cls::proxy {

/// Kinds of situation (proxy behaviour 6.4). "Our" and "their" say whose dead ball it is.
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
constexpr std::size_t kFormationKinds = 13;

/// The kind's file name without ending, as librcsc's teams call it ("normal-formation").
std::string_view file_name(FormationKind kind);

/// Shared by all agents of a team; never changed once made.
class FormationSet {
 public:
  explicit FormationSet(std::array<Formation, kFormationKinds> formations)
      : formations_(std::move(formations)) {}

  const Formation& of(FormationKind kind) const {
    return formations_[static_cast<std::size_t>(kind)];
  }

 private:
  std::array<Formation, kFormationKinds> formations_;
};

/// Our own.
std::shared_ptr<const FormationSet> built_in_formations();

/// One file for each kind from a folder: NAME.formation, else NAME.conf, else NAME. Not ok when one
/// is missing or does not parse; the message names the file.
base::Result<std::shared_ptr<const FormationSet>> read_formations(const std::string& folder);

}  // namespace cls::proxy
