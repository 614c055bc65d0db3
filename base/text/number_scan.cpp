// The slow path of the number scanners.
#include "base/text/number_scan.h"

#include <cmath>
#include <string_view>

#include "base/text/number_text.h"

namespace cls::base::detail {
namespace {

constexpr std::size_t kMaxNumberLength = 48;

// A number ends within its line.
std::string_view token_at(const char* at) {
  std::size_t length = 0;
  while (length < kMaxNumberLength && at[length] != ' ' && at[length] != ')' &&
         at[length] != '\n') {
    ++length;
  }
  return {at, length};
}

bool is_decimal(std::string_view token) {
  double read = 0.0;
  return !token.empty() && parse_number_prefix(token, read) == token.size();
}

}  // namespace

bool scan_any_number(const char*& at, float& value) {
  double read = 0.0;
  const std::size_t length = parse_number_prefix(token_at(at), read);
  if (length == 0 || !(std::fabs(read) <= kMaxNumber)) return false;
  value = static_cast<float>(read);
  at += length;
  return true;
}

bool scan_any_integer(const char*& at, std::int32_t& value) {
  int read = 0;
  const std::size_t length = parse_int_prefix(token_at(at), read);
  if (length == 0) return false;
  value = read;
  at += length;
  return true;
}

}  // namespace cls::base::detail

namespace cls::base {

bool scan_number_out_of_range(const char*& at, float& value) {
  const std::string_view token = detail::token_at(at);
  const bool negative = token.starts_with('-');
  const std::string_view magnitude = token.substr(negative ? 1 : 0);
  const bool is_nan = magnitude == "nan";
  if (!is_nan && magnitude != "inf" && !detail::is_decimal(magnitude)) return false;

  const double limit = negative ? -kMaxNumber : kMaxNumber;
  value = is_nan ? 0.0F : static_cast<float>(limit);
  at += token.size();
  return true;
}

}  // namespace cls::base
