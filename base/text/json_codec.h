// Writes and parses JSON objects from one list of their members.
//
// Both codecs take the same calls, so one function template lists the members of a type T:
//
//   template <typename Codec>
//   static void members(Codec& codec, typename Codec::template Object<T>& object) {
//     codec.required("index", object.index);
//     codec.member("players", object.players);  // nested types have a members() of their own
//   }
//
// members() is found by argument-dependent lookup, so it must not be in an unnamed namespace.
#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/text/json.h"
#include "base/text/schema.h"

namespace cls::base {

/// Appends members in the order of the calls.
class JsonEncoder {
 public:
  template <typename T>
  using Object = const T;

  explicit JsonEncoder(Json& json) : json_(json) {}

  template <typename T>
  void member(const char* key, const T& value) {
    json_[key] = encode(value);
  }
  template <typename T>
  void required(const char* key, const T& value) {
    member(key, value);
  }

  /// A number with at most log10(per_one) decimals. Division by `per_one` prints as 83.3, where
  /// multiplication by its inverse would print as 83.30000001.
  void rounded(const char* key, double value, double per_one) {
    json_[key] = std::round(value * per_one) / per_one;
  }
  void rounded(const char* key, const std::optional<double>& value, double per_one) {
    json_[key] = nullptr;
    if (value) rounded(key, *value, per_one);
  }

  /// A string; null when it is empty.
  void text_or_null(const char* key, const std::string& value) {
    json_[key] = value.empty() ? Json(nullptr) : Json(value);
  }
  /// A number; null when it is 0.
  void number_or_null(const char* key, int value) {
    json_[key] = value == 0 ? Json(nullptr) : Json(value);
  }
  /// [first, second]; null when either is missing.
  void pair(const char* key, int first, int second) { json_[key] = {first, second}; }
  void pair(const char* key, const std::optional<int>& first, const std::optional<int>& second) {
    json_[key] = nullptr;
    if (first && second) pair(key, *first, *second);
  }

  /// An enumerator by its name.
  template <typename T, typename Format, typename Parse>
  void named(const char* key, const T& value, Format format, Parse /*parse*/) {
    json_[key] = format(value);
  }
  template <typename T, typename Format, typename Parse>
  void named(const char* key, const std::optional<T>& value, Format format, Parse /*parse*/) {
    json_[key] = value ? Json(format(*value)) : Json(nullptr);
  }

  /// A member that follows from others: written, not parsed.
  template <typename Compute>
  void derived(const char* key, Compute compute) {
    json_[key] = compute();
  }
  /// The schema of the document; versions up to this one are read.
  void schema(const char* key, const char* value) { json_[key] = value; }

  /// A nested object; `list_members` is called with its codec.
  template <typename ListMembers>
  void object(const char* key, ListMembers list_members) {
    Json inner = Json::object();
    JsonEncoder codec(inner);
    list_members(codec);
    json_[key] = std::move(inner);
  }

  template <typename T>
  static Json encode(const T& value) {
    if constexpr (std::is_constructible_v<Json, const T&>) {
      return Json(value);
    } else {
      Json json = Json::object();
      JsonEncoder codec(json);
      members(codec, value);
      return json;
    }
  }
  template <typename T>
  static Json encode(const std::optional<T>& value) {
    return value ? encode(*value) : Json(nullptr);
  }
  template <typename T>
  static Json encode(const std::vector<T>& values) {
    Json list = Json::array();
    for (const T& value : values) list.push_back(encode(value));
    return list;
  }

 private:
  Json& json_;
};

/// Parses members. A missing member leaves its field unchanged unless it is required, so documents
/// of earlier versions can be read. Wrong types and values throw an exception derived from
/// std::exception.
class JsonDecoder {
 public:
  template <typename T>
  using Object = T;

  explicit JsonDecoder(const Json& json) : json_(json) {
    if (!json.is_object()) throw std::invalid_argument("not a JSON object");
  }

  template <typename T>
  void member(const char* key, T& value) {
    if (const Json* found = json_.find(key)) decode(*found, value);
  }
  template <typename T>
  void required(const char* key, T& value) {
    decode(json_.at(key), value);
  }

  template <typename T>
  void rounded(const char* key, T& value, double /*per_one*/) {
    member(key, value);
  }
  void text_or_null(const char* key, std::string& value) {
    const Json* found = json_.find(key);
    if (found != nullptr) value = found->is_null() ? "" : found->get<std::string>();
  }
  void number_or_null(const char* key, int& value) {
    const Json* found = json_.find(key);
    if (found == nullptr) return;
    value = 0;
    if (!found->is_null()) decode(*found, value);
  }
  template <typename T>
  void pair(const char* key, T& first, T& second) {
    const Json* found = json_.find(key);
    if (found == nullptr || found->is_null()) return;
    decode(found->at(0), first);
    decode(found->at(1), second);
  }

  template <typename T, typename Format, typename Parse>
  void named(const char* key, T& value, Format /*format*/, Parse parse) {
    value = parsed(key, json_.at(key), parse);
  }
  template <typename T, typename Format, typename Parse>
  void named(const char* key, std::optional<T>& value, Format /*format*/, Parse parse) {
    const Json* found = json_.find(key);
    value.reset();
    if (found != nullptr && !found->is_null()) value = parsed(key, *found, parse);
  }

  template <typename Compute>
  void derived(const char* /*key*/, Compute /*compute*/) {}
  void schema(const char* key, const char* value) {
    const Json& found = json_.at(key);
    const auto error = schema_error(found.is_string() ? found.get<std::string>() : "", value);
    if (error) throw std::invalid_argument(*error);
  }

  template <typename ListMembers>
  void object(const char* key, ListMembers list_members) {
    const Json* found = json_.find(key);
    if (found == nullptr) return;
    JsonDecoder codec(*found);
    list_members(codec);
  }

  template <typename T>
  static void decode(const Json& json, T& value) {
    if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
      // Converting a floating-point number that does not fit is undefined.
      if (json.is_number_float() && !fits<T>(json.get<double>())) {
        throw std::out_of_range("a number is out of range");
      }
    }

    if constexpr (std::is_constructible_v<Json, const T&>) {
      value = json.get<T>();
    } else {
      JsonDecoder codec(json);
      members(codec, value);
    }
  }
  template <typename T>
  static void decode(const Json& json, std::optional<T>& value) {
    value.reset();
    if (!json.is_null()) decode(json, value.emplace());
  }
  template <typename T>
  static void decode(const Json& json, std::vector<T>& values) {
    values.clear();
    for (const Json& element : json) decode(element, values.emplace_back());
  }
  template <typename T>
  static void decode(const Json& json, std::map<std::string, T>& values) {
    if (!json.is_object()) throw std::invalid_argument("not a JSON object");
    values.clear();
    for (const auto& [key, element] : json.items()) decode(element, values[key]);
  }

 private:
  /// Tells whether `number` without its fraction fits into a T; NaN does not.
  template <typename T>
  static bool fits(double number) {
    using Limits = std::numeric_limits<T>;
    const double lowest = static_cast<double>(Limits::min());
    const double end = 2.0 * static_cast<double>(Limits::max() / 2 + 1);
    return number > lowest - 1.0 && number < end;
  }

  template <typename Parse>
  static auto parsed(const char* key, const Json& json, Parse parse) {
    const auto text = json.get<std::string>();
    const auto value = parse(text);
    if (!value) throw std::invalid_argument(std::string(key) + ": unknown value '" + text + "'");
    return *value;
  }

  const Json& json_;
};

}  // namespace cls::base
