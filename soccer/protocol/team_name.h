// Team names of the protocol: at most 15 characters, stored inline.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cls::soccer {

/// Messages name the team of each player, so a name is a small value that never allocates. Empty
/// means unknown.
class TeamName {
 public:
  static constexpr std::size_t kMaxSize = 15;

  constexpr TeamName() = default;
  /// Truncates text to 15 characters; parsers reject longer names.
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
