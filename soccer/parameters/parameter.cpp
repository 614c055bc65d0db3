// Parsing of parameter values.
#include "soccer/parameters/parameter.h"

#include <cmath>
#include <limits>

#include "base/text/value_text.h"

namespace cls::soccer {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

base::Error type_error(std::string_view type, std::string_view text) {
  return base::Error{"'" + std::string(text) + "' is not " + std::string(type)};
}

}  // namespace

namespace detail {

base::Result<void> assign(double& value, std::string_view text) {
  const auto read = base::value_of<double>(text.starts_with('+') ? text.substr(1) : text);
  if (!read) return type_error("a number", text);
  value = *read;
  return {};
}

base::Result<void> assign(int& value, std::string_view text) {
  double read = 0.0;
  if (!assign(read, text) || read != std::rint(read) || read < std::numeric_limits<int>::min() ||
      read > std::numeric_limits<int>::max()) {
    return type_error("a whole number", text);
  }
  value = static_cast<int>(read);
  return {};
}

base::Result<void> assign(bool& value, std::string_view text) {
  const std::string token = lower(text);
  const bool on = token == "on" || token == "true" || token == "1";
  if (!on && token != "off" && token != "false" && token != "0") {
    return type_error("on or off", text);
  }
  value = on;
  return {};
}

base::Result<void> assign(std::string& value, std::string_view text) {
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
      text.back() == text.front()) {
    text = text.substr(1, text.size() - 2);
  }
  value = text;
  return {};
}

}  // namespace detail
}  // namespace cls::soccer
