// Parsing with positions: a small walk over the text finds the line of a pointer.
#include "base/text/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/text/suggestion.h"

namespace cls::base {
namespace {

// Moves over the text of a document that is known to be valid.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  std::size_t position() const { return at_; }

  void skip_space() {
    while (at_ < text_.size()) {
      if (std::strchr(" \t\r\n", text_[at_]) != nullptr) {
        ++at_;
      } else if (text_.substr(at_, 2) == "//") {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (text_.substr(at_, 2) == "/*") {
        at_ = std::min(text_.find("*/", at_), text_.size() - 2) + 2;
      } else {
        return;
      }
    }
  }

  // Into the member or element `key` of the value here; false when there is none.
  bool enter(const std::string& key) {
    const std::size_t start = at_;
    const char open = text_[at_];
    if (open != '{' && open != '[') return false;
    ++at_;
    for (std::size_t index = 0;; ++index) {
      skip_space();
      if (text_[at_] == '}' || text_[at_] == ']') break;
      std::string found = std::to_string(index);
      if (open == '{') {
        const std::size_t from = at_;
        skip_string();
        found = Json::parse(text_.substr(from, at_ - from)).get<std::string>();
        skip_space();
        ++at_;  // the colon
        skip_space();
      }
      if (found == key) return true;
      skip_value();
      skip_space();
      if (text_[at_] == ',') ++at_;
    }
    at_ = start;
    return false;
  }

 private:
  void skip_string() {
    for (++at_; text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    ++at_;
  }

  void skip_value() {
    int depth = 0;
    do {
      skip_space();
      const char c = text_[at_];
      if (c == '"') {
        skip_string();
      } else if (c == '{' || c == '[') {
        ++depth;
        ++at_;
      } else if (c == '}' || c == ']') {
        --depth;
        ++at_;
      } else if (c == ',' || c == ':') {
        ++at_;
      } else {
        while (at_ < text_.size() && std::strchr(",:]} \t\r\n/", text_[at_]) == nullptr) ++at_;
      }
    } while (depth > 0);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

int line_at(std::string_view text, std::size_t position) {
  return 1 + static_cast<int>(
                 std::count(text.begin(), text.begin() + static_cast<long>(position), '\n'));
}

}  // namespace

JsonPlace JsonPlace::operator/(std::string_view key) const {
  JsonPlace place = *this;
  place.keys_.emplace_back(key);
  return place;
}

JsonPlace JsonPlace::operator/(std::size_t index) const { return *this / std::to_string(index); }

std::string JsonPlace::text() const {
  std::string text;
  for (const std::string& key : keys_) {
    text += '/';
    for (const char c : key) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  }
  return text;
}

Result<JsonText> JsonText::parse(std::string name, std::string text) {
  JsonText result;
  result.name_ = std::move(name);
  result.text_ = std::move(text);
  try {
    result.root_ = std::make_shared<const Json>(Json::parse(result.text_, nullptr, true, true));
  } catch (const Json::parse_error& error) {
    const std::size_t position =
        std::min(error.byte == 0 ? 0 : error.byte - 1, result.text_.size());
    const std::size_t line_start = result.text_.rfind('\n', position == 0 ? 0 : position - 1);
    const std::size_t column =
        position - (line_start == std::string::npos ? 0 : line_start + 1) + 1;
    std::string what = error.what();
    if (const auto colon = what.rfind(": "); colon != std::string::npos) {
      what = what.substr(
          what.find("syntax error") == std::string::npos ? colon + 2 : what.find("syntax error"));
    }
    return Error{
        fmt::format("{}:{}:{}: {}", result.name_, line_at(result.text_, position), column, what)};
  }
  return result;
}

Result<JsonText> JsonText::read(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) {
    return Error{fmt::format("{}: is a folder", path.string())};
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{fmt::format("{}: {}", path.string(), std::strerror(errno))};
  return parse(path.string(), {std::istreambuf_iterator<char>(file), {}});
}

int JsonText::line_of(const JsonPlace& place) const {
  Walk walk(text_);
  walk.skip_space();
  for (const std::string& key : place.keys()) {
    if (!walk.enter(key)) break;
  }
  return line_at(text_, walk.position());
}

Error JsonText::error(const JsonPlace& place, std::string_view message) const {
  const std::string where = place.text();
  return Error{fmt::format("{}:{}: {}{}{}", name_, line_of(place), where, where.empty() ? "" : ": ",
                           message)};
}

bool JsonValue::is_object() const { return value_->is_object(); }
bool JsonValue::is_list() const { return value_->is_array(); }
bool JsonValue::is_string() const { return value_->is_string(); }
bool JsonValue::has(std::string_view key) const { return value_->contains(std::string(key)); }
std::size_t JsonValue::size() const { return value_->size(); }

std::vector<std::string> JsonValue::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, unused] : value_->items()) keys.push_back(key);
  return keys;
}

JsonValue JsonValue::operator[](std::string_view key) const {
  return {*text_, value_->at(std::string(key)), place_ / key};
}

JsonValue JsonValue::operator[](std::size_t index) const {
  return {*text_, value_->at(index), place_ / index};
}

Result<void> JsonValue::object_of(const std::vector<std::string_view>& keys) const {
  if (!value_->is_object()) {
    return error(fmt::format("must be an object, not {}", value_->type_name()));
  }
  for (const auto& [key, unused] : value_->items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    std::string message = fmt::format("unknown key '{}'", key);
    const std::string hint = did_you_mean(key, keys);
    message += hint.empty() ? fmt::format(" (known: {})", fmt::join(keys, ", ")) : hint;
    return text_->error(place_ / key, message);
  }
  return {};
}

Result<double> JsonValue::number() const {
  if (!value_->is_number()) {
    return error(fmt::format("must be a number, not {}", value_->dump()));
  }
  return value_->get<double>();
}

Result<double> JsonValue::number(double low, double high) const {
  const auto value = number();
  if (!value) return value.error();
  if (!(*value >= low && *value <= high)) {
    return error(fmt::format("{} is not within {} to {}", value_->dump(), low, high));
  }
  return *value;
}

Result<int> JsonValue::integer(int low, int high) const {
  if (!value_->is_number_integer()) {
    return error(fmt::format("must be a whole number, not {}", value_->dump()));
  }
  const auto value = number(low, high);
  if (!value) return value.error();
  return static_cast<int>(*value);
}

Result<bool> JsonValue::boolean() const {
  if (!value_->is_boolean()) {
    return error(fmt::format("must be true or false, not {}", value_->dump()));
  }
  return value_->get<bool>();
}

Result<std::string> JsonValue::string() const {
  if (!value_->is_string()) {
    return error(fmt::format("must be a string, not {}", value_->dump()));
  }
  return value_->get<std::string>();
}

Result<std::string> JsonValue::word(const std::vector<std::string_view>& words) const {
  auto value = string();
  if (!value) return value;
  if (std::find(words.begin(), words.end(), *value) != words.end()) return value;
  const std::string hint = did_you_mean(*value, words);
  return error(
      fmt::format("unknown '{}'{}", *value,
                  hint.empty() ? fmt::format(" (known: {})", fmt::join(words, ", ")) : hint));
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& names) {
  std::string_view near = nearest_name(word, names);
  for (const std::string_view name : names) {
    if (near.empty() && !word.empty() && name.starts_with(word)) near = name;
  }
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

}  // namespace cls::base
