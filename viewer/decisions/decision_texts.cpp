// Takes numbers out of texts and puts them in again.
#include "viewer/decisions/decision_texts.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "base/index.h"

namespace cls::viewer {
namespace {

constexpr std::size_t kMaxDigits = 5;
constexpr std::size_t kMaxDecimals = 3;
/// Thousandths in the last digit, by number of decimals.
constexpr std::array<std::int64_t, kMaxDecimals + 1> kUnits = {1000, 100, 10, 1};
constexpr std::int64_t kMaxThousandths = 100'000 * 1000;

struct Number {
  std::int64_t thousandths = 0;
  std::size_t decimals = 0;
};

struct Split {
  std::size_t shape = 0;
  std::vector<Number> numbers;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Reads at most `most` digits at `at` and moves it behind them.
std::int64_t read_digits(std::string_view text, std::size_t most, std::size_t& at) {
  std::int64_t value = 0;
  const std::size_t end = std::min(text.size(), at + most);
  for (; at < end && is_digit(text[at]); ++at) value = 10 * value + (text[at] - '0');
  return value;
}

/// Reads a number at `at` that number_text() writes in the same way and moves `at` behind it;
/// false: there is none.
bool read_number(std::string_view text, std::size_t& at, Number& number) {
  std::size_t end = at;
  const bool negative = text[end] == '-';
  if (negative) ++end;
  if (end >= text.size() || !is_digit(text[end])) return false;

  const std::int64_t whole = read_digits(text, text[end] == '0' ? 1 : kMaxDigits, end);
  number = {whole * kUnits[0], 0};
  if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1])) {
    const std::size_t start = ++end;
    const std::int64_t fraction = read_digits(text, kMaxDecimals, end);
    number.decimals = end - start;
    number.thousandths += fraction * kUnits.at(number.decimals);
  }

  if (negative && number.thousandths == 0) return false;
  if (negative) number.thousandths = -number.thousandths;
  at = end;
  return true;
}

void append_number(const Number& number, std::string& out) {
  const std::int64_t size = std::abs(number.thousandths);
  if (number.thousandths < 0) out += '-';
  out += std::to_string(size / kUnits[0]);
  if (number.decimals == 0) return;

  const std::string fraction = std::to_string(kUnits[0] + size % kUnits[0]);
  out += '.' + fraction.substr(1, number.decimals);
}

void add_shape(std::string shape, TextShapes& shapes) {
  const std::size_t places = base::index(std::ranges::count(shape, kNumberPlace));
  shapes.ids.emplace(shape, shapes.shapes.size());
  shapes.shapes.push_back(std::move(shape));
  shapes.last.emplace_back(places, 0);
}

Split split(std::string_view text, TextShapes& shapes) {
  Split result;
  std::string shape;
  text = text.substr(0, kMaxDecisionText);

  for (std::size_t at = 0; at < text.size();) {
    Number number;
    if (read_number(text, at, number)) {
      result.numbers.push_back(number);
      shape += kNumberPlace;
    } else {
      shape += text[at] == kNumberPlace ? ' ' : text[at];
      ++at;
    }
  }

  const auto known = shapes.ids.find(shape);
  result.shape = known != shapes.ids.end() ? known->second : shapes.shapes.size();
  if (known == shapes.ids.end()) add_shape(std::move(shape), shapes);
  return result;
}

/// The last number at a place, rounded to the decimals of the next one.
std::int64_t expected(std::int64_t last, std::size_t decimals) {
  const std::int64_t unit = kUnits.at(decimals);
  const std::int64_t twice = 2 * last + unit;
  const std::int64_t quotient = twice / (2 * unit);
  return twice % (2 * unit) < 0 ? quotient - 1 : quotient;
}

/// Calls `run(text, place)` for all numbers in the order of the stream: shape by shape, place by
/// place, text by text.
template <typename Run>
void for_each_number(const std::vector<std::size_t>& ids, const TextShapes& shapes, Run run) {
  std::vector<std::vector<std::size_t>> texts_of(shapes.shapes.size());
  for (std::size_t i = 0; i < ids.size(); ++i) texts_of[ids[i]].push_back(i);

  for (std::size_t shape = 0; shape < texts_of.size(); ++shape) {
    if (texts_of[shape].empty()) continue;
    for (std::size_t place = 0; place < shapes.last[shape].size(); ++place) {
      for (const std::size_t text : texts_of[shape]) run(text, place);
    }
  }
}

std::string joined(const std::string& shape, const std::vector<Number>& numbers) {
  std::string text;
  std::size_t next = 0;
  for (const char c : shape) {
    if (c == kNumberPlace) {
      append_number(numbers[next++], text);
    } else {
      text += c;
    }
  }
  return text;
}

void decode_shapes(TextShapes& shapes, ByteReader& in) {
  const std::uint64_t fresh = in.varint();
  for (std::uint64_t i = 0; i < fresh && in.good(); ++i) {
    const std::string_view shape = in.string();
    if (shape.size() > kMaxDecisionText) return in.fail();
    add_shape(std::string(shape), shapes);
  }
}

/// Numbers that the texts hold together.
std::size_t numbers_in(const std::vector<std::size_t>& ids, const TextShapes& shapes) {
  std::size_t sum = 0;
  for (const std::size_t id : ids) sum += shapes.last[id].size();
  return sum;
}

}  // namespace

void encode_texts(const std::vector<std::string_view>& texts, TextShapes& shapes,
                  std::string& out) {
  const std::size_t known = shapes.shapes.size();
  std::vector<Split> parts;
  std::vector<std::size_t> ids;
  for (const std::string_view text : texts) {
    parts.push_back(split(text, shapes));
    ids.push_back(parts.back().shape);
  }

  append_varint(shapes.shapes.size() - known, out);
  for (std::size_t i = known; i < shapes.shapes.size(); ++i) append_string(shapes.shapes[i], out);
  for (const std::size_t id : ids) append_varint(id, out);

  for_each_number(ids, shapes, [&](std::size_t text, std::size_t place) {
    const Number& number = parts[text].numbers[place];
    std::int64_t& last = shapes.last[ids[text]][place];
    const std::int64_t step =
        number.thousandths / kUnits.at(number.decimals) - expected(last, number.decimals);
    const std::uint64_t code = step >= 0 ? 2 * static_cast<std::uint64_t>(step)
                                         : 2 * static_cast<std::uint64_t>(-step) - 1;
    append_varint(4 * code + number.decimals, out);
    last = number.thousandths;
  });
}

std::vector<std::string> decode_texts(std::size_t count, TextShapes& shapes, std::size_t room,
                                      ByteReader& in) {
  decode_shapes(shapes, in);

  std::vector<std::size_t> ids;
  std::size_t size = 0;
  for (std::size_t i = 0; i < count && in.good(); ++i) {
    const std::uint64_t id = in.varint();
    if (id >= shapes.shapes.size()) in.fail();
    if (!in.good()) return {};
    ids.push_back(id);
    size += shapes.shapes[id].size();
  }

  // Each number takes a byte at least.
  if (size > room || numbers_in(ids, shapes) > in.left()) in.fail();
  if (!in.good()) return {};

  std::vector<std::vector<Number>> numbers(count);
  for_each_number(ids, shapes, [&](std::size_t text, std::size_t) {
    const std::uint64_t code = in.varint();
    const auto decimals = static_cast<std::size_t>(code % 4);
    const auto step = static_cast<std::int64_t>(code / 8);
    std::int64_t& last = shapes.last[ids[text]][numbers[text].size()];
    last =
        (expected(last, decimals) + (code / 4 % 2 == 0 ? step : -step - 1)) * kUnits.at(decimals);
    if (std::abs(last) >= kMaxThousandths) in.fail();
    if (!in.good()) last = 0;
    numbers[text].push_back({last, decimals});
  });

  if (!in.good()) return {};
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    texts.push_back(joined(shapes.shapes[ids[i]], numbers[i]));
  }
  return texts;
}

}  // namespace cls::viewer
