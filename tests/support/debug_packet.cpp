// One regular expression per item.
#include "tests/support/debug_packet.h"

#include <regex>
#include <sstream>
#include <utility>

namespace cls::tests {
namespace {

const std::string kInt = R"(-?\d+)";
const std::string kNumber = R"(-?\d+(\.\d+)?(e-?\d+)?)";
const std::string kText = R"("[^"]*")";

std::string numbers(int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += " " + kNumber;
  return out;
}

// After the name of the item, up to its closing parenthesis.
const std::vector<std::pair<std::string, std::regex>>& forms() {
  const std::string comment = R"(( \(c )" + kText + R"(\))?)";
  const std::string angles = R"(( \(bd )" + kNumber + R"(\))?( \(pt )" + kNumber + R"(\))?)";
  const std::string known = " " + kInt + " " + kInt + numbers(2) + angles + comment;
  const std::string unknown = numbers(2) + angles + comment;
  const std::string color = "( " + kText + ")?";
  static const std::vector<std::pair<std::string, std::regex>> all = [&] {
    std::vector<std::pair<std::string, std::regex>> made;
    const auto add = [&made](const std::string& name, const std::string& rest) {
      made.emplace_back(name, std::regex(R"( \()" + name + rest + R"(\))"));
    };

    add("s", " [lr] " + kInt + " " + kInt + numbers(6) + comment);
    add("b", numbers(2) + "(" + numbers(2) + ")?" + comment);
    for (const char* team : {"t", "o"}) add(team, known);
    for (const char* team : {"ut", "uo", "u"}) add(team, unknown);
    add("say", " " + kText);
    add("hear", R"( (\()" + kInt + " " + kText + R"(\))*)");
    add("target-teammate", " " + kInt);
    add("target-point", numbers(2));
    add("message", " " + kText);
    add("line", numbers(4) + color);
    add("tri", numbers(6) + color);
    add("rect", numbers(4) + color);
    add("circle", numbers(3) + color);
    return made;
  }();
  return all;
}

// Takes the item at the beginning of `rest`.
bool take_item(std::string& rest, DebugPacket& packet) {
  for (const auto& [name, form] : forms()) {
    std::smatch match;
    if (!std::regex_search(rest, match, form, std::regex_constants::match_continuous)) continue;
    const std::string item = match.str();
    if (name == "s") {
      packet.side = item[4];
      packet.unum = std::stoi(item.substr(6));
    }
    packet.items[name].push_back(item.substr(1));
    rest = match.suffix();
    return true;
  }
  return false;
}

}  // namespace

DebugPacket parse_debug_packet(std::string_view text) {
  DebugPacket packet;
  static const std::regex head(R"(\(\(debug \(format-version 5\)\) \(time (\d+),(\d+)\))");
  std::string rest(text);
  std::smatch match;
  if (!std::regex_search(rest, match, head, std::regex_constants::match_continuous)) {
    packet.error = rest.empty() ? "empty" : rest;
    return packet;
  }
  packet.cycle = std::stoi(match[1]);
  packet.stopped = std::stoi(match[2]);
  rest = match.suffix();
  while (take_item(rest, packet)) {
  }
  if (rest != ")") packet.error = rest;
  return packet;
}

std::vector<DebugPacket> parse_debug_file(const std::string& text) {
  std::vector<DebugPacket> packets;
  std::istringstream in(text);
  std::string step;
  for (std::string line; std::getline(in, step) && std::getline(in, line);) {
    constexpr std::string_view kBegin = "%% debug [";
    const bool framed =
        step.starts_with("%% step ") && line.starts_with(kBegin) && line.ends_with("]");
    DebugPacket packet;
    if (framed) {
      packet = parse_debug_packet(
          std::string_view(line).substr(kBegin.size(), line.size() - kBegin.size() - 1));
    }
    if (!framed || step != "%% step " + std::to_string(packet.cycle)) packet.error = step;
    packets.push_back(std::move(packet));
  }
  return packets;
}

}  // namespace cls::tests
