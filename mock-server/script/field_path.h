// Path to a field of a message, as users write it: "ball.position.x".
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "mock-server/script/comparison.h"

namespace cls::mock_server {

/// The field with this name in the .proto file or in lowerCamelCase; null: there is none.
const google::protobuf::FieldDescriptor* find_field(const google::protobuf::Descriptor& type,
                                                    std::string_view name);

/// "Ball has no field 'positon'; did you mean 'position'?".
std::string no_such_field(const google::protobuf::Descriptor& type, std::string_view name);

/// Fields are separated by dots and named as in the .proto file or in lowerCamelCase. After a list:
/// an index from 0, `*` (any of them) or `size`; after a map: a key, `*` or `size`. A path into a
/// State may begin inside its world_model: "self.stamina" is "world_model.self.stamina".
class FieldPath {
 public:
  /// The error is one line without location; it suggests a field.
  static base::Result<FieldPath> compile(const google::protobuf::Descriptor& root,
                                         std::string_view text);

  const std::string& text() const { return text_; }
  const ValueKind& kind() const { return kind_; }

  /// Values at the path: none when an index or key does not exist, several for `*`. Unset fields
  /// have their default value. Not for paths that end at a message.
  std::vector<Value> values(const google::protobuf::Message& message) const {
    return find(message).values;
  }

  /// True when the last field is set: an existing message, list element or map element.
  bool present(const google::protobuf::Message& message) const { return find(message).present; }

 private:
  enum class Select { kField, kIndex, kKey, kAny, kSize };
  struct Step {
    const google::protobuf::FieldDescriptor* field = nullptr;
    Select select = Select::kField;
    int number = 0;  ///< index or key
  };

  static base::Result<Step> compile_step(const google::protobuf::Descriptor& type,
                                         std::string_view name, std::string_view selector);
  struct Found {
    bool present = false;
    std::vector<Value> values;
  };
  Found find(const google::protobuf::Message& message) const;
  void collect(const google::protobuf::Message& message, std::size_t step, Found& found) const;
  void collect_elements(const google::protobuf::Message& message, std::size_t step,
                        Found& found) const;

  std::string text_;
  std::vector<Step> steps_;
  ValueKind kind_;
};

/// A path and the comparison that its value must satisfy.
class Condition {
 public:
  /// `json` is the value of the path: a comparison, or {"present": true}.
  static base::Result<Condition> parse(const google::protobuf::Descriptor& root,
                                       std::string_view path, const base::JsonValue& json);
  /// With `*`, one matching value is sufficient.
  bool holds(const google::protobuf::Message& message) const;

  /// "ball.position.x is 3.5, not > 10".
  std::string complaint(const google::protobuf::Message& message) const;

 private:
  FieldPath path_;
  std::optional<bool> present_;
  Comparison comparison_;
};

/// An object of paths and comparisons.
base::Result<std::vector<Condition>> parse_conditions(const google::protobuf::Descriptor& root,
                                                      const base::JsonValue& json);

}  // namespace cls::mock_server
