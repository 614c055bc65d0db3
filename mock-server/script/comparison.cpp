// Parsing and evaluating comparisons.
#include "mock-server/script/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/index.h"
#include "base/text/suggestion.h"
#include "mock-server/script/json_parts.h"

namespace cls::mock_server {
namespace {

using base::Result;

constexpr std::array<std::string_view, 8> kOperators = {
    "==", "!=", "<", "<=", ">", ">=", "in", "between"};

Result<std::string> enum_name(const base::JsonValue& json,
                              const google::protobuf::EnumDescriptor& names) {
  TRY_INIT(const auto word, json.string());
  for (const std::string& name : {word, word + "_"}) {
    if (names.FindValueByName(name) != nullptr) return name;
  }
  return json.error(fmt::format("{} has no value '{}'{}", names.name(), word,
                                base::did_you_mean(word, value_names(names))));
}

Result<Value> operand(const base::JsonValue& json, const ValueKind& kind) {
  const auto value_of = [](const auto& parsed) -> Result<Value> {
    if (!parsed) return parsed.error();
    return Value(*parsed);
  };

  switch (kind.kind) {
    case ValueKind::Kind::kNumber:
      return value_of(json.number());
    case ValueKind::Kind::kBool:
      return value_of(json.boolean());
    case ValueKind::Kind::kString:
      return value_of(json.string());
    case ValueKind::Kind::kEnum:
      return value_of(enum_name(json, *kind.names));
    case ValueKind::Kind::kMessage:
      break;
  }
  return json.error("a message cannot be compared; use {\"present\": true}");
}

}  // namespace

std::vector<std::string_view> value_names(const google::protobuf::EnumDescriptor& type) {
  std::vector<std::string_view> names;
  for (int i = 0; i < type.value_count(); ++i) names.push_back(type.value(i)->name());
  return names;
}

std::string to_text(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:.6g}", *number);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  return std::get<std::string>(value);
}

Result<Comparison::Part> Comparison::parse_part(std::string_view word, const base::JsonValue& json,
                                                const ValueKind& kind) {
  const auto* const found = std::ranges::find(kOperators, word);
  if (found == kOperators.end()) {
    return json.error(
        fmt::format("unknown operator '{}' (known: {})", word, fmt::join(kOperators, " ")));
  }

  Part part;
  part.what = static_cast<Operator>(found - kOperators.begin());
  const bool list = part.what == Operator::kIn || part.what == Operator::kBetween;
  const bool ordered = part.what >= Operator::kLess && part.what != Operator::kIn;

  if (ordered && kind.kind != ValueKind::Kind::kNumber) {
    return json.error(fmt::format("'{}' is for numbers", word));
  }
  if (list && !json.is_array()) {
    return json.error(fmt::format("'{}' needs a list", word));
  }
  if (part.what == Operator::kBetween && json.size() != 2) {
    return json.error("'between' needs two numbers");
  }

  const auto parse_operand = [&kind](const base::JsonValue& each) { return operand(each, kind); };
  TRY_INIT(part.operands, list ? list_of(json, parse_operand) : one_of(json, parse_operand));
  return part;
}

Result<Comparison> Comparison::parse(const base::JsonValue& json, const ValueKind& kind) {
  Comparison comparison;
  if (!json.is_object()) {
    TRY_INIT(const auto part, parse_part("==", json, kind));
    comparison.parts_.push_back(part);
    return comparison;
  }

  for (const std::string& word : json.keys()) {
    TRY_INIT(const auto part, parse_part(word, json[word], kind));
    comparison.parts_.push_back(part);
  }

  if (comparison.parts_.empty()) return json.error("an empty comparison");
  return comparison;
}

bool Comparison::holds(const Part& part, const Value& value) {
  const auto& operands = part.operands;
  const auto number = [](const Value& each) { return std::get<double>(each); };

  switch (part.what) {
    case Operator::kEqual:
      return value == operands[0];
    case Operator::kUnequal:
      return value != operands[0];
    case Operator::kIn:
      return std::ranges::find(operands, value) != operands.end();
    case Operator::kLess:
      return number(value) < number(operands[0]);
    case Operator::kAtMost:
      return number(value) <= number(operands[0]);
    case Operator::kMore:
      return number(value) > number(operands[0]);
    case Operator::kAtLeast:
      return number(value) >= number(operands[0]);
    case Operator::kBetween:
      return number(operands[0]) <= number(value) && number(value) <= number(operands[1]);
  }
  return false;
}

bool Comparison::holds(const Value& value) const {
  return std::ranges::all_of(parts_, [&](const Part& part) { return holds(part, value); });
}

std::string Comparison::text() const {
  std::vector<std::string> texts;
  for (const Part& part : parts_) {
    std::vector<std::string> operands;
    for (const Value& value : part.operands) operands.push_back(to_text(value));
    texts.push_back(
        fmt::format("{} {}", kOperators[base::index(part.what)], fmt::join(operands, ", ")));
  }
  return fmt::format("{}", fmt::join(texts, " and "));
}

}  // namespace cls::mock_server
