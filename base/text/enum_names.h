// The texts of an enum's values: one list serves formatting and parsing.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace cls::base {

/// Texts of the values 0, 1, ... of `Enum`, in their order.
template <typename Enum, std::size_t kCount>
struct EnumNames {
  std::array<std::string_view, kCount> texts;

  /// The text of a value; that of the first one for a value beyond the list.
  constexpr std::string_view name(Enum value) const {
    const auto at = static_cast<std::size_t>(value);
    return at < kCount ? texts[at] : texts[0];
  }

  /// The value with this text; nothing if there is none.
  constexpr std::optional<Enum> parse(std::string_view text) const {
    for (std::size_t at = 0; at < kCount; ++at) {
      if (texts[at] == text) return static_cast<Enum>(at);
    }
    return std::nullopt;
  }
};

/// `constexpr auto kNames = enum_names<Color>("red", "green");`
template <typename Enum, typename... Texts>
constexpr EnumNames<Enum, sizeof...(Texts)> enum_names(Texts... texts) {
  return {{std::string_view(texts)...}};
}

}  // namespace cls::base
