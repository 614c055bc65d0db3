// Messages of the server that an agent could not use.
#pragma once

#include <cstdint>
#include <string>

namespace cls::proxy {

/// None in a healthy match.
struct ServerTrouble {
  std::int64_t unreadable = 0;   ///< messages that do not parse
  std::int64_t errors = 0;       ///< (error ...) replies
  std::int64_t warnings = 0;     ///< (warning ...) replies
  std::string first_unreadable;  ///< why, and the beginning of the message
  std::string first_error;
  std::string first_warning;

  void note_unreadable(const std::string& why, const std::string& message) {
    constexpr std::size_t kQuotedLength = 60;
    if (unreadable++ == 0) first_unreadable = why + ": " + message.substr(0, kQuotedLength);
  }
  void note_error(const std::string& text) {
    if (errors++ == 0) first_error = text;
  }
  void note_warning(const std::string& text) {
    if (warnings++ == 0) first_warning = text;
  }
};

}  // namespace cls::proxy
