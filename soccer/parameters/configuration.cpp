// Parser of configuration text.
#include "soccer/parameters/configuration.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace cls::soccer {
namespace {

constexpr std::string_view kSpaces = " \t\r\n\v\f";

bool is_space(char c) { return kSpaces.find(c) != std::string_view::npos; }

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '.';
}

class ConfigurationParser {
 public:
  explicit ConfigurationParser(std::string_view text) : text_(text) {}

  base::Result<std::vector<ConfigurationItem>> parse_all() {
    std::vector<ConfigurationItem> items;
    while (skip()) {
      std::optional<ConfigurationItem> item = parse_item();
      if (!item) return base::Error{"line " + std::to_string(line_) + ": " + error_};
      items.push_back(std::move(*item));
    }

    if (!error_.empty()) return base::Error{"line " + std::to_string(line_) + ": " + error_};
    return items;
  }

 private:
  std::string_view rest() const { return text_.substr(at_); }
  bool at_end() const { return at_ >= text_.size(); }

  void advance(std::size_t count) {
    const std::string_view passed = text_.substr(at_, count);
    line_ += static_cast<int>(std::count(passed.begin(), passed.end(), '\n'));
    at_ += passed.size();
  }

  // Skips white space and comments; false at the end of the text and after an error.
  bool skip() {
    for (;;) {
      while (!at_end() && is_space(text_[at_])) advance(1);
      if (rest().starts_with("/*")) {
        const std::size_t end = rest().find("*/", 2);
        if (end == std::string_view::npos) return fail("unterminated comment");
        advance(end + 2);
      } else if (rest().starts_with('#') || rest().starts_with("//")) {
        advance(std::min(rest().find('\n'), rest().size()));
      } else {
        return !at_end();
      }
    }
  }

  bool fail(std::string message) {
    if (error_.empty()) error_ = std::move(message);
    return false;
  }

  std::string_view token() const {
    return rest().substr(0, std::min(rest().find_first_of(kSpaces), rest().size()));
  }

  std::string_view parse_name() {
    std::size_t size = 0;
    while (size < rest().size() && is_name_character(rest()[size])) ++size;

    const std::string_view name = rest().substr(0, size);
    at_ += size;
    return name;
  }

  std::optional<ConfigurationItem> parse_item() {
    ConfigurationItem item;
    item.line = line_;

    const std::string_view begin = token();
    for (int dashes = 0; dashes < 2 && rest().starts_with('-'); ++dashes) ++at_;
    item.name = parse_name();

    if (rest().starts_with("::")) {
      at_ += 2;
      item.module = std::exchange(item.name, std::string(parse_name()));
    }

    if (item.name == "help") return item;
    if (item.name.empty() || !skip() || !rest().starts_with('=')) {
      fail("'" + std::string(begin) + "' is not of the form server::NAME=VALUE");
      return std::nullopt;
    }

    ++at_;
    if (!skip() || !parse_value(item.value)) {
      fail("'" + std::string(begin) + "' has no value");
      return std::nullopt;
    }

    return item;
  }

  bool parse_value(std::string& value) {
    const char quote = rest().front();
    if (quote != '\'' && quote != '"') {
      value = token();
      at_ += value.size();
      return true;
    }

    const std::size_t end = rest().find(quote, 1);
    if (end == std::string_view::npos) return fail("unterminated quote");

    value = rest().substr(1, end - 1);
    advance(end + 1);
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::string error_;
};

// Restores the quotes around a value with spaces, which the shell has removed.
std::string quoted(const std::string& argument) {
  if (argument.find_first_of(kSpaces) == std::string::npos) return argument;

  const char quote = argument.find('\'') == std::string::npos ? '\'' : '"';
  const std::size_t equals = argument.find('=');
  const std::size_t begin = equals == std::string::npos ? 0 : equals + 1;

  const bool has_quotes = argument.find_first_of("'\"") != std::string::npos;
  if (has_quotes || begin == argument.size()) return argument;
  return argument.substr(0, begin) + quote + argument.substr(begin) + quote;
}

}  // namespace

base::Result<std::vector<ConfigurationItem>> parse_configuration(std::string_view text) {
  return ConfigurationParser(text).parse_all();
}

std::string join_arguments(const std::vector<std::string>& arguments) {
  std::string text;
  for (const std::string& argument : arguments) {
    if (!text.empty()) text += ' ';
    text += quoted(argument);
  }

  return text;
}

}  // namespace cls::soccer
