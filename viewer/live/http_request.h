// Requests without bodies: their line and their header fields, within strict limits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace cls::viewer {

/// Longer heads are refused.
constexpr std::size_t kMaxRequestHead = 8 * 1024;

/// Views into the bytes of a request.
struct HttpRequest {
  std::string_view method;
  std::string_view target;
  std::vector<std::pair<std::string_view, std::string_view>> fields;
  bool keeps_connection =
      false;  ///< another request may follow: the client agrees, and no body does

  /// The value of the first field with this name, in any case; empty if there is none.
  std::string_view field(std::string_view name) const;
};

struct ParsedRequest {
  enum class State : std::uint8_t { kIncomplete, kWhole, kTooLong, kBad };
  State state = State::kIncomplete;
  HttpRequest request;   ///< of a kWhole one
  std::size_t size = 0;  ///< of its head
};

/// Parses the head at the start of `bytes`: HTTP 1.0 or 1.1, lines that end with CR LF, a name and
/// a value in each. What cannot become a request any more is kBad before its head is whole.
ParsedRequest parse_request(std::string_view bytes);

/// Equal but for the case of ASCII letters.
bool equals_ignoring_case(std::string_view a, std::string_view b);

}  // namespace cls::viewer
