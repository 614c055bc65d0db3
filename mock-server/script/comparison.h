// Comparisons written in JSON: 7, "PlayOn", {">=": 1, "<": 5}, {"in": [1, 2]}.
#pragma once

#include <google/protobuf/descriptor.h>

#include <string>
#include <variant>
#include <vector>

#include "base/result.h"
#include "base/text/json_document.h"

namespace cls::mock_server {

/// A number, a boolean or a string (also the name of an enum value).
using Value = std::variant<double, bool, std::string>;

std::string to_text(const Value& value);

/// In the order of the .proto file.
std::vector<std::string_view> value_names(const google::protobuf::EnumDescriptor& type);

/// Type of a field; enum values are known by name.
struct ValueKind {
  enum class Kind { kNumber, kBool, kString, kEnum, kMessage };
  Kind kind = Kind::kNumber;
  const google::protobuf::EnumDescriptor* names = nullptr;
};

/// All of its parts must hold. Operators: ==, !=, <, <=, >, >=, in, between (both ends included);
/// a value alone means ==. Enum names may leave out the trailing underscore.
class Comparison {
 public:
  /// The error names the JSON path, and suggests an operator or names the expected type.
  static base::Result<Comparison> parse(const base::JsonValue& json, const ValueKind& kind);
  /// For numbers outside messages.
  static base::Result<Comparison> parse_number(const base::JsonValue& json) {
    return parse(json, {});
  }

  bool holds(const Value& value) const;

  /// "== 7", ">= 1 and < 5".
  std::string text() const;

 private:
  enum class Operator { kEqual, kUnequal, kLess, kAtMost, kMore, kAtLeast, kIn, kBetween };
  struct Part {
    Operator what = Operator::kEqual;
    std::vector<Value> operands;
  };
  static base::Result<Part> parse_part(std::string_view word, const base::JsonValue& json,
                                       const ValueKind& kind);
  static bool holds(const Part& part, const Value& value);

  std::vector<Part> parts_;
};

}  // namespace cls::mock_server
