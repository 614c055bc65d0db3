// Reads policy files.
#include "training/policy/policy.h"

#include <fmt/format.h>

#include <cstring>
#include <map>
#include <utility>

#include "base/index.h"
#include "base/io/whole_file.h"
#include "base/text/json_document.h"
#include "soccer/pitch.h"
#include "training/actions/action_set.h"

namespace cls::training {
namespace {

using base::Error;
using base::JsonDocument;
using base::JsonValue;
using base::Result;

constexpr std::string_view kMagic = "CLSPOL2\n";
constexpr std::string_view kSchema = "cls.policy/2";
constexpr std::string_view kPlanner = "planner";
constexpr std::string_view kRandom = "random";
constexpr std::size_t kMaxHeader = 1 << 20;

std::uint32_t little_endian(std::string_view four) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number |= std::uint32_t{static_cast<unsigned char>(four[i])} << (8 * i);
  }
  return number;
}

/// The numbers after the header.
Result<std::vector<float>> read_weights(std::string_view bytes, const std::string& name) {
  if (bytes.size() % 4 != 0 || bytes.size() / 4 > Network::kMaxWeights) {
    return Error{
        fmt::format("{}: is cut off, or has more than {} weights", name, Network::kMaxWeights)};
  }
  std::vector<float> weights(bytes.size() / 4);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const std::uint32_t bits = little_endian(bytes.substr(4 * i, 4));
    std::memcpy(&weights[i], &bits, sizeof bits);
  }
  return weights;
}

/// Steps by name; the features are "features".
using StepNumbers = std::map<std::string, int>;

template <typename Names>
std::vector<std::string_view> all_of(const Names& names) {
  return {names.texts.begin(), names.texts.end()};
}

Result<StepPlan> read_step(const JsonValue& value, StepNumbers& known) {
  TRY(value.expect_keys({"name", "kind", "of", "first", "rows", "width", "activation"}));
  for (const std::string_view key : {"name", "kind", "of"}) {
    if (!value.has(key)) return value.error(fmt::format("the key '{}' is missing", key));
  }
  StepPlan step;
  TRY_INIT(const std::string kind, value["kind"].one_of(all_of(kStepKindNames)));
  step.kind = *kStepKindNames.parse(kind);
  if (!value["of"].is_array()) return value["of"].error("must be a list of names");
  for (std::size_t i = 0; i < value["of"].size(); ++i) {
    TRY_INIT(const std::string input, value["of"][i].string());
    const auto found = known.find(input);
    if (found == known.end()) return value["of"][i].error("no step before this one has the name");
    step.inputs.push_back(found->second);
  }

  for (const auto& [key, member] : {std::pair{"first", &StepPlan::first},
                                    {"rows", &StepPlan::rows},
                                    {"width", &StepPlan::width}}) {
    if (!value.has(key)) continue;
    TRY_INIT(step.*member, value[key].integer(0, Network::kMaxNumbers));
  }
  if (value.has("activation")) {
    TRY_INIT(const std::string name, value["activation"].one_of(all_of(kActivationNames)));
    step.activation = *kActivationNames.parse(name);
  }

  TRY_INIT(const std::string name, value["name"].string());
  const int number = static_cast<int>(known.size());
  if (!known.emplace(name, number).second)
    return value["name"].error("is the name of another step");
  return step;
}

Result<std::vector<StepPlan>> read_steps(const JsonValue& list) {
  if (!list.is_array()) return list.error("must be a list");
  std::vector<StepPlan> steps;
  StepNumbers known = {{"features", 0}};
  for (std::size_t i = 0; i < list.size(); ++i) {
    TRY_INIT(auto step, read_step(list[i], known));
    steps.push_back(std::move(step));
  }
  return steps;
}

/// Checks that players of a match can follow it.
Result<void> check_use(const JsonValue& root, Policy& policy) {
  const auto text = [&root](std::string_view key) {
    return root.has(key) && root[key].is_string() ? root[key].json().get<std::string>()
                                                  : std::string();
  };
  const auto number = [&root](std::string_view key) {
    const Result<int> value = root.has(key) ? root[key].integer(0, 1000) : Result<int>(-1);
    return value ? *value : -1;
  };

  const ActionSet& options = option_actions();
  if (text("actions") != options.name || number("action_version") != options.version) {
    return root.error(
        fmt::format("needs the actions {}/{}; play others with python3 -m cls_gym.play",
                    options.name, options.version));
  }

  const std::string features = fmt::format("{}/{}", text("features"), number("feature_version"));
  policy.features = find_feature_set(features);
  if (policy.features == nullptr || policy.features->needs_openings) {
    return root.error(fmt::format("the features {} cannot be observed in a match", features));
  }

  if (text("obs") != "world_model") return root.error("must be trained with obs world_model");
  if (number("teammates") != soccer::kPlayersPerTeam - 1 ||
      number("opponents") != soccer::kPlayersPerTeam) {
    return root.error("must be trained with 10 teammates and 11 opponents");
  }
  return {};
}

}  // namespace

Result<Policy> parse_policy(std::string_view bytes, const std::string& name) {
  const std::size_t start = kMagic.size() + 4;
  if (!bytes.starts_with(kMagic) || bytes.size() < start) {
    return Error{fmt::format("{}: is not a file of {}", name, kSchema)};
  }
  const std::size_t size = little_endian(bytes.substr(kMagic.size(), 4));
  if (size > kMaxHeader || size > bytes.size() - start) {
    return Error{fmt::format("{}: is cut off", name)};
  }
  TRY_INIT(const auto document, JsonDocument::parse(name, std::string(bytes.substr(start, size))));
  const JsonValue root(document);
  if (!root.is_object()) return root.error("must be an object");
  if (!root.has("schema") || root["schema"].json() != kSchema) {
    return root.error(fmt::format("schema is not {}", kSchema));
  }

  Policy policy;
  TRY(check_use(root, policy));
  if (root.has("decides")) {
    TRY_INIT(const std::string decides, root["decides"].one_of(all_of(kPolicyDecidesNames)));
    policy.decides = *kPolicyDecidesNames.parse(decides);
  }
  if (!root.has("steps")) return root.error("the key 'steps' is missing");
  TRY_INIT(const auto steps, read_steps(root["steps"]));
  TRY_INIT(const auto weights, read_weights(bytes.substr(start + size), name));
  const auto columns =
      policy.features->columns(soccer::kPlayersPerTeam - 1, soccer::kPlayersPerTeam);
  auto network = Network::make(static_cast<int>(columns.size()), steps, weights);
  if (!network) return Error{fmt::format("{}: {}", name, network.error().message)};
  if (network->scores() != player::kOptionCount) {
    return Error{fmt::format("{}: has {} scores, not {}, one for each option", name,
                             network->scores(), player::kOptionCount)};
  }
  policy.network = *std::move(network);
  return policy;
}

bool is_built_in_policy(std::string_view name) { return name == kPlanner || name == kRandom; }

Result<std::shared_ptr<const Policy>> read_policy(const std::string& name) {
  Policy policy;
  if (is_built_in_policy(name)) {
    policy.kind = name == kPlanner ? PolicyKind::kPlanner : PolicyKind::kRandom;
  } else {
    const auto bytes = base::read_file(name);
    if (!bytes) {
      return Error{fmt::format("{}: {}", name, base::why_no_file(name).value_or("cannot be read"))};
    }
    TRY_INIT(policy, parse_policy(*bytes, name));
  }
  return std::make_shared<const Policy>(std::move(policy));
}

}  // namespace cls::training
