// The figure of 95 % confidence intervals.
#pragma once

namespace cls::base {

/// Two-sided 95 % of the normal distribution.
inline constexpr double kNormal95 = 1.959963984540054;

}  // namespace cls::base
