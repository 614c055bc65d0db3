// A JSON file of a user: what it says, and in which line, for errors that can be found.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::base {

using Json = nlohmann::ordered_json;

/// The place of a value in its file: a JSON pointer such as "/rules/0/when".
class JsonPlace {
 public:
  JsonPlace() = default;
  JsonPlace operator/(std::string_view key) const;
  JsonPlace operator/(std::size_t index) const;
  const std::vector<std::string>& keys() const { return keys_; }
  std::string text() const;

 private:
  std::vector<std::string> keys_;
};

/// A document and its text. Comments (// and /* */) are allowed.
class JsonText {
 public:
  /// `name` is what errors call it: a file name. The error names line and column.
  static Result<JsonText> parse(std::string name, std::string text);
  /// The error says why the file cannot be read.
  static Result<JsonText> read(const std::filesystem::path& path);

  const Json& root() const { return *root_; }
  const std::string& name() const { return name_; }

  /// Line of the value at that place, or of the nearest one around it; from 1.
  int line_of(const JsonPlace& place) const;

  /// "NAME:LINE: PLACE: message".
  Error error(const JsonPlace& place, std::string_view message) const;

 private:
  std::string name_;
  std::string text_;
  std::shared_ptr<const Json> root_;
};

/// Walking a document: a value and where it is. All checks of kind and key are here, so that every
/// mistake is told in the same way.
class JsonValue {
 public:
  JsonValue(const JsonText& text, const Json& value, JsonPlace place)
      : text_(&text), value_(&value), place_(std::move(place)) {}
  explicit JsonValue(const JsonText& text) : JsonValue(text, text.root(), {}) {}

  const Json& json() const { return *value_; }
  const JsonPlace& place() const { return place_; }
  const JsonText& text() const { return *text_; }
  int line() const { return text_->line_of(place_); }

  bool is_object() const;
  bool is_list() const;
  bool is_string() const;
  bool has(std::string_view key) const;
  /// Of an object, in the order of the file.
  std::vector<std::string> keys() const;
  /// A member or element that exists.
  JsonValue operator[](std::string_view key) const;
  JsonValue operator[](std::size_t index) const;
  std::size_t size() const;

  Error error(std::string_view message) const { return text_->error(place_, message); }

  /// An object that has no other keys than these; the error suggests the one that may be meant.
  Result<void> object_of(const std::vector<std::string_view>& keys) const;
  Result<double> number() const;
  Result<double> number(double low, double high) const;
  Result<int> integer(int low, int high) const;
  Result<bool> boolean() const;
  Result<std::string> string() const;
  /// One of these words.
  Result<std::string> word(const std::vector<std::string_view>& words) const;

 private:
  const JsonText* text_;
  const Json* value_;
  JsonPlace place_;
};

/// "; did you mean 'x'?", or nothing when no name is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& names);

}  // namespace cls::base
