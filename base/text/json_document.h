// JSON files of users: values with their line numbers for error messages.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/text/json.h"

namespace cls::base {

/// The position of a value in its document (RFC 6901), such as "/rules/0/when".
class JsonPointer {
 public:
  JsonPointer() = default;
  JsonPointer operator/(std::string_view key) const;
  JsonPointer operator/(std::size_t index) const;
  const std::vector<std::string>& keys() const { return keys_; }
  std::string text() const;

 private:
  std::vector<std::string> keys_;
};

/// A parsed document and its text. Comments (// and /* */) are allowed.
class JsonDocument {
 public:
  /// `name` is the file name in errors. The error names line and column.
  static Result<JsonDocument> parse(std::string name, std::string text);
  /// The error names the file and the cause.
  static Result<JsonDocument> read(const std::filesystem::path& path);

  const Json& root() const { return *root_; }
  const std::string& name() const { return name_; }

  /// Line of the value at `pointer`, or of the nearest enclosing value; from 1.
  int line_of(const JsonPointer& pointer) const;

  /// "NAME:LINE: POINTER: message".
  Error error(const JsonPointer& pointer, std::string_view message) const;

 private:
  std::string name_;
  std::string text_;
  std::shared_ptr<const Json> root_;
};

/// A value and its pointer. All checks of types and keys are here, so that all errors read alike.
class JsonValue {
 public:
  JsonValue(const JsonDocument& text, const Json& value, JsonPointer pointer)
      : text_(&text), value_(&value), pointer_(std::move(pointer)) {}
  explicit JsonValue(const JsonDocument& text) : JsonValue(text, text.root(), {}) {}

  const Json& json() const { return *value_; }
  const JsonPointer& pointer() const { return pointer_; }
  const JsonDocument& text() const { return *text_; }
  int line() const { return text_->line_of(pointer_); }

  bool is_object() const;
  bool is_array() const;
  bool is_string() const;
  bool has(std::string_view key) const;
  /// The keys of an object, in the order of the file.
  std::vector<std::string> keys() const;
  /// An existing member or element.
  JsonValue operator[](std::string_view key) const;
  JsonValue operator[](std::size_t index) const;
  std::size_t size() const;

  Error error(std::string_view message) const { return text_->error(pointer_, message); }

  /// Checks that this is an object without other keys than these; the error suggests the most
  /// similar key.
  Result<void> expect_keys(const std::vector<std::string_view>& keys) const;
  Result<double> number() const;
  Result<double> number(double low, double high) const;
  Result<int> integer(int low, int high) const;
  Result<bool> boolean() const;
  Result<std::string> string() const;
  /// A string that is one of `names`; the error suggests the most similar name.
  Result<std::string> one_of(const std::vector<std::string_view>& names) const;

 private:
  const JsonDocument* text_;
  const Json* value_;
  JsonPointer pointer_;
};

}  // namespace cls::base
