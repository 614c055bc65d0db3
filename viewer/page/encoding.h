// Bytes as text within a page: base64, SHA-256, gzip.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::viewer {

/// Base64 with padding, without line breaks.
std::string base64(std::string_view bytes);

/// The reverse; white space is skipped. The error says where another character is.
base::Result<std::string> from_base64(std::string_view text);

/// The source expression of a Content-Security-Policy: 'sha256-...'.
std::string csp_hash(std::string_view text);

/// SHA-256 in hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

std::string gzip(std::string_view bytes);

/// At most `max_size` bytes; an error beyond, and for bytes that are not gzip or end early.
base::Result<std::string> gunzip(std::string_view bytes, std::size_t max_size);

}  // namespace cls::viewer
