// Facts about parameter fields, from the server's parameter tables.
#pragma once

#include <string>
#include <string_view>

namespace cls::cli {

/// Empty where the tables do not say it.
struct ParameterFacts {
  std::string unit;
  std::string default_value;  ///< of a match without settings; numbers and bool
  std::string setting;        ///< NAME of `--set server::NAME=VALUE`, where it is another name
  std::string effect;
};

/// True for ServerParam, PlayerParam and PlayerType.
bool is_parameter_message(std::string_view message);

/// The facts about a field of ServerParam, PlayerParam or PlayerType.
ParameterFacts parameter_facts(const std::string& message, const std::string& field);

}  // namespace cls::cli
