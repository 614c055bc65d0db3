// Named parameters of a Playmaker, and constraints between them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::tournament {

enum class Scale { kLinear, kLog };

struct Parameter {
  std::string name;
  double min = 0.0;
  double max = 1.0;
  double start = 0.0;
  double step = 0.0;  ///< first standard deviation, as a share of the range in its scale
  bool integer = false;
  Scale scale = Scale::kLinear;
};

/// A point of the search space: one coordinate from 0 (min) to 1 (max) per parameter.
using Point = std::vector<double>;

/// The values of the parameters, in their order; integers are whole.
using Values = std::vector<double>;

/// Integers share the range from 0 to 1 in equal parts.
double value_at(const Parameter& parameter, double coordinate);
double coordinate_of(const Parameter& parameter, double value);
Values values_at(const std::vector<Parameter>& parameters, const Point& point);
Point start_point(const std::vector<Parameter>& parameters);

/// "12" for integers; otherwise the shortest text with at most six significant digits.
std::string value_text(const Parameter& parameter, double value);

/// A sum of multiples of parameters that must be at most `limit`: "near + 2 * far <= 10".
struct Constraint {
  std::string text;
  std::vector<double> factors;  ///< one per parameter
  double limit = 0.0;
};

/// Terms are NUMBER, NAME or NUMBER * NAME, joined by + and -, on both sides of <= or >= (< and >
/// mean the same). An error names what is wrong.
base::Result<Constraint> parse_constraint(std::string_view text,
                                          const std::vector<Parameter>& parameters);

bool satisfies(const Values& values, const std::vector<Constraint>& constraints);

}  // namespace cls::tournament
