// A scanner that separates C++ code from comments and literals.
#include "tests/architecture/source_text.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace cls::tests {
namespace {

bool is_identifier(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Each function consumes one comment, literal or other piece of text.
class Scanner {
 public:
  Scanner(std::string_view text, Literals literals) : out_(text), literals_(literals) {}

  std::string run() {
    while (at_ < out_.size()) step();
    return std::move(out_);
  }

 private:
  bool looking_at(std::string_view token) const {
    return out_.compare(at_, token.size(), token) == 0;
  }

  void step() {
    if (looking_at("//")) {
      blank(out_.find('\n', at_));
    } else if (looking_at("/*")) {
      const std::size_t end = out_.find("*/", at_ + 2);
      blank(end == std::string::npos ? end : end + 2);
    } else if (looking_at("R\"") && (at_ == 0 || !is_identifier(out_[at_ - 1]))) {
      raw_string();
    } else if (out_[at_] == '"') {
      literal('"');
    } else if (out_[at_] == '\'' && (at_ == 0 || !is_identifier(out_[at_ - 1]))) {
      literal('\'');  // after an identifier character it is a digit separator
    } else {
      ++at_;
    }
  }

  void blank(std::size_t end) {
    end = std::min(end, out_.size());
    for (; at_ < end; ++at_) {
      if (out_[at_] != '\n') out_[at_] = ' ';
    }
  }

  void raw_string() {
    const std::size_t open = out_.find('(', at_);
    if (open == std::string::npos) {
      at_ = out_.size();
      return;
    }
    const std::string close = ")" + out_.substr(at_ + 2, open - at_ - 2) + "\"";
    const std::size_t end = out_.find(close, open);
    at_ = open + 1;
    pass_to(end);
    at_ = std::min(out_.size(), at_ + close.size());
  }

  void literal(char quote) {
    std::size_t end = ++at_;
    while (end < out_.size() && out_[end] != quote && out_[end] != '\n') {
      end += out_[end] == '\\' ? 2 : 1;
    }
    pass_to(end);
    at_ = std::min(out_.size(), at_ + 1);
  }

  void pass_to(std::size_t end) {
    end = std::min(end, out_.size());
    if (literals_ == Literals::kBlank) {
      blank(end);
    } else {
      at_ = end;
    }
  }

  std::string out_;
  Literals literals_;
  std::size_t at_ = 0;
};

std::optional<Include> include_on(const std::string& line, int number) {
  std::size_t at = line.find_first_not_of(" \t");
  if (at == std::string::npos || line[at] != '#') return std::nullopt;
  at = line.find_first_not_of(" \t", at + 1);
  const std::string_view directive = "include";
  if (at == std::string::npos || line.compare(at, directive.size(), directive) != 0) {
    return std::nullopt;
  }
  const std::size_t open = line.find_first_of("\"<", at);
  if (open == std::string::npos) return std::nullopt;
  const bool quoted = line[open] == '"';
  const std::size_t close = line.find(quoted ? '"' : '>', open + 1);
  if (close == std::string::npos) return std::nullopt;
  return Include{number, line.substr(open + 1, close - open - 1), quoted};
}

/// True for a line that opens the body of a function at the left margin.
bool opens_function(const std::string& line) {
  if (line.empty() || line.back() != '{') return false;
  const std::size_t before = line.find_last_not_of(" \t", line.size() - 2);
  if (before == std::string::npos) return false;
  const std::string head = line.substr(0, before + 1);
  const auto ends_with = [&head](std::string_view end) {
    return head.size() >= end.size() &&
           head.compare(head.size() - end.size(), end.size(), end) == 0;
  };
  return ends_with(")") || ends_with(") const") || ends_with(") noexcept") ||
         ends_with(") const noexcept");
}

}  // namespace

std::string without_comments(std::string_view text, Literals literals) {
  return Scanner(text, literals).run();
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::vector<Include> includes_of(std::string_view text) {
  std::vector<Include> includes;
  int number = 0;
  for (const std::string& line : lines_of(without_comments(text, Literals::kKeep))) {
    if (const auto include = include_on(line, ++number)) includes.push_back(*include);
  }
  return includes;
}

std::vector<Function> functions_of(std::string_view text) {
  std::vector<Function> functions;
  const std::vector<std::string> lines = lines_of(without_comments(text, Literals::kBlank));
  int start = 0;      // first line of the current statement at the margin
  bool open = false;  // inside a body

  for (int number = 1; number <= static_cast<int>(lines.size()); ++number) {
    const std::string& line = lines[static_cast<std::size_t>(number - 1)];
    if (open && line == "}") {
      functions.push_back({start, number - start + 1});
      open = false;
    }
    if (open || line.empty()) continue;
    const bool at_margin = is_identifier(line.front());
    if (at_margin) start = number;
    const bool in_statement = at_margin || (start != 0 && line.starts_with("    "));
    open = in_statement && opens_function(line);
    const bool complete = line.find_last_of(";{}") == line.size() - 1;
    if (!open && complete) start = 0;
  }
  return functions;
}

}  // namespace cls::tests
