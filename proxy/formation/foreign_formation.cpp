// Four generations of librcsc's formation files.
#include "proxy/formation/foreign_formation.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "proxy/formation/text_lines.h"

namespace cls::proxy {
namespace {

using base::Error;
using base::Result;
using soccer::Vec2;

using Samples = std::vector<FormationSample>;
using Words = std::vector<std::string_view>;

constexpr std::string_view kStatic = "Static";
constexpr std::string_view kDelaunay = "DelaunayTriangulation";
constexpr std::size_t kTeamNumbers = 2 * soccer::kPlayersPerTeam;

Error unknown_method(const std::string& name, std::string_view method) {
  return {fmt::format("{}: method '{}' is not known (known: {}, {})", name, method, kStatic,
                      kDelaunay)};
}

std::optional<TeamPoints> team_points(const Words& words, std::size_t first) {
  if (words.size() < first + kTeamNumbers) return std::nullopt;
  TeamPoints points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto point = TextLines::point(words[first + 2 * i], words[first + 2 * i + 1]);
    if (!point) return std::nullopt;
    points[i] = *point;
  }
  return points;
}

// --- JSON -----------------------------------------------------------------------------------

std::optional<Vec2> json_point(const nlohmann::json& object, const std::string& key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_object()) return std::nullopt;
  const auto x = found->find("x");
  const auto y = found->find("y");
  if (x == found->end() || y == found->end() || !x->is_number() || !y->is_number()) {
    return std::nullopt;
  }
  return Vec2{x->get<double>(), y->get<double>()};
}

Result<FormationSample> json_sample(const nlohmann::json& object, const std::string& where) {
  FormationSample sample;
  if (!object.is_object()) return Error{where + ": not an object"};
  const std::optional<Vec2> ball = json_point(object, "ball");
  if (!ball) return Error{where + ": no 'ball' with x and y"};
  sample.ball = *ball;
  for (std::size_t i = 0; i < sample.players.size(); ++i) {
    const std::optional<Vec2> point = json_point(object, std::to_string(i + 1));
    if (!point) return Error{fmt::format("{}: no player '{}' with x and y", where, i + 1)};
    sample.players[i] = *point;
  }
  return sample;
}

Result<Samples> read_json(std::string_view text, const std::string& name) {
  const nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
  if (document.is_discarded()) return Error{name + ": not valid JSON"};
  const auto method = document.find("method");
  const auto data = document.find("data");
  if (method == document.end() || !method->is_string() || data == document.end() ||
      !data->is_array()) {
    return Error{name + ": a formation needs 'method' and 'data'"};
  }
  const auto& word = method->get_ref<const std::string&>();
  if (word != kStatic && word != kDelaunay) return unknown_method(name, word);
  Samples samples;
  for (const nlohmann::json& object : *data) {
    auto sample = json_sample(object, fmt::format("{}: data[{}]", name, samples.size()));
    if (!sample) return sample.error();
    samples.push_back(*sample);
    if (word == kStatic) break;  // the ball plays no part
  }
  return samples;
}

// --- CSV ------------------------------------------------------------------------------------

Result<Samples> read_csv(TextLines& lines, const std::string& name, std::string_view method) {
  if (method != kStatic && method != kDelaunay) return unknown_method(name, method);
  Samples samples;
  bool data = false;
  while (lines.next()) {
    const Words words = lines.words(',');
    if (words.front() == "Position" && method == kStatic) {
      const auto points = team_points(words, 1);
      if (!points) return lines.error("expected 'Position' and 22 numbers");
      return Samples{{{}, *points}};
    }
    if (words.front() == "idx") {
      data = true;
    } else if (data) {
      const auto ball =
          words.size() == kTeamNumbers + 3 ? TextLines::point(words[1], words[2]) : std::nullopt;
      const auto points = team_points(words, 3);
      if (!ball || !points) return lines.error("expected index, ball and 11 points: 25 numbers");
      samples.push_back({*ball, *points});
    }
  }
  return samples;
}

// --- "Formation ..." ------------------------------------------------------------------------

Result<Samples> read_static(TextLines& lines) {
  FormationSample sample;
  for (int placed = 0; placed < soccer::kPlayersPerTeam; ++placed) {
    const Words words = lines.next() ? lines.words() : Words();
    const auto unum = words.empty() ? std::nullopt : TextLines::unum(words.front());
    const auto point =
        words.size() == 4 ? TextLines::point(words[2], words[3]) : std::optional<Vec2>();
    if (!unum || *unum != placed + 1 || !point) {
      return lines.error(fmt::format("expected '{} ROLE X Y'", placed + 1));
    }
    sample.players[static_cast<std::size_t>(placed)] = *point;
  }
  return Samples{sample};
}

/// Roles in one line, then 24 numbers a line.
Result<Samples> read_first_version(TextLines& lines) {
  Samples samples;
  if (!lines.next()) return lines.error("expected the roles");
  while (lines.next()) {
    const Words words = lines.words();
    if (words.front() == "End") break;
    const auto ball =
        words.size() == kTeamNumbers + 2 ? TextLines::point(words[0], words[1]) : std::nullopt;
    const auto points = team_points(words, 2);
    if (!ball || !points) return lines.error("expected ball and 11 points: 24 numbers");
    samples.push_back({*ball, *points});
  }
  return samples;
}

/// One block of twelve lines a sample between "Begin Samples" and "End Samples".
Result<Samples> read_blocks(TextLines& lines) {
  Samples samples;
  bool inside = false;
  std::size_t next = 0;
  while (lines.next()) {
    const Words words = lines.words();
    if (words.front() == "Begin" || words.front() == "End") {
      inside = words.front() == "Begin" && words.size() > 1 && words[1] == "Samples";
      continue;
    }
    if (!inside || words.front().starts_with("-----")) continue;
    const auto point = words.size() == 3 ? TextLines::point(words[1], words[2]) : std::nullopt;
    const std::string expected = next == 0 ? "Ball" : std::to_string(next);
    if (!point || words.front() != expected) {
      return lines.error(fmt::format("expected '{} X Y'", expected));
    }
    if (next == 0) {
      samples.push_back({*point, {}});
    } else {
      samples.back().players[next - 1] = *point;
    }
    next = next == soccer::kPlayersPerTeam ? 0 : next + 1;
  }
  if (next != 0) return lines.error("the last sample is cut off");
  return samples;
}

}  // namespace

Result<Samples> read_foreign_formation(std::string_view text, const std::string& name) {
  TextLines lines(text, name);
  if (!lines.next()) return Error{name + ": empty"};
  if (lines.words().front().starts_with('{')) return read_json(text, name);
  Words words = lines.words(',');
  if (words.front() == "Method" && words.size() == 2) return read_csv(lines, name, words[1]);
  words = lines.words();
  if (words.front() != "Formation" || words.size() < 2) return lines.error("not a formation file");
  if (words[1] == kStatic) return read_static(lines);
  if (words[1] != kDelaunay) return unknown_method(name, words[1]);
  const std::string_view version = words.size() > 2 ? words[2] : "1";
  if (version == "1") return read_first_version(lines);
  if (version == "2" || version == "3") return read_blocks(lines);
  return lines.error(fmt::format("version {} of {} is not known", version, kDelaunay));
}

}  // namespace cls::proxy
