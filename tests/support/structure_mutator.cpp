// Finds parts of texts and puts them elsewhere.
#include "tests/support/structure_mutator.h"

#include <algorithm>
#include <array>

namespace cls::tests {
namespace {

constexpr std::string_view kOpening = "([{";
constexpr std::string_view kClosing = ")]}";
constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";

constexpr std::array<std::string_view, 16> kNumbers = {
    "0",     "-1",  "1",   "11",         "12",          "6000",
    "65536", "1e9", "0.5", "2147483647", "-2147483648", "9223372036854775808",
    "1e308", "nan", "inf", "-0.0"};

std::string replaced(const std::string& text, std::size_t begin, std::size_t end,
                     std::string_view by) {
  return text.substr(0, begin) + std::string(by) + text.substr(end);
}

}  // namespace

std::size_t StructureMutator::below(std::size_t end) {
  state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
  return static_cast<std::size_t>(state_ >> 33) % end;
}

std::string StructureMutator::mutate(std::string text, std::size_t max_size) {
  for (std::size_t changes = 1 + below(4); changes > 0 && !text.empty(); --changes) {
    std::string changed = change(text);
    if (changed.size() <= max_size) text = std::move(changed);
  }
  if (text.size() > max_size) text.resize(max_size);
  return text;
}

// With its line end.
StructureMutator::Span StructureMutator::line(const std::string& text) {
  const std::size_t at = below(text.size());
  const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return {begin, std::min(text.find('\n', begin), text.size() - 1) + 1};
}

// From a bracket to the one that closes it; empty if there is none.
StructureMutator::Span StructureMutator::group(const std::string& text) {
  std::size_t begin = text.find_first_of(kOpening, below(text.size()));
  if (begin == std::string::npos) begin = text.find_first_of(kOpening);
  if (begin == std::string::npos) return {};
  int depth = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    if (kOpening.find(text[i]) != std::string::npos) ++depth;
    if (kClosing.find(text[i]) != std::string::npos && --depth == 0) return {begin, i + 1};
  }
  return {};
}

StructureMutator::Span StructureMutator::word(const std::string& text,
                                              std::string_view characters) {
  const std::size_t begin = text.find_first_of(characters, below(text.size()));
  if (begin == std::string::npos) return {};
  return {begin, std::min(text.find_first_not_of(characters, begin), text.size())};
}

std::string StructureMutator::repeated(const std::string& text, Span span) {
  const std::string part = text.substr(span.begin, span.end - span.begin);
  std::string parts;
  for (std::size_t times = below(8) == 0 ? 1000 : 1; times > 0; --times) parts += part;
  return replaced(text, span.end, span.end, parts);
}

// Nothing if one is inside of the other.
std::string StructureMutator::exchanged(const std::string& text, Span one, Span other) {
  if (other.begin < one.begin) std::swap(one, other);
  if (other.begin < one.end) return text;
  return text.substr(0, one.begin) + text.substr(other.begin, other.end - other.begin) +
         text.substr(one.end, other.begin - one.end) + text.substr(one.begin, one.end - one.begin) +
         text.substr(other.end);
}

std::string StructureMutator::change(const std::string& text) {
  const std::size_t kind = below(10);
  const Span one = kind < 3 ? line(text) : kind < 7 ? group(text) : Span{};
  switch (kind) {
    case 0:
    case 3:
      return repeated(text, one);
    case 1:
    case 4:
      return replaced(text, one.begin, one.end, "");
    case 2:
      return exchanged(text, one, line(text));
    case 5: {
      const Span other = group(text);
      return replaced(text, one.begin, one.end, text.substr(other.begin, other.end - other.begin));
    }
    case 6: {
      // Nested in itself.
      if (one.begin == one.end) return text;
      const std::string inner = text.substr(one.begin, one.end - one.begin);
      return replaced(text, one.begin + 1, one.begin + 1, inner + " ");
    }
    case 7:
    case 8: {
      const Span number = word(text, kDigits);
      return replaced(text, number.begin, number.end, kNumbers[below(kNumbers.size())]);
    }
    default: {
      const Span from = word(text, kLetters);
      const Span to = word(text, kLetters);
      return replaced(text, to.begin, to.end, text.substr(from.begin, from.end - from.begin));
    }
  }
}

}  // namespace cls::tests
