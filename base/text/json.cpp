// JSON values: containers of their own, text by nlohmann-json.
#include "base/text/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "base/overloaded.h"

namespace cls::base {

struct Json::Library {
  using Document = nlohmann::ordered_json;

  static Document document_of(const Json& json) {
    return std::visit(
        Overloaded{[](const Array& list) {
                     Document array = Document::array();
                     for (const Json& one : list) array.push_back(document_of(one));
                     return array;
                   },
                   [](const Object& members) {
                     // The members are distinct: no search for each.
                     Document object = Document::object();
                     auto& all = object.get_ref<Document::object_t&>();
                     for (const auto& [key, value] : members) {
                       all.Container::emplace_back(key, document_of(value));
                     }
                     return object;
                   },
                   [](const Discarded&) { return Document(Document::value_t::discarded); },
                   [](const auto& simple) { return Document(simple); }},
        json.value_);
  }

  static Json json_of(Document& document) {
    switch (document.type()) {
      case Document::value_t::array: {
        Array list;
        list.reserve(document.size());
        for (Document& one : document) list.push_back(json_of(one));
        return Json(Value(std::move(list)));
      }
      case Document::value_t::object: {
        Object members;
        members.reserve(document.size());
        for (auto& [key, value] : document.get_ref<Document::object_t&>()) {
          members.emplace_back(key, json_of(value));
        }
        return Json(Value(std::move(members)));
      }
      case Document::value_t::string:
        return std::move(document.get_ref<std::string&>());
      case Document::value_t::boolean:
        return document.get<bool>();
      case Document::value_t::number_integer:
        return document.get<std::int64_t>();
      case Document::value_t::number_unsigned:
        return document.get<std::uint64_t>();
      case Document::value_t::number_float:
        return document.get<double>();
      case Document::value_t::null:
        return nullptr;
      case Document::value_t::binary:
      case Document::value_t::discarded:
        break;
    }
    return Json(Value(Discarded()));
  }

  static Json parse(std::string_view text, bool exceptions, bool ignore_comments) {
    bool too_deep = false;
    const auto limit = [&](int depth, Document::parse_event_t /*event*/, Document& /*value*/) {
      too_deep = too_deep || depth > kMaxDepth;
      return !too_deep;
    };
    Document document = Document::parse(text, limit, exceptions, ignore_comments);
    if (too_deep) {
      if (exceptions) throw exception("values nest too deep");
      return Json(Value(Discarded()));
    }
    return json_of(document);
  }

  /// Does with the library's value what failed, for the text of its exception.
  template <typename Operation>
  [[noreturn]] static void fail(const Json& json, Operation operation) {
    try {
      const Document document = document_of(json);
      static_cast<void>(operation(document));
    } catch (const Document::exception& error) {
      throw exception(error.what());
    }
    throw exception("unexpected JSON value");
  }
};

Json::Json() noexcept = default;
Json::Json(std::nullptr_t) noexcept {}
Json::Json(bool value) noexcept : value_(value) {}
Json::Json(double value) noexcept : value_(value) {}
Json::Json(const char* text) : value_(std::string(text)) {}
Json::Json(std::string text) : value_(std::move(text)) {}
Json::Json(std::string_view text) : value_(std::string(text)) {}
Json::Json(Value value) : value_(std::move(value)) {}

Json::Json(const Json& other) = default;
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(const Json& other) = default;
Json& Json::operator=(Json&& other) noexcept = default;
Json::~Json() = default;

Json::Json(std::initializer_list<Json> list) {
  const bool members = std::ranges::all_of(list, [](const Json& one) {
    return one.is_array() && one.size() == 2 && one.front().is_string();
  });
  if (!members) {
    value_ = Array(list);
    return;
  }
  value_ = Object();
  for (const Json& member : list) (*this)[member.front().string()] = member.back();
}

Json Json::array(std::initializer_list<Json> list) { return Json(Value(Array(list))); }

Json Json::parse(std::string_view text, bool ignore_comments) {
  try {
    return Library::parse(text, true, ignore_comments);
  } catch (const Library::Document::parse_error& error) {
    throw exception(error.what(), error.byte);
  } catch (const Library::Document::exception& error) {
    throw exception(error.what());
  }
}

Json Json::parse_or_discarded(std::string_view text) { return Library::parse(text, false, false); }

std::string Json::dump(int indent, bool ascii) const {
  return Library::document_of(*this).dump(indent, ' ', ascii,
                                          Library::Document::error_handler_t::replace);
}

std::string Json::library_version() {
  return fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                     NLOHMANN_JSON_VERSION_PATCH);
}

bool Json::is_discarded() const { return std::holds_alternative<Discarded>(value_); }
bool Json::is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }
bool Json::is_boolean() const { return std::holds_alternative<bool>(value_); }
bool Json::is_number() const { return is_number_integer() || is_number_float(); }
bool Json::is_number_integer() const {
  return std::holds_alternative<std::int64_t>(value_) ||
         std::holds_alternative<std::uint64_t>(value_);
}
bool Json::is_number_unsigned() const { return std::holds_alternative<std::uint64_t>(value_); }
bool Json::is_number_float() const { return std::holds_alternative<double>(value_); }
bool Json::is_string() const { return std::holds_alternative<std::string>(value_); }
bool Json::is_array() const { return std::holds_alternative<Array>(value_); }
bool Json::is_object() const { return std::holds_alternative<Object>(value_); }

const char* Json::type_name() const {
  return is_array() || is_object() ? (is_array() ? "array" : "object")
                                   : Library::document_of(*this).type_name();
}

template <typename Number>
Number Json::number() const {
  if (const auto* value = std::get_if<std::int64_t>(&value_)) return static_cast<Number>(*value);
  if (const auto* value = std::get_if<std::uint64_t>(&value_)) return static_cast<Number>(*value);
  if (const auto* value = std::get_if<double>(&value_)) return static_cast<Number>(*value);
  if (const auto* value = std::get_if<bool>(&value_)) return static_cast<Number>(*value);
  Library::fail(*this, [](const auto& json) { return json.template get<double>(); });
}
template double Json::number() const;
template std::int64_t Json::number() const;
template std::uint64_t Json::number() const;

const bool& Json::boolean() const {
  if (const auto* value = std::get_if<bool>(&value_)) return *value;
  Library::fail(*this, [](const auto& json) { return json.template get<bool>(); });
}

const std::string& Json::string() const {
  if (const auto* value = std::get_if<std::string>(&value_)) return *value;
  Library::fail(*this, [](const auto& json) { return json.template get<std::string>(); });
}

std::size_t Json::size() const {
  if (is_null()) return 0;
  if (const auto* list = std::get_if<Array>(&value_)) return list->size();
  if (const auto* members = std::get_if<Object>(&value_)) return members->size();
  return 1;
}

const Json* Json::find(std::string_view key) const {
  const auto* members = std::get_if<Object>(&value_);
  if (members == nullptr) return nullptr;
  const auto found = std::ranges::find(*members, key, &Member::first);
  return found == members->end() ? nullptr : &found->second;
}

const Json& Json::at(std::string_view key) const {
  if (const Json* found = find(key)) return *found;
  Library::fail(*this, [&](const auto& json) { return json.at(std::string(key)); });
}

const Json& Json::at(std::size_t index) const {
  const auto* list = std::get_if<Array>(&value_);
  if (list != nullptr && index < list->size()) return (*list)[index];
  Library::fail(*this, [&](const auto& json) { return json.at(index); });
}

const Json::Array& Json::elements() const {
  static const Array none;
  const auto* list = std::get_if<Array>(&value_);
  return list == nullptr ? none : *list;
}

const Json::Object& Json::items() const {
  static const Object none;
  const auto* members = std::get_if<Object>(&value_);
  return members == nullptr ? none : *members;
}

Json::Object& Json::members_to_change() {
  if (is_null()) value_ = Object();
  if (auto* members = std::get_if<Object>(&value_)) return *members;
  Library::fail(*this, [](auto json) { return json["member"]; });
}

Json& Json::operator[](std::string_view key) {
  Object& members = members_to_change();
  const auto found = std::ranges::find(members, key, &Member::first);
  if (found != members.end()) return found->second;
  return members.emplace_back(key, Json()).second;
}

Json& Json::back() { return std::get<Array>(value_).back(); }

void Json::push_back(Json value) {
  if (is_null()) value_ = Array();
  if (auto* list = std::get_if<Array>(&value_)) {
    list->push_back(std::move(value));
  } else {
    Library::fail(*this, [](auto json) {
      json.push_back(0);
      return json;
    });
  }
}

void Json::update(const Json& other) {
  for (const auto& [key, value] : other.items()) (*this)[key] = value;
}

void Json::erase(std::string_view key) {
  std::erase_if(members_to_change(), [&](const Member& member) { return member.first == key; });
}

bool Json::operator==(const Json& other) const {
  return Library::document_of(*this) == Library::document_of(other);
}

void PrintTo(const Json& json, std::ostream* out) { *out << json.dump(); }

}  // namespace cls::base
