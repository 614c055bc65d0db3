// Reads SVG text with regular expressions, which suffices for the elements that charts have.
#include "tests/viewer/markup.h"

#include <regex>

namespace cls::tests {

namespace {

// The error in the attributes of a tag.
std::string tag_error(const std::string& tag) {
  static const std::regex label(" aria-label=\"[^\"]*\"");
  static const std::regex value("\"[^\"]*\"");
  static const std::regex forbidden("<script|<foreignObject|<image| style=| on[a-z]+=| href=");
  static const std::regex number("nan|inf");
  const std::string numbers = std::regex_replace(tag, label, "");
  if (std::regex_search(numbers, number)) return "has a number that is not finite: " + tag;
  std::smatch found;
  const std::string names = std::regex_replace(tag, value, "");
  return std::regex_search(names, found, forbidden) ? "contains " + found.str() : "";
}

}  // namespace

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::string svg_error(std::string_view svg) {
  const std::string text(svg);
  static const std::regex tag("<(/?)([a-zA-Z]+)([^<>\"]|\"[^<>\"]*\")*?(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
    if (const std::string error = tag_error(it->str()); !error.empty()) return error;
    if ((*it)[1].length() > 0) {
      if (open.empty() || open.back() != (*it)[2]) return "closes " + (*it)[2].str();
      open.pop_back();
    } else if ((*it)[4].length() == 0) {
      open.push_back((*it)[2]);
    }
  }
  if (!open.empty()) return "does not close " + open.back();
  const std::string rest = std::regex_replace(text, tag, "");
  return rest.find_first_of("<>") == std::string::npos ? "" : "has a stray < or >";
}

std::vector<double> attributes_of(std::string_view svg, const std::string& name,
                                  const std::string& attribute, const std::string& filter) {
  const std::string text(svg);
  const std::regex tag("<" + name + " [^<>]*>");
  const std::regex value(" " + attribute + "=\"([^\"]*)\"");
  std::vector<double> values;
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end; ++it) {
    const std::string element = it->str();
    std::smatch found;
    if (element.find(filter) == std::string::npos) continue;
    if (std::regex_search(element, found, value)) values.push_back(std::stod(found[1].str()));
  }
  return values;
}

}  // namespace cls::tests
