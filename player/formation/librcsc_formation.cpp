// Parses the four generations of librcsc formation files.
#include "player/formation/formation_file.h"

#include <fmt/format.h>

#include <optional>

#include "base/index.h"
#include "base/text/json.h"
#include "player/formation/text_lines.h"

namespace cls::player {
namespace {

using base::Error;
using base::Result;

using Samples = std::vector<FormationSample>;
using Tokens = std::vector<std::string_view>;

constexpr std::string_view kStatic = "Static";
constexpr std::string_view kDelaunay = "DelaunayTriangulation";
constexpr std::size_t kTeamNumbers = 2 * soccer::kPlayersPerTeam;

Error unknown_method(const std::string& name, std::string_view method) {
  return {
      fmt::format("{}: unknown method '{}'; supported: {}, {}", name, method, kStatic, kDelaunay)};
}

std::optional<TeamPoints> team_points(const Tokens& tokens, std::size_t first) {
  if (tokens.size() < first + kTeamNumbers) return std::nullopt;
  TeamPoints points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto point = TextLines::parse_point(tokens[first + 2 * i], tokens[first + 2 * i + 1]);
    if (!point) return std::nullopt;
    points[i] = *point;
  }
  return points;
}

// --- JSON -----------------------------------------------------------------------------------

std::optional<Vec2> json_point(const base::Json& object, const std::string& key) {
  const auto found = object.find(key);
  if (found == nullptr || !found->is_object()) return std::nullopt;

  const auto x = found->find("x");
  const auto y = found->find("y");
  if (x == nullptr || y == nullptr || !x->is_number() || !y->is_number()) return std::nullopt;
  return Vec2{x->get<double>(), y->get<double>()};
}

Result<FormationSample> json_sample(const base::Json& object, const std::string& where) {
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

Result<Samples> parse_json(std::string_view text, const std::string& name) {
  const base::Json document = base::Json::parse_or_discarded(text);
  if (document.is_discarded()) return Error{name + ": not valid JSON"};

  const auto method = document.find("method");
  const auto data = document.find("data");
  if (method == nullptr || !method->is_string() || data == nullptr || !data->is_array()) {
    return Error{name + ": missing 'method' or 'data'"};
  }

  const auto token = method->get<std::string>();
  if (token != kStatic && token != kDelaunay) return unknown_method(name, token);

  Samples samples;
  for (const base::Json& object : *data) {
    TRY_INIT(auto sample, json_sample(object, fmt::format("{}: data[{}]", name, samples.size())));
    samples.push_back(sample);
    if (token == kStatic) break;  // independent of the ball
  }

  return samples;
}

// --- CSV ------------------------------------------------------------------------------------

Result<Samples> parse_csv(TextLines& lines, const std::string& name, std::string_view method) {
  if (method != kStatic && method != kDelaunay) return unknown_method(name, method);
  Samples samples;
  bool data = false;
  while (lines.next()) {
    const Tokens tokens = lines.tokens(',');
    if (tokens.front() == "Position" && method == kStatic) {
      const auto points = team_points(tokens, 1);
      if (!points) return lines.error("expected 'Position' and 22 numbers");
      return Samples{{{}, *points}};
    }

    if (tokens.front() == "idx") {
      data = true;
    } else if (data) {
      const auto ball = TextLines::parse_point(tokens, 1, kTeamNumbers + 3);
      const auto points = team_points(tokens, 3);
      if (!ball || !points) return lines.error("expected index, ball and 11 points: 25 numbers");
      samples.push_back({*ball, *points});
    }
  }

  return samples;
}

// --- "Formation ..." ------------------------------------------------------------------------

Result<Samples> parse_static(TextLines& lines) {
  FormationSample sample;
  for (int placed = 0; placed < soccer::kPlayersPerTeam; ++placed) {
    const Tokens tokens = lines.next() ? lines.tokens() : Tokens();
    const auto unum = tokens.empty() ? std::nullopt : TextLines::parse_unum(tokens.front());
    const auto point = TextLines::parse_point(tokens, 2, 4);
    if (!unum || *unum != placed + 1 || !point) {
      return lines.error(fmt::format("expected '{} ROLE X Y'", placed + 1));
    }
    sample.players[base::index(placed)] = *point;
  }

  return Samples{sample};
}

/// Version 1: one line of roles, then 24 numbers per line.
Result<Samples> parse_version_1(TextLines& lines) {
  Samples samples;
  if (!lines.next()) return lines.error("expected the roles");

  while (lines.next()) {
    const Tokens tokens = lines.tokens();
    if (tokens.front() == "End") break;
    const auto ball = TextLines::parse_point(tokens, 0, kTeamNumbers + 2);
    const auto points = team_points(tokens, 2);
    if (!ball || !points) return lines.error("expected ball and 11 points: 24 numbers");
    samples.push_back({*ball, *points});
  }

  return samples;
}

/// Versions 2 and 3: twelve lines per sample between "Begin Samples" and "End Samples".
Result<Samples> parse_blocks(TextLines& lines) {
  Samples samples;
  bool inside = false;
  std::size_t next = 0;
  while (lines.next()) {
    const Tokens tokens = lines.tokens();
    if (tokens.front() == "Begin" || tokens.front() == "End") {
      inside = tokens.front() == "Begin" && tokens.size() > 1 && tokens[1] == "Samples";
      continue;
    }
    if (!inside || tokens.front().starts_with("-----")) continue;

    const auto point = TextLines::parse_point(tokens, 1, 3);
    const std::string expected = next == 0 ? "Ball" : std::to_string(next);
    if (!point || tokens.front() != expected) {
      return lines.error(fmt::format("expected '{} X Y'", expected));
    }

    if (next == 0) {
      samples.push_back({*point, {}});
    } else {
      samples.back().players[next - 1] = *point;
    }
    next = next == soccer::kPlayersPerTeam ? 0 : next + 1;
  }

  if (next != 0) return lines.error("the last sample is incomplete");
  return samples;
}

}  // namespace

Result<Samples> parse_librcsc_formation(std::string_view text, const std::string& name) {
  TextLines lines(text, name);
  if (!lines.next()) return Error{name + ": empty"};
  if (lines.tokens().front().starts_with('{')) return parse_json(text, name);

  Tokens tokens = lines.tokens(',');
  if (tokens.front() == "Method" && tokens.size() == 2) return parse_csv(lines, name, tokens[1]);
  tokens = lines.tokens();
  if (tokens.front() != "Formation" || tokens.size() < 2)
    return lines.error("not a formation file");

  if (tokens[1] == kStatic) return parse_static(lines);
  if (tokens[1] != kDelaunay) return unknown_method(name, tokens[1]);

  const std::string_view version = tokens.size() > 2 ? tokens[2] : "1";
  if (version == "1") return parse_version_1(lines);
  if (version == "2" || version == "3") return parse_blocks(lines);
  return lines.error(fmt::format("unsupported version {} of {}", version, kDelaunay));
}

}  // namespace cls::player
