// Parameter values from text, and suggestions for mistyped names.
#include "soccer/parameter.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>

namespace cls::soccer {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

// Insertions, deletions, replacements and swaps of neighbours, one each.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({last[j] + (a[i] == b[j] ? 0 : 1), row[j] + 1, last[j + 1] + 1});
      const bool swapped = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
      if (swapped) row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
  }
  return row[b.size()];
}

Error not_a(std::string_view kind, std::string_view text) {
  return Error{"'" + std::string(text) + "' is not " + std::string(kind)};
}

}  // namespace

std::string_view nearest_name(std::string_view word, const std::vector<std::string_view>& names) {
  std::string_view best;
  std::size_t best_distance = word.size() / 3 + 1;
  for (const std::string_view name : names) {
    const std::size_t distance = edit_distance(lower(word), lower(name));
    if (distance < best_distance) {
      best_distance = distance;
      best = name;
    }
  }
  return best;
}

namespace detail {

Result<void> assign(double& value, std::string_view text) {
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  double read = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), read);
  if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(read)) {
    return not_a("a number", text);
  }
  value = read;
  return {};
}

Result<void> assign(int& value, std::string_view text) {
  double read = 0.0;
  if (!assign(read, text) || read != std::rint(read) || read < std::numeric_limits<int>::min() ||
      read > std::numeric_limits<int>::max()) {
    return not_a("a whole number", text);
  }
  value = static_cast<int>(read);
  return {};
}

Result<void> assign(bool& value, std::string_view text) {
  const std::string word = lower(text);
  if (word == "on" || word == "true" || word == "1") {
    value = true;
  } else if (word == "off" || word == "false" || word == "0") {
    value = false;
  } else {
    return not_a("on or off", text);
  }
  return {};
}

Result<void> assign(std::string& value, std::string_view text) {
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
      text.back() == text.front()) {
    text = text.substr(1, text.size() - 2);
  }
  value = text;
  return {};
}

}  // namespace detail
}  // namespace cls::soccer
