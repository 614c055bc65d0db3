// Scales, texts and linear constraints.
#include "tournament/tuning/parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/text/number_text.h"
#include "base/text/suggestion.h"

namespace cls::tournament {
namespace {

using base::Error;
using base::Result;

double scaled(const Parameter& parameter, double value) {
  return parameter.scale == Scale::kLog ? std::log(value) : value;
}

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-';
}

// Reads terms from left to right into a constraint.
class ConstraintParser {
 public:
  ConstraintParser(std::string_view text, const std::vector<Parameter>& parameters)
      : text_(text), parameters_(parameters) {
    constraint_.text = std::string(text);
    constraint_.factors.resize(parameters.size());
  }

  Result<Constraint> parse() {
    TRY(parse_sum(1.0));
    skip_spaces();
    const char comparison = at_ < text_.size() ? text_[at_] : '\0';
    if (comparison != '<' && comparison != '>') return Error{"expected <= or >="};
    ++at_;
    if (at_ < text_.size() && text_[at_] == '=') ++at_;
    TRY(parse_sum(-1.0));
    skip_spaces();
    if (at_ < text_.size()) return Error{fmt::format("unexpected '{}'", text_.substr(at_))};
    if (comparison == '>') {
      for (double& factor : constraint_.factors) factor = -factor;
      constraint_.limit = -constraint_.limit;
    }
    return std::move(constraint_);
  }

 private:
  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  bool take(char c) {
    skip_spaces();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  Result<void> parse_sum(double side) {
    double sign = take('-') ? -side : side;
    while (true) {
      if (auto term = parse_term(sign); !term) return term;
      if (take('+')) {
        sign = side;
      } else if (take('-')) {
        sign = -side;
      } else {
        return {};
      }
    }
  }

  Result<void> parse_term(double sign) {
    skip_spaces();
    double factor = 1.0;
    const std::string_view rest = std::string_view(text_).substr(at_);
    const std::size_t length = rest.starts_with('+') ? 0 : base::parse_number_prefix(rest, factor);
    const bool number = length > 0;
    if (number) {
      at_ += length;
      if (!take('*')) {
        constraint_.limit -= sign * factor;
        return {};
      }
    }
    return parse_name(sign * (number ? factor : 1.0));
  }

  Result<void> parse_name(double factor) {
    skip_spaces();
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_name_character(text_[at_])) ++at_;
    const std::string_view name = text_.substr(begin, at_ - begin);
    if (name.empty()) return Error{"expected a number or the name of a parameter"};
    std::vector<std::string_view> known;
    for (std::size_t i = 0; i < parameters_.size(); ++i) {
      known.push_back(parameters_[i].name);
      if (parameters_[i].name != name) continue;
      constraint_.factors[i] += factor;
      return {};
    }
    const std::string_view near = base::nearest_name(name, known);
    return Error{fmt::format("no parameter '{}'{}", name,
                             near.empty() ? "" : fmt::format("; did you mean '{}'?", near))};
  }

  std::string_view text_;
  const std::vector<Parameter>& parameters_;
  std::size_t at_ = 0;
  Constraint constraint_;
};

}  // namespace

double value_at(const Parameter& parameter, double coordinate) {
  const double share = std::clamp(coordinate, 0.0, 1.0);
  if (parameter.integer && parameter.scale == Scale::kLinear) {
    const double count = parameter.max - parameter.min + 1;
    return std::min(parameter.max, parameter.min + std::floor(share * count));
  }
  const double low = scaled(parameter, parameter.min);
  const double high = scaled(parameter, parameter.max);
  const double value = low + share * (high - low);
  const double plain = parameter.scale == Scale::kLog ? std::exp(value) : value;
  const double inside = std::clamp(plain, parameter.min, parameter.max);
  return parameter.integer ? std::round(inside) : inside;
}

double coordinate_of(const Parameter& parameter, double value) {
  if (parameter.integer && parameter.scale == Scale::kLinear) {
    return (value - parameter.min + 0.5) / (parameter.max - parameter.min + 1);
  }
  const double low = scaled(parameter, parameter.min);
  const double high = scaled(parameter, parameter.max);
  return (scaled(parameter, value) - low) / (high - low);
}

Values values_at(const std::vector<Parameter>& parameters, const Point& point) {
  Values values(parameters.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = value_at(parameters[i], point[i]);
  return values;
}

Point start_point(const std::vector<Parameter>& parameters) {
  Point point;
  for (const Parameter& parameter : parameters) {
    point.push_back(coordinate_of(parameter, parameter.start));
  }
  return point;
}

std::string value_text(const Parameter& parameter, double value) {
  return parameter.integer ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value);
}

Result<Constraint> parse_constraint(std::string_view text,
                                    const std::vector<Parameter>& parameters) {
  return ConstraintParser(text, parameters).parse();
}

bool satisfies(const Values& values, const std::vector<Constraint>& constraints) {
  constexpr double kTolerance = 1e-9;
  return std::ranges::all_of(constraints, [&](const Constraint& constraint) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += constraint.factors[i] * values[i];
    return sum <= constraint.limit + kTolerance;
  });
}

}  // namespace cls::tournament
