// Looks fields up in the messages of a match with default parameters.
#include "cli/explain/parameter_facts.h"

#include <fmt/format.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <array>
#include <utility>
#include <variant>

#include "proxy/messages/parameter_messages.h"

namespace cls::cli {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

protos::ServerParam default_server() {
  protos::ServerParam message;
  proxy::fill(soccer::ServerParams{}, message);
  return message;
}

protos::PlayerParam default_players() {
  protos::PlayerParam message;
  proxy::fill(soccer::PlayerParams{}, message);
  return message;
}

protos::PlayerType default_type() {
  protos::PlayerType message;
  const soccer::ServerParams server;
  proxy::fill(soccer::default_player_type(server), server, message);
  return message;
}

std::string value_of(const Message& message, const std::string& name) {
  const FieldDescriptor* field = message.GetDescriptor()->FindFieldByName(name);
  if (field == nullptr) return {};

  const auto& reflection = *message.GetReflection();
  switch (field->cpp_type()) {
    case FieldDescriptor::CPPTYPE_FLOAT:
      return fmt::format("{:.6g}", reflection.GetFloat(message, field));
    case FieldDescriptor::CPPTYPE_INT32:
      return fmt::to_string(reflection.GetInt32(message, field));
    case FieldDescriptor::CPPTYPE_BOOL:
      return fmt::to_string(reflection.GetBool(message, field));
    default:
      return {};
  }
}

// The tables abbreviate.
std::string spelled_out(std::string_view unit) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kUnits = {
      {{"cyc", "cycles"},
       {"/cyc", "1 per cycle"},
       {"m/cyc", "m per cycle"},
       {"m/cyc2", "m per cycle^2"},
       {"deg", "degrees"},
       {"chars", "characters"}}};

  for (const auto& [abbreviation, text] : kUnits) {
    if (unit == abbreviation) return std::string(text);
  }
  return std::string(unit);
}

template <typename Params>
void add_row(const soccer::ParameterTable<Params>& table, std::string_view space,
             const std::string& field, ParameterFacts& facts) {
  const std::string_view name = proxy::server_parameter_of(field);
  const auto* row = soccer::find_parameter(table, name);
  if (row == nullptr) return;

  const bool is_number = std::holds_alternative<double Params::*>(row->member) ||
                         std::holds_alternative<int Params::*>(row->member);

  facts.unit = is_number && row->unit.empty() ? "1" : spelled_out(row->unit);
  facts.effect = row->effect;
  if (name != field) facts.setting = fmt::format("{}::{}", space, name);
}

}  // namespace

bool is_parameter_message(std::string_view message) {
  return message == "ServerParam" || message == "PlayerParam" || message == "PlayerType";
}

ParameterFacts parameter_facts(const std::string& message, const std::string& field) {
  ParameterFacts facts;
  if (message == "ServerParam") {
    static const protos::ServerParam defaults = default_server();
    facts.default_value = value_of(defaults, field);
    add_row(soccer::server_param_table(), "server", field, facts);
  } else if (message == "PlayerParam") {
    static const protos::PlayerParam defaults = default_players();
    facts.default_value = value_of(defaults, field);
    add_row(soccer::player_param_table(), "player", field, facts);
  } else {
    static const protos::PlayerType defaults = default_type();
    facts.default_value = value_of(defaults, field);
  }
  return facts;
}

}  // namespace cls::cli
