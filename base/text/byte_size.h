// Sizes in bytes as users write them: "512M", "2G".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cls::base {

/// The bytes of a whole number with the unit K, M, G or T, a power of 1024. Nothing for any other
/// text, for 0, and for more than 64 bits hold.
std::optional<std::uint64_t> parse_byte_size(std::string_view text);

/// The text that parses to `bytes`, in the largest unit that divides it. Parts of 1K are lost.
std::string byte_size_text(std::uint64_t bytes);

}  // namespace cls::base
