// FNV-1a: a short, portable hash that need not resist attacks.
#pragma once

#include <cstdint>
#include <string_view>

namespace cls::base {

/// The FNV-1a hash of `bytes`: the same value on every host and in every build.
constexpr std::uint64_t fnv1a(std::string_view bytes) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char c : bytes) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  }
  return hash;
}

}  // namespace cls::base
