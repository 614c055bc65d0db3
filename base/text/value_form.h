// What a value on a command line or in a file must be: a number in a range, one of some words, or
// a text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cls::base {

enum class ValueKind {
  kText,
  kWhole,     ///< a decimal whole number that std::int64_t can hold
  kUnsigned,  ///< a whole number from 0 that std::uint64_t can hold
  kNumber,    ///< a finite decimal number
  kFlag,      ///< true or false
};

struct ValueForm {
  ValueKind kind = ValueKind::kText;
  std::optional<double> min{};
  std::optional<double> max{};
  bool above_min = false;            ///< `min` itself is too small
  std::vector<std::string> words{};  ///< the only texts that fit; empty: any. Of a flag: more
  std::string phrase{};              ///< of texts that must not be empty: "a folder"
};

/// True if the text has the form. Numbers have no "+", no "0x10", no "nan" or "inf".
bool fits(const ValueForm& form, std::string_view text);

/// "a whole number from 0 to 65535", "hold, last or default"; empty if any text fits.
std::string phrase_of(const ValueForm& form);

}  // namespace cls::base
