// Checks of values, and the line of a JSON pointer, found by a scan of the text.
#include "base/text/json_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "base/text/byte_order_mark.h"
#include "base/text/suggestion.h"

namespace cls::base {
namespace {

// Scans the text of a valid document.
class Scan {
 public:
  explicit Scan(std::string_view text) : text_(text) {}

  std::size_t position() const { return at_; }

  // Comments begin and end where nlohmann's parser has them begin and end.
  void skip_space() {
    using namespace std::string_view_literals;
    for (;;) {
      if (is_one_of(kSpace)) {
        ++at_;
      } else if (text_.substr(at_, 2) == "//") {
        skip_through(text_.find_first_of("\n\r\0"sv, at_), 1);
      } else if (text_.substr(at_, 2) == "/*") {
        skip_through(text_.find("*/", at_ + 2), 2);
      } else {
        return;
      }
    }
  }

  // Moves to the member or element `key` of the current value; false if there is none.
  bool enter(const std::string& key) {
    const std::size_t start = at_;
    if (!is_one_of("{[")) return false;

    const bool object = text_[at_] == '{';
    ++at_;
    skip_space();
    for (std::size_t index = 0; !at_end() && !is_one_of("}]"); ++index) {
      if ((object ? take_key() : std::to_string(index)) == key) return true;
      skip_value();
      skip_space();
      if (is_one_of(",")) ++at_;
      skip_space();
    }

    at_ = start;
    return false;
  }

 private:
  static constexpr std::string_view kSpace = " \t\r\n";

  bool at_end() const { return at_ == text_.size(); }

  bool is_one_of(std::string_view characters) const {
    return !at_end() && characters.find(text_[at_]) != std::string_view::npos;
  }

  // `position` may be npos.
  void skip_through(std::size_t position, std::size_t length) {
    at_ = position < text_.size() ? std::min(position + length, text_.size()) : text_.size();
  }

  // Moves behind a key and its colon.
  std::string take_key() {
    const std::size_t from = at_;
    skip_string();
    const Json key = Json::parse_or_discarded(text_.substr(from, at_ - from));

    skip_space();
    if (is_one_of(":")) ++at_;
    skip_space();
    return key.is_string() ? key.get<std::string>() : "";
  }

  void skip_string() {
    std::size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != '"') end += text_[end] == '\\' ? 2 : 1;
    skip_through(end, 1);
  }

  void skip_value() {
    int depth = 0;
    do {
      skip_space();
      if (is_one_of("\"")) {
        skip_string();
        continue;
      }

      depth += is_one_of("{[") ? 1 : is_one_of("}]") ? -1 : 0;
      if (is_one_of("{[}],:")) {
        ++at_;
      } else {
        skip_through(text_.find_first_of(",:]} \t\r\n/", at_ + 1), 0);
      }
    } while (depth > 0 && !at_end());
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

int line_at(std::string_view text, std::size_t position) {
  return 1 + static_cast<int>(
                 std::count(text.begin(), text.begin() + static_cast<long>(position), '\n'));
}

// "NAME:LINE:COLUMN: cause".
Error parse_error(const std::string& name, std::string_view text, const Json::exception& error) {
  const std::string what = error.what();

  // "... number overflow parsing '1e999'"
  if (what.find("number overflow") != std::string::npos) {
    const std::size_t quote = what.find('\'');
    const std::string number = what.substr(quote + 1, what.rfind('\'') - quote - 1);
    return Error{fmt::format("{}:{}: the number {} is too large", name,
                             line_at(text, std::min(text.find(number), text.size())), number)};
  }

  const std::size_t position = std::min(error.byte == 0 ? 0 : error.byte - 1, text.size());
  const std::size_t line_start = text.rfind('\n', position == 0 ? 0 : position - 1);
  const std::size_t column =
      position - (line_start == std::string_view::npos ? 0 : line_start + 1) + 1;
  const std::size_t syntax = what.find("syntax error");
  const std::size_t colon = what.rfind(": ");
  const std::size_t cause = syntax != std::string::npos  ? syntax
                            : colon != std::string::npos ? colon + 2
                                                         : 0;
  return Error{
      fmt::format("{}:{}:{}: {}", name, line_at(text, position), column, what.substr(cause))};
}

}  // namespace

JsonPointer JsonPointer::operator/(std::string_view key) const {
  JsonPointer child = *this;
  child.keys_.emplace_back(key);
  return child;
}

JsonPointer JsonPointer::operator/(std::size_t index) const {
  return *this / std::to_string(index);
}

std::string JsonPointer::text() const {
  std::string text;
  for (const std::string& key : keys_) {
    text += '/';
    for (const char c : key) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  }
  return text;
}

Result<JsonDocument> JsonDocument::parse(std::string name, std::string text) {
  JsonDocument result;
  result.name_ = std::move(name);
  result.text_ = std::move(text);

  try {
    result.root_ = std::make_shared<const Json>(Json::parse(result.text_, true));
  } catch (const Json::exception& error) {
    return parse_error(result.name_, result.text_, error);
  }
  return result;
}

Result<JsonDocument> JsonDocument::read(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) {
    return Error{fmt::format("{}: is a folder", path.string())};
  }

  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{fmt::format("{}: {}", path.string(), std::strerror(errno))};
  std::string text(std::istreambuf_iterator<char>(file), {});
  remove_byte_order_mark(text);
  return parse(path.string(), std::move(text));
}

int JsonDocument::line_of(const JsonPointer& pointer) const {
  Scan scan(text_);
  scan.skip_space();
  for (const std::string& key : pointer.keys()) {
    if (!scan.enter(key)) break;
  }
  return line_at(text_, scan.position());
}

Error JsonDocument::error(const JsonPointer& pointer, std::string_view message) const {
  const std::string where = pointer.text();
  return Error{fmt::format("{}:{}: {}{}{}", name_, line_of(pointer), where,
                           where.empty() ? "" : ": ", message)};
}

bool JsonValue::is_object() const { return value_->is_object(); }
bool JsonValue::is_array() const { return value_->is_array(); }
bool JsonValue::is_string() const { return value_->is_string(); }
bool JsonValue::has(std::string_view key) const { return value_->contains(key); }
std::size_t JsonValue::size() const { return value_->size(); }

std::vector<std::string> JsonValue::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, unused] : value_->items()) keys.push_back(key);
  return keys;
}

JsonValue JsonValue::operator[](std::string_view key) const {
  return {*text_, value_->at(key), pointer_ / key};
}

JsonValue JsonValue::operator[](std::size_t index) const {
  return {*text_, value_->at(index), pointer_ / index};
}

Result<void> JsonValue::expect_keys(const std::vector<std::string_view>& keys) const {
  if (!value_->is_object()) {
    return error(fmt::format("must be an object, not {}", value_->type_name()));
  }

  for (const auto& [key, unused] : value_->items()) {
    if (std::ranges::find(keys, key) != keys.end()) continue;
    std::string message = fmt::format("unknown key '{}'", key);
    const std::string hint = did_you_mean(key, keys);
    message += hint.empty() ? fmt::format(" (known: {})", fmt::join(keys, ", ")) : hint;
    return text_->error(pointer_ / key, message);
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
  TRY_INIT(const auto value, number(low, high));
  return static_cast<int>(value);
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

Result<std::string> JsonValue::one_of(const std::vector<std::string_view>& names) const {
  auto value = string();
  if (!value) return value;
  if (std::ranges::find(names, *value) != names.end()) return value;

  const std::string hint = did_you_mean(*value, names);
  return error(
      fmt::format("unknown '{}'{}", *value,
                  hint.empty() ? fmt::format(" (known: {})", fmt::join(names, ", ")) : hint));
}

}  // namespace cls::base
