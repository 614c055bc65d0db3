// The version of the format of a TOML file: its key `schema`.
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <optional>
#include <string>

#include "base/text/schema.h"

namespace cls::match {

/// Why a file with this value of `schema` cannot be read where `newest` and older versions can
/// (base::schema_error()); nothing if it can. Only integers are versions: toml++ would convert
/// 1e308 to one, too, which is undefined.
inline std::optional<std::string> schema_error(const toml::node& schema, int newest) {
  return base::schema_error(schema.value_exact<std::int64_t>().value_or(0), newest);
}

}  // namespace cls::match
