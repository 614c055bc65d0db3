// Formats messages field by field.
#include "match/hooks/action_text.h"

#include <fmt/format.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/decimal_text.h"
#include "base/text/json_text.h"
#include "proxy/planner/planner_messages.h"

namespace cls::match {
namespace {

namespace pb = google::protobuf;

constexpr std::size_t kMaxText = 120;
constexpr std::size_t kMaxCandidates = 8;

// Three digits: 123, 12.3, 1.23, 0.123.
std::string number_text(double value) {
  const double size = std::abs(value);
  return base::decimal_text(value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3);
}

std::string point_text(double x, double y) {
  return fmt::format("({}, {})", number_text(x), number_text(y));
}

std::string in_quotes(std::string_view text) {
  return base::json_line(nlohmann::json(std::string(text.substr(0, kMaxText))));
}

std::string message_text(const pb::Message& message);

// `index` is negative for a field that is not repeated.
std::string value_text(const pb::Message& message, const pb::FieldDescriptor& field, int index) {
  const pb::Reflection& in = *message.GetReflection();
  const bool repeated = index >= 0;
  switch (field.cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_FLOAT:
      return number_text(repeated ? in.GetRepeatedFloat(message, &field, index)
                                  : in.GetFloat(message, &field));
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return number_text(repeated ? in.GetRepeatedDouble(message, &field, index)
                                  : in.GetDouble(message, &field));
    case pb::FieldDescriptor::CPPTYPE_INT32:
      return std::to_string(repeated ? in.GetRepeatedInt32(message, &field, index)
                                     : in.GetInt32(message, &field));
    case pb::FieldDescriptor::CPPTYPE_BOOL:
      return (repeated ? in.GetRepeatedBool(message, &field, index) : in.GetBool(message, &field))
                 ? "true"
                 : "false";
    case pb::FieldDescriptor::CPPTYPE_ENUM:
      return std::to_string(repeated ? in.GetRepeatedEnumValue(message, &field, index)
                                     : in.GetEnumValue(message, &field));
    case pb::FieldDescriptor::CPPTYPE_STRING:
      return in_quotes(repeated ? in.GetRepeatedString(message, &field, index)
                                : in.GetString(message, &field));
    case pb::FieldDescriptor::CPPTYPE_MESSAGE:
      return message_text(repeated ? in.GetRepeatedMessage(message, &field, index)
                                   : in.GetMessage(message, &field));
    default:
      return "?";
  }
}

std::string field_text(const pb::Message& message, const pb::FieldDescriptor& field) {
  if (!field.is_repeated()) {
    if (field.cpp_type() != pb::FieldDescriptor::CPPTYPE_ENUM)
      return value_text(message, field, -1);
    const int value = message.GetReflection()->GetEnumValue(message, &field);
    const auto* known = field.enum_type()->FindValueByNumber(value);
    return known == nullptr ? std::to_string(value) : known->name();
  }
  std::string text = "[";
  const int size = message.GetReflection()->FieldSize(message, &field);
  for (int i = 0; i < size && text.size() < kMaxText; ++i) {
    text += (i == 0 ? "" : ", ") + value_text(message, field, i);
  }
  return text + "]";
}

// The fields that are set, in the order of the interface.
std::string fields_text(const pb::Message& message) {
  std::string text;
  std::vector<const pb::FieldDescriptor*> fields;
  message.GetReflection()->ListFields(message, &fields);
  for (const pb::FieldDescriptor* field : fields) {
    text +=
        fmt::format("{}{}={}", text.empty() ? "" : " ", field->name(), field_text(message, *field));
  }
  return text;
}

std::string message_text(const pb::Message& message) {
  if (message.GetDescriptor() == protos::RpcVector2D::descriptor()) {
    const auto& vector = static_cast<const protos::RpcVector2D&>(message);
    return point_text(vector.x(), vector.y());
  }
  return "{" + fields_text(message) + "}";
}

std::string_view category_name(player::PlanCategory category) {
  constexpr std::array<std::string_view, 7> kNames = {"hold",  "dribble", "pass",     "shoot",
                                                      "clear", "move",    "no_action"};
  return kNames.at(static_cast<std::size_t>(category));
}

}  // namespace

std::string action_text(const protos::PlayerAction& action) {
  const auto* field = protos::PlayerAction::descriptor()->FindFieldByNumber(action.action_case());
  if (field == nullptr) return "unknown";
  const std::string fields = fields_text(action.GetReflection()->GetMessage(action, field));
  return fields.empty() ? field->name() : field->name() + " " + fields;
}

std::string plan_text(const player::PlanChoice& choice) {
  const player::Plan& plan = choice.plan;
  if (plan.nodes.size() < 2) return {};
  std::map<int, double> best;  // of the sequences that begin with the node
  for (int node = 0; node < static_cast<int>(plan.nodes.size()); ++node) {
    const double value = plan.nodes[static_cast<std::size_t>(node)].value;
    const auto [found, fresh] = best.emplace(plan.first_of(node), value);
    if (!fresh) found->second = std::max(found->second, value);
  }
  std::vector<std::pair<int, double>> candidates(best.begin(), best.end());
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  const bool replied = choice.chooser == player::PlanChoice::Chooser::kReplied;
  const int chosen = replied ? proxy::first_action_of(plan, choice.node) : plan.first_of(plan.best);
  std::string text;
  for (std::size_t i = 0; i < std::min(candidates.size(), kMaxCandidates); ++i) {
    const auto [node, value] = candidates[i];
    const player::PlanAction& action = plan.nodes[static_cast<std::size_t>(node)].action;
    text +=
        fmt::format("{} {} {} {} {}\n", node == chosen ? '*' : '-', category_name(action.category),
                    action.target, point_text(action.target_point.x, action.target_point.y),
                    number_text(value));
  }
  return text;
}

}  // namespace cls::match
