// Versions of the formats of stored documents: "cls.match/1", or a number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cls::base {

/// Why a document of `schema` cannot be read where `newest`, such as "cls.match/2", and its older
/// versions can: another format, or a newer version. Nothing if it can.
std::optional<std::string> schema_error(std::string_view schema, std::string_view newest);

/// The error of a format whose files have the version alone, `schema = 2`. It begins with
/// "schema".
std::optional<std::string> schema_error(std::int64_t version, int newest);

}  // namespace cls::base
