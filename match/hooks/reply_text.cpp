// Formats messages field by field, and shortens lines of a debug log.
#include "match/hooks/reply_text.h"

#include <fmt/format.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "base/index.h"
#include "base/text/decimal_text.h"
#include "base/text/enum_names.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/number_text.h"
#include "player/options/option_ids.h"
#include "proxy/actions/debug_lines.h"
#include "proxy/planner/planner_messages.h"
#include "viewer/decisions/decision_texts.h"

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
  return base::json_line(base::Json(std::string(text.substr(0, kMaxText))));
}

std::string message_text(const pb::Message& message);

// `index` is negative for a field that is not repeated.
std::string value_text(const pb::Message& message, const pb::FieldDescriptor& field, int index) {
  using In = pb::Reflection;
  const In& in = *message.GetReflection();
  const auto value = [&](auto single, auto repeated) -> decltype(auto) {
    return index < 0 ? (in.*single)(message, &field) : (in.*repeated)(message, &field, index);
  };

  switch (field.cpp_type()) {
    case pb::FieldDescriptor::CPPTYPE_FLOAT:
      return number_text(value(&In::GetFloat, &In::GetRepeatedFloat));
    case pb::FieldDescriptor::CPPTYPE_DOUBLE:
      return number_text(value(&In::GetDouble, &In::GetRepeatedDouble));
    case pb::FieldDescriptor::CPPTYPE_INT32:
      return std::to_string(value(&In::GetInt32, &In::GetRepeatedInt32));
    case pb::FieldDescriptor::CPPTYPE_BOOL:
      return value(&In::GetBool, &In::GetRepeatedBool) ? "true" : "false";
    case pb::FieldDescriptor::CPPTYPE_ENUM:
      return std::to_string(value(&In::GetEnumValue, &In::GetRepeatedEnumValue));
    case pb::FieldDescriptor::CPPTYPE_STRING:
      return in_quotes(value(&In::GetString, &In::GetRepeatedString));
    case pb::FieldDescriptor::CPPTYPE_MESSAGE:
      return message_text(index < 0 ? in.GetMessage(message, &field)
                                    : in.GetRepeatedMessage(message, &field, index));
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

constexpr auto kCategories = base::enum_names<player::PlanCategory>(
    "hold", "dribble", "pass", "shoot", "clear", "move", "no_action");

constexpr char mark(bool chosen) { return chosen ? '*' : '-'; }

std::string weighed_text(const std::vector<player::WeighedOption>& options) {
  std::string text;
  for (const player::WeighedOption& option : options) {
    const player::OptionAim& aim = option.aim;
    text += fmt::format("{} {}", mark(option.chosen), player::option_text(option.id));
    if (aim.receiver != 0) text += ' ' + std::to_string(aim.receiver);
    if (aim.target) text += ' ' + point_text(aim.target->x, aim.target->y);
    text += ' ' + base::decimal_text(100.0 * option.share, 1) + '%';
    if (aim.room) text += " room " + number_text(*aim.room);
    text += '\n';
  }
  return text;
}

constexpr int kDecimals = 2;

// Letters of shapes, by how many numbers follow them.
constexpr std::string_view kShapes[] = {"", "", "pm", "cC", "lrR", "a", "tTsS"};

std::ptrdiff_t numbers_of(char letter) {
  const auto* found = std::ranges::find_if(
      kShapes, [letter](std::string_view shapes) { return shapes.find(letter) != shapes.npos; });
  return found == std::end(kShapes) ? 0 : found - std::begin(kShapes);
}

// The next word of a line, with the space before it.
std::string_view take_word(std::string_view& line) {
  const std::size_t end = line.find(' ', 1);
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(word.size());
  return word;
}

// "0,0 8 c 1.5000 2.0000 3.0000 red" is "8 c 1.5 2 3 red".
std::string shortened(std::string_view line) {
  if (line.ends_with('\n')) line.remove_suffix(1);
  take_word(line);
  std::string text(take_word(line).substr(1));
  const std::string_view letter = take_word(line);
  text += letter;
  for (std::ptrdiff_t left = numbers_of(letter.back()); left > 0; --left) {
    double value = 0.0;
    const std::string_view word = take_word(line).substr(1);
    if (base::parse_number_prefix(word, value) != word.size()) return {};  // not finite
    text += ' ' + base::decimal_text(value, kDecimals);
  }
  return text.append(line) + '\n';
}

std::string line_of(const protos::PlayerAction& action) {
  std::string line;
  if (action.has_debug_client()) {
    proxy::append_debug_text(action.debug_client().message(), {}, line);
  } else if (action.has_log()) {
    proxy::append_debug_action(action.log(), {}, line);
  }
  return line.empty() ? line : shortened(line);
}

}  // namespace

std::string action_text(const protos::PlayerAction& action) {
  const auto* field = protos::PlayerAction::descriptor()->FindFieldByNumber(action.action_case());
  if (field == nullptr) return "unknown";
  const std::string fields = fields_text(action.GetReflection()->GetMessage(action, field));
  return fields.empty() ? field->name() : field->name() + " " + fields;
}

std::string plan_text(const player::PlanChoice& choice) {
  if (!choice.weighed.empty()) return weighed_text(choice.weighed);
  const player::Plan& plan = choice.plan;
  if (plan.nodes.size() < 2) return {};

  std::map<int, double> best;  // of the sequences that begin with the node
  for (int node = 0; node < std::ssize(plan.nodes); ++node) {
    const double value = plan.nodes[base::index(node)].value;
    const auto [found, fresh] = best.emplace(plan.first_of(node), value);
    if (!fresh) found->second = std::max(found->second, value);
  }

  std::vector<std::pair<int, double>> candidates(best.begin(), best.end());
  std::ranges::stable_sort(candidates, std::greater(), &std::pair<int, double>::second);
  const bool replied = choice.chooser == player::PlanChoice::Chooser::kReplied;
  const int chosen = replied ? proxy::first_action_of(plan, choice.node) : plan.first_of(plan.best);

  std::string text;
  if (candidates.size() > kMaxCandidates) candidates.resize(kMaxCandidates);
  for (const auto& [node, value] : candidates) {
    const player::PlanAction& action = plan.nodes[base::index(node)].action;
    text += fmt::format("{} {} {} {} {}\n", mark(node == chosen), kCategories.name(action.category),
                        action.target, point_text(action.target_point.x, action.target_point.y),
                        number_text(value));
  }
  return text;
}

bool is_drawing(const protos::PlayerAction& action) {
  return action.has_log() || action.has_debug_client();
}

std::string drawings_text(const protos::PlayerActions& reply) {
  std::string text;
  for (const protos::PlayerAction& action : reply.actions()) {
    const std::string line = line_of(action);
    if (text.size() + line.size() <= viewer::kMaxDecisionText) text += line;
  }
  return text;
}

}  // namespace cls::match
