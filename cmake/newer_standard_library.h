// What the standard library of Debian's emscripten lacks of C++20. Every file of a WebAssembly
// build includes it first; other builds never do. The functions have the results of the standard.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#if !defined(_LIBCPP_VERSION) || _LIBCPP_VERSION >= 15000
#error "this standard library has these functions: leave the header out"
#endif

// NOLINTBEGIN: names and namespaces are those of the standard.
namespace std {

#if !defined(__cpp_lib_bit_cast)
template <typename To, typename From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}
#endif

#if !defined(__cpp_lib_to_chars)
/// As printf writes it, in the C locale: musl has no other for numbers.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format,
                                int precision) {
  array<char, 512> text;
  const int length = snprintf(text.data(), text.size(), "%.*g", precision, value);
  if (length > last - first) return {last, errc::value_too_large};
  return {copy_n(text.data(), length, first), errc()};
}

/// The shorter of both notations of the shortest digits that give the number back.
inline to_chars_result to_chars(char* first, char* last, double value) {
  array<char, 512> text;
  int length = 0;
  int digits = 0;
  for (; digits < 17; ++digits) {
    length = snprintf(text.data(), text.size(), "%.*e", digits, value);
    if (strtod(text.data(), nullptr) == value) break;
  }

  const string scientific(text.data(), static_cast<size_t>(length));
  const int exponent = atoi(scientific.substr(scientific.find('e') + 1).c_str());
  length = snprintf(text.data(), text.size(), "%.*f", max(0, digits - exponent), value);
  const string fixed(text.data(), static_cast<size_t>(length));

  const string& shorter = fixed.size() <= scientific.size() ? fixed : scientific;
  if (static_cast<ptrdiff_t>(shorter.size()) > last - first) return {last, errc::value_too_large};
  return {copy(shorter.begin(), shorter.end(), first), errc()};
}

/// For texts that are numbers as a whole, and have no plus sign.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  char* end = nullptr;
  const double parsed = strtod(text.c_str(), &end);
  const char* stop = first + (end - text.c_str());
  if (stop == first) return {first, errc::invalid_argument};
  const bool underflow =
      parsed == 0.0 && text.find_first_of("123456789") < text.find_first_of("eE");
  if (!isfinite(parsed) || underflow) return {stop, errc::result_out_of_range};
  value = parsed;
  return {stop, errc()};
}
#endif

namespace ranges {

template <typename In, typename Out>
struct in_out_result {
  In in;
  Out out;
};

template <typename First, typename Second>
struct in_in_result {
  First in1;
  Second in2;
};

template <typename T>
struct min_max_result {
  T min;
  T max;
};

template <typename Iterator, typename Predicate, typename Projection>
constexpr Iterator find_if(Iterator first, Iterator last, Predicate predicate,
                           Projection projection) {
  while (first != last && !invoke(predicate, invoke(projection, *first))) ++first;
  return first;
}

template <typename Range, typename Predicate, typename Projection = identity>
constexpr auto find_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return ranges::find_if(std::begin(range), std::end(range), ref(predicate), ref(projection));
}

template <typename Range, typename Predicate, typename Projection = identity>
constexpr auto find_if_not(Range&& range, Predicate predicate, Projection projection = {}) {
  return ranges::find_if(range, not_fn(ref(predicate)), ref(projection));
}

template <typename Range, typename T, typename Projection = identity>
constexpr auto find(Range&& range, const T& value, Projection projection = {}) {
  return ranges::find_if(
      range, [&](const auto& one) { return one == value; }, ref(projection));
}

template <typename Range, typename Predicate, typename Projection = identity>
constexpr bool any_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return ranges::find_if(range, ref(predicate), ref(projection)) != std::end(range);
}

template <typename Range, typename Predicate, typename Projection = identity>
constexpr bool none_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return !ranges::any_of(range, ref(predicate), ref(projection));
}

template <typename Range, typename Predicate, typename Projection = identity>
constexpr bool all_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return !ranges::any_of(range, not_fn(ref(predicate)), ref(projection));
}

template <typename Range, typename Predicate, typename Projection = identity>
constexpr ptrdiff_t count_if(Range&& range, Predicate predicate, Projection projection = {}) {
  ptrdiff_t number = 0;
  for (auto&& one : range) number += invoke(predicate, invoke(projection, one)) ? 1 : 0;
  return number;
}

template <typename Range, typename T, typename Projection = identity>
constexpr ptrdiff_t count(Range&& range, const T& value, Projection projection = {}) {
  return ranges::count_if(
      range, [&](const auto& one) { return one == value; }, ref(projection));
}

/// `compare` of what `projection` makes of both arguments.
template <typename Compare, typename Projection>
constexpr auto projected_compare(Compare& compare, Projection& projection) {
  return [&](const auto& one, const auto& other) {
    return invoke(compare, invoke(projection, one), invoke(projection, other));
  };
}

template <typename Range, typename Compare = less, typename Projection = identity>
constexpr void sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), projected_compare(compare, projection));
}

template <typename Range, typename Compare = less, typename Projection = identity>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), projected_compare(compare, projection));
}

template <typename Range, typename Compare = less, typename Projection = identity>
constexpr bool is_sorted(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::is_sorted(std::begin(range), std::end(range), projected_compare(compare, projection));
}

template <typename Range, typename Compare = less, typename Projection = identity>
constexpr auto max_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::max_element(std::begin(range), std::end(range),
                          projected_compare(compare, projection));
}

template <typename Range, typename Compare = less, typename Projection = identity>
constexpr auto min_element(Range&& range, Compare compare = {}, Projection projection = {}) {
  return std::min_element(std::begin(range), std::end(range),
                          projected_compare(compare, projection));
}

template <typename Range, typename Compare = less, typename Projection = identity>
constexpr auto max(Range&& range, Compare compare = {}, Projection projection = {}) {
  return *ranges::max_element(range, ref(compare), ref(projection));
}

template <typename Range, typename Compare = less, typename Projection = identity>
constexpr auto minmax(Range&& range, Compare compare = {}, Projection projection = {}) {
  const auto [least, greatest] = std::minmax_element(std::begin(range), std::end(range),
                                                     projected_compare(compare, projection));
  return min_max_result<remove_cvref_t<decltype(*least)>>{*least, *greatest};
}

template <typename Range, typename T, typename Compare = less, typename Projection = identity>
constexpr auto lower_bound(Range&& range, const T& value, Compare compare = {},
                           Projection projection = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value,
                          [&](const auto& one, const T& wanted) {
                            return invoke(compare, invoke(projection, one), wanted);
                          });
}

template <typename Range, typename T, typename Compare = less, typename Projection = identity>
constexpr bool binary_search(Range&& range, const T& value, Compare compare = {},
                             Projection projection = {}) {
  const auto found = ranges::lower_bound(range, value, ref(compare), ref(projection));
  return found != std::end(range) && !invoke(compare, value, invoke(projection, *found));
}

template <typename First, typename Second>
constexpr bool equal(First&& first, Second&& second) {
  return std::equal(std::begin(first), std::end(first), std::begin(second), std::end(second));
}

template <typename First, typename Second>
constexpr auto mismatch(First&& first, Second&& second) {
  auto [one, other] =
      std::mismatch(std::begin(first), std::end(first), std::begin(second), std::end(second));
  return in_in_result<decltype(one), decltype(other)>{one, other};
}

template <typename Range, typename Out, typename Function>
requires(!is_invocable_v<Function, Out>) constexpr auto transform(Range&& range, Out out,
                                                                  Function function) {
  out = std::transform(std::begin(range), std::end(range), out, ref(function));
  return in_out_result<decltype(std::end(range)), Out>{std::end(range), out};
}

template <typename Range, typename Out>
constexpr auto copy(Range&& range, Out out) {
  out = std::copy(std::begin(range), std::end(range), out);
  return in_out_result<decltype(std::end(range)), Out>{std::end(range), out};
}

template <typename Range, typename Out, typename Predicate, typename Projection = identity>
constexpr auto copy_if(Range&& range, Out out, Predicate predicate, Projection projection = {}) {
  for (auto&& one : range) {
    if (invoke(predicate, invoke(projection, one))) *out++ = one;
  }
  return in_out_result<decltype(std::end(range)), Out>{std::end(range), out};
}

template <typename First, typename Second, typename Out>
constexpr void set_difference(First&& first, Second&& second, Out out) {
  std::set_difference(std::begin(first), std::end(first), std::begin(second), std::end(second),
                      out);
}

template <typename Range, typename T, typename New>
constexpr void replace(Range&& range, const T& old_value, const New& new_value) {
  std::replace(std::begin(range), std::end(range), old_value, new_value);
}

template <typename Range, typename Predicate, typename T>
constexpr void replace_if(Range&& range, Predicate predicate, const T& value) {
  std::replace_if(std::begin(range), std::end(range), ref(predicate), value);
}

template <typename Range>
constexpr void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}

}  // namespace ranges
}  // namespace std
// NOLINTEND
