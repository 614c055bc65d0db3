// Walks schema and document together.
#include "tests/support/json_schema.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace cls::tests {
namespace {

using json = base::Json;

bool has_type(const json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  if (type == "null") return value.is_null();
  throw std::runtime_error("unknown type " + type);
}

class Checker {
 public:
  explicit Checker(const json& root) : root_(root) {}

  void check(const json& schema, const json& value, const std::string& place) {
    for (const auto& [keyword, rule] : schema.items()) apply(keyword, rule, schema, value, place);
  }

  std::vector<std::string> errors;

 private:
  void apply(const std::string& keyword, const json& rule, const json& schema, const json& value,
             const std::string& place) {
    if (keyword == "type") {
      check_type(rule, value, place);
    } else if (keyword == "required") {
      check_required(rule, value, place);
    } else if (keyword == "properties") {
      for (const auto& [name, inner] : rule.items()) {
        if (value.is_object() && value.contains(name))
          check(inner, value[name], place + "/" + name);
      }
    } else if (keyword == "items") {
      for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
        check(rule, value[i], place + "/" + std::to_string(i));
      }
    } else if (keyword == "enum") {
      require(std::find(rule.begin(), rule.end(), value) != rule.end(), place, "not in the enum");
    } else if (keyword == "const") {
      require(value == rule, place, "not the constant");
    } else if (keyword == "pattern") {
      require(!value.is_string() ||
                  std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())),
              place, "does not match the pattern");
    } else if (keyword == "$ref") {
      check(at_reference(rule.get<std::string>()), value, place);
    } else if (keyword == "allOf") {
      for (const json& inner : rule) check(inner, value, place);
    } else if (keyword == "if") {
      Checker condition(root_);
      condition.check(rule, value, place);
      if (condition.errors.empty()) check(schema.at("then"), value, place);
    } else if (keyword != "then" && keyword != "definitions") {
      throw std::runtime_error("unknown keyword " + keyword);
    }
  }

  // "#/definitions/name" and the like.
  const json& at_reference(const std::string& reference) const {
    const json* found = &root_;
    std::istringstream keys(reference.substr(2));
    for (std::string key; std::getline(keys, key, '/');) found = &found->at(key);
    return *found;
  }

  void check_type(const json& rule, const json& value, const std::string& place) {
    const json types = rule.is_array() ? rule : json::array({rule});
    const bool fits = std::any_of(types.begin(), types.end(), [&](const json& type) {
      return has_type(value, type.get<std::string>());
    });
    require(fits, place, "must be " + rule.dump());
  }

  void check_required(const json& rule, const json& value, const std::string& place) {
    if (!value.is_object()) return;
    for (const json& name : rule) {
      require(value.contains(name.get<std::string>()), place, "lacks " + name.dump());
    }
  }

  void require(bool holds, const std::string& place, const std::string& what) {
    if (!holds) errors.push_back(place + ": " + what);
  }

  const json& root_;
};

}  // namespace

std::vector<std::string> schema_errors(const json& schema, const json& document) {
  Checker checker(schema);
  checker.check(schema, document, "");
  return checker.errors;
}

}  // namespace cls::tests
