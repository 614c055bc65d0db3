// Checks of SVG and HTML text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cls::tests {

/// How often `part` is in `text`.
std::size_t count(std::string_view text, std::string_view part);

/// The error in an SVG image; empty if its elements are balanced, and it has neither scripts,
/// inline styles, event handlers nor numbers that are not finite.
std::string svg_error(std::string_view svg);

/// The value of an attribute in each element `name` whose text contains `filter`, in order.
std::vector<double> attributes_of(std::string_view svg, const std::string& name,
                                  const std::string& attribute, const std::string& filter = "");

}  // namespace cls::tests
