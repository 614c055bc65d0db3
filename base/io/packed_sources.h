// Streams that xz and zstd have compressed.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/io/byte_source.h"

namespace cls::base {

inline constexpr std::string_view kXzMagic{"\xfd\x37zXZ\0", 6};
inline constexpr std::string_view kZstdMagic = "\x28\xb5\x2f\xfd";

/// The bytes that `inner` holds compressed; `first` are those that were read from it before.
/// Corrupt or truncated data yields the bytes before the error.
std::unique_ptr<ByteSource> unpack_xz(std::unique_ptr<ByteSource> inner, std::string first);
std::unique_ptr<ByteSource> unpack_zstd(std::unique_ptr<ByteSource> inner, std::string first);

}  // namespace cls::base
