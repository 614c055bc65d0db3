// Refuses what RFC 9112 does not allow, and folded lines, which it lets servers refuse.
#include "viewer/live/http_request.h"

#include <algorithm>
#include <optional>

#include "base/text/split.h"
#include "base/text/trimmed.h"
#include "base/text/value_text.h"

namespace cls::viewer {
namespace {

constexpr std::string_view kLineEnd = "\r\n";
constexpr std::string_view kHeadEnd = "\r\n\r\n";
constexpr std::string_view kBlank = " \t";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (lower(c) >= 'a' && lower(c) <= 'z');
}

bool is_token(std::string_view text) {
  constexpr std::string_view kMarks = "!#$%&'*+-.^_`|~";
  return !text.empty() && std::ranges::all_of(text, [&](char c) {
    return is_letter_or_digit(c) || kMarks.find(c) != std::string_view::npos;
  });
}

bool is_control(char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }

bool is_target(std::string_view text) {
  return !text.empty() &&
         std::ranges::none_of(text, [](char c) { return c == ' ' || is_control(c); });
}

bool is_value(std::string_view text) {
  return std::ranges::none_of(text, [](char c) { return c != '\t' && is_control(c); });
}

// True if a list of tokens, "keep-alive, Upgrade", has one.
bool lists(std::string_view field, std::string_view token) {
  return std::ranges::any_of(base::split(field, ','), [&](std::string_view one) {
    return equals_ignoring_case(base::trimmed(one, kBlank), token);
  });
}

// Moves `line` behind the next part, which ends at `separator`.
std::string_view take_until(char separator, std::string_view& line) {
  const std::string_view part = line.substr(0, line.find(separator));
  line.remove_prefix(std::min(part.size() + 1, line.size()));
  return part;
}

bool add_field(std::string_view line, HttpRequest& request) {
  if (line.find(':') == std::string_view::npos) return false;
  const std::string_view name = take_until(':', line);
  request.fields.emplace_back(name, base::trimmed(line, kBlank));
  return is_token(name) && is_value(line);
}

// Whether a body follows; nothing if its length makes no sense.
std::optional<bool> has_body(const HttpRequest& request) {
  if (!request.field("Transfer-Encoding").empty()) return true;

  const bool has_length = std::ranges::any_of(request.fields, [](const auto& field) {
    return equals_ignoring_case(field.first, "Content-Length");
  });
  if (!has_length) return false;
  const auto length = base::value_of<std::uint64_t>(request.field("Content-Length"));
  if (!length) return std::nullopt;
  return *length > 0;
}

bool parse_head(std::string_view head, HttpRequest& request) {
  std::string_view line = head.substr(0, head.find(kLineEnd));
  head.remove_prefix(std::min(line.size() + kLineEnd.size(), head.size()));

  request.method = take_until(' ', line);
  request.target = take_until(' ', line);
  const bool is_new = line == "HTTP/1.1";
  if (!is_token(request.method) || !is_target(request.target)) return false;
  if (!is_new && line != "HTTP/1.0") return false;

  while (!head.empty()) {
    line = head.substr(0, head.find(kLineEnd));
    if (!add_field(line, request)) return false;
    head.remove_prefix(std::min(line.size() + kLineEnd.size(), head.size()));
  }

  const auto body = has_body(request);
  const std::string_view connection = request.field("Connection");
  const bool agreed = is_new ? !lists(connection, "close") : lists(connection, "keep-alive");
  request.keeps_connection = agreed && body == false;
  return body.has_value();
}

}  // namespace

std::string_view HttpRequest::field(std::string_view name) const {
  const auto found = std::ranges::find_if(
      fields, [name](const auto& field) { return equals_ignoring_case(field.first, name); });
  return found == fields.end() ? std::string_view() : found->second;
}

ParsedRequest parse_request(std::string_view bytes) {
  using State = ParsedRequest::State;
  const std::string_view method = bytes.substr(0, bytes.find(' '));
  if (!bytes.empty() && !is_token(method)) return {State::kBad, {}, 0};

  const std::size_t end = bytes.substr(0, kMaxRequestHead).find(kHeadEnd);
  if (end == std::string_view::npos) {
    return {bytes.size() < kMaxRequestHead ? State::kIncomplete : State::kTooLong, {}, 0};
  }

  ParsedRequest parsed{State::kWhole, {}, end + kHeadEnd.size()};
  if (!parse_head(bytes.substr(0, end), parsed.request)) parsed.state = State::kBad;
  return parsed;
}

bool equals_ignoring_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, lower, lower);
}

}  // namespace cls::viewer
