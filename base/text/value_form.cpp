// Checks values and describes their form.
#include "base/text/value_form.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/value_text.h"

namespace cls::base {
namespace {

template <class Number>
bool is_in_range(const ValueForm& form, std::string_view text) {
  const auto number = value_of<Number>(text);
  if (!number) return false;

  const double value = static_cast<double>(*number);
  if (form.min && (form.above_min ? value <= *form.min : value < *form.min)) return false;
  return !form.max || value <= *form.max;
}

// "a, b or c".
std::string one_of(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += i == 0 ? "" : i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

// " from 1 to 9"; empty without limits.
std::string range_text(const ValueForm& form) {
  std::string text;
  if (form.min) text += fmt::format(" {} {}", form.above_min ? "above" : "from", *form.min);
  if (form.max) text += fmt::format(" to {}", *form.max);
  return text;
}

}  // namespace

bool fits(const ValueForm& form, std::string_view text) {
  switch (form.kind) {
    case ValueKind::kText:
      break;
    case ValueKind::kWhole:
      return is_in_range<std::int64_t>(form, text);
    case ValueKind::kUnsigned:
      return is_in_range<std::uint64_t>(form, text);
    case ValueKind::kNumber:
      return is_in_range<double>(form, text);
    case ValueKind::kFlag:
      return text == "true" || text == "false" ||
             std::ranges::find(form.words, text) != form.words.end();
  }

  if (!form.words.empty()) {
    return std::ranges::find(form.words, text) != form.words.end();
  }
  return form.phrase.empty() || !text.empty();
}

std::string phrase_of(const ValueForm& form) {
  std::vector<std::string> words = form.words;
  if (form.kind == ValueKind::kFlag) words.insert(words.begin(), {"true", "false"});
  if (!words.empty()) return one_of(words);

  const std::string range = range_text(form);
  switch (form.kind) {
    case ValueKind::kText:
      break;
    case ValueKind::kWhole:
      return "a whole number" + range;
    case ValueKind::kUnsigned:
      return "a whole number" + (range.empty() ? ", 0 or more" : range);
    case ValueKind::kNumber:
      return "a number" + range;
    case ValueKind::kFlag:
      break;
  }
  return form.phrase;
}

}  // namespace cls::base
