// Tokens, separators and escapes of JSON.
#include "base/text/json_cursor.h"

#include <algorithm>
#include <cmath>

#include "base/text/number_scan.h"
#include "base/text/number_text.h"

namespace cls::base {
namespace {

constexpr int kMaxDepth = 32;

void append_utf8(unsigned code, std::string& out) {
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0 | code >> 6);
    out += static_cast<char>(0x80 | (code & 0x3F));
  } else {
    out += static_cast<char>(0xE0 | code >> 12);
    out += static_cast<char>(0x80 | (code >> 6 & 0x3F));
    out += static_cast<char>(0x80 | (code & 0x3F));
  }
}

// Four hexadecimal digits after \u; consumes nothing if they are missing.
void append_unicode(std::string_view& rest, std::string& out) {
  unsigned code = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const char c = i < rest.size() ? rest[i] : ' ';
    const std::size_t digit = std::string_view("0123456789abcdefABCDEF").find(c);
    if (digit == std::string_view::npos) return;
    code = code << 4 | static_cast<unsigned>(digit < 16 ? digit : digit - 6);
  }

  append_utf8(code, out);
  rest.remove_prefix(4);
}

void append_unescaped(std::string_view raw, std::string& out) {
  constexpr std::string_view kNames = "bfnrt";
  constexpr std::string_view kMeanings = "\b\f\n\r\t";
  while (!raw.empty()) {
    const std::size_t plain = std::min(raw.find('\\'), raw.size());
    out += raw.substr(0, plain);
    raw.remove_prefix(plain);
    if (raw.size() < 2) break;

    const char c = raw[1];
    raw.remove_prefix(2);
    const std::size_t known = kNames.find(c);
    if (c == 'u') {
      append_unicode(raw, out);
    } else {
      out += known == std::string_view::npos ? c : kMeanings[known];
    }
  }
}

}  // namespace

void JsonCursor::skip_space() {
  while (at_ < end_ && (*at_ == ' ' || *at_ == '\t' || *at_ == '\r')) ++at_;
}

char JsonCursor::peek() {
  skip_space();
  return at_ < end_ ? *at_ : '\0';
}

bool JsonCursor::at_end() { return peek() == '\0' && at_ == end_; }

bool JsonCursor::open(char bracket) {
  if (!good_ || peek() != bracket) return fail();
  ++at_;
  first_ = true;
  return true;
}

// A comma between elements, none before the first, the closing bracket after the last.
bool JsonCursor::separator(char closing) {
  if (!good_) return false;
  const char c = peek();
  if (c == closing) {
    ++at_;
    first_ = false;
    return false;
  }

  if (first_) {
    first_ = false;
    return true;
  }

  if (c != ',') return fail();
  ++at_;
  return true;
}

bool JsonCursor::next_key(std::string_view& key) {
  if (!separator('}')) return false;
  if (!raw_string(key)) return false;
  if (peek() != ':') return fail();
  ++at_;
  return true;
}

std::string JsonCursor::unescape(std::string_view raw) {
  std::string text;
  append_unescaped(raw, text);
  return text;
}

bool JsonCursor::next_element() { return separator(']'); }

bool JsonCursor::raw_string(std::string_view& value) {
  if (peek() != '"') return fail();
  const char* first = at_ + 1;
  const char* at = first;
  while (at < end_ && *at != '"') at += *at == '\\' && at + 1 < end_ ? 2 : 1;
  if (at >= end_) return fail();

  value = {first, static_cast<std::size_t>(at - first)};
  at_ = at + 1;
  return true;
}

bool JsonCursor::string(std::string& value) {
  std::string_view raw;
  if (!raw_string(raw)) return false;
  value.clear();
  append_unescaped(raw, value);
  return true;
}

bool JsonCursor::string_or_null(std::string& value) {
  if (peek() != 'n') return string(value);
  value.clear();
  return skip_value();
}

bool JsonCursor::number(double& value) {
  skip_space();
  float read = 0.0F;
  const char* at = at_;
  if (!scan_number(at, read) || at > end_) return fail();
  value = read;
  at_ = at;
  return true;
}

bool JsonCursor::integer(int& value) {
  skip_space();
  const char* at = at_;
  if (!scan_integer(at, value) || at > end_) return fail();
  at_ = at;
  return true;
}

bool JsonCursor::scalar_text(std::string& out) {
  const char c = peek();
  if (c == '"') {
    std::string text;
    if (!string(text)) return false;
    out += '"';
    out += text;
    out += '"';
    return true;
  }

  const char* first = at_;
  while (at_ < end_ && *at_ != ',' && *at_ != '}' && *at_ != ']' && *at_ != ' ') ++at_;
  const std::string_view token(first, static_cast<std::size_t>(at_ - first));
  if (token == "true" || token == "false") {
    out += token == "true" ? '1' : '0';
    return true;
  }

  if (!parse_number(token)) return fail();
  out += token;
  return true;
}

bool JsonCursor::skip_value() {
  int depth = 0;
  do {
    const char c = peek();
    std::string_view ignored;
    if (c == '"') {
      if (!raw_string(ignored)) return false;
    } else if (c == '{' || c == '[') {
      if (++depth > kMaxDepth) return fail();
      ++at_;
    } else if (c == '}' || c == ']') {
      if (--depth < 0) return fail();
      ++at_;
    } else if (c == ',' || c == ':') {
      if (depth == 0) return fail();
      ++at_;
    } else {
      const char* first = at_;
      while (at_ < end_ && std::string_view(",:{}[]\" ").find(*at_) == std::string_view::npos)
        ++at_;
      if (at_ == first) return fail();
    }
  } while (depth > 0);
  return true;
}

}  // namespace cls::base
