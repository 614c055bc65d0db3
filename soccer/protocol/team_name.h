// A team name as the protocol carries it: at most 15 characters, held inline.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cls::soccer {

/// Messages name a team for every player they show, so a name is a small value that never
/// allocates. Empty means "not known".
class TeamName {
 public:
  static constexpr std::size_t kMaxSize = 15;

  constexpr TeamName() = default;
  /// Text beyond 15 characters is cut off; parsers refuse longer names before they get here.
  constexpr TeamName(std::string_view text) {
    for (const char c : text.substr(0, kMaxSize)) text_[size_++] = c;
  }
  constexpr TeamName(const char* text) : TeamName(std::string_view(text)) {}

  constexpr std::string_view view() const { return {text_.data(), size_}; }
  constexpr bool empty() const { return size_ == 0; }

  friend constexpr bool operator==(const TeamName& a, const TeamName& b) {
    return a.view() == b.view();
  }

 private:
  std::array<char, kMaxSize> text_{};
  std::uint8_t size_ = 0;
};

}  // namespace cls::soccer
