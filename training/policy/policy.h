// Trained policies as files (docs/formats/policy.md), and players that follow them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "base/text/enum_names.h"
#include "player/options/options.h"
#include "training/features/feature_set.h"
#include "training/policy/network.h"

namespace cls::training {

/// The decisions that a policy makes; the others are those of kAutoOption.
enum class PolicyDecides : unsigned char { kBall, kAll };
constexpr auto kPolicyDecidesNames = base::enum_names<PolicyDecides>("ball", "all");

/// How a policy chooses among the legal options.
enum class PolicyKind : unsigned char {
  kNetwork,
  kPlanner,  ///< the option that the planner of cls chooses
  kRandom,   ///< each with the same chance
};

/// Immutable; shared by the players of a team.
struct Policy {
  PolicyKind kind = PolicyKind::kNetwork;
  PolicyDecides decides = PolicyDecides::kBall;
  const FeatureSet* features = nullptr;  ///< of a network
  Network network;
};

/// Reads the bytes of a file for eleven against eleven with the actions "options". `name` is the
/// file name in errors.
base::Result<Policy> parse_policy(std::string_view bytes, const std::string& name);

/// "planner", "random", or the policy of a file.
base::Result<std::shared_ptr<const Policy>> read_policy(const std::string& name);

/// True for the names of read_policy() that are not files.
bool is_built_in_policy(std::string_view name);

}  // namespace cls::training
