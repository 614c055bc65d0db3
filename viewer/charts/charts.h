// Charts of a match: plain data in, the text of an SVG image out (drawing.h). The same data give
// the same text on every host. Positions are meters on the pitch, y down.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "soccer/geometry.h"
#include "soccer/side.h"

namespace cls::viewer {

/// Which color a mark has. kBoth: neither team's.
enum class Tone : unsigned char { kLeft, kRight, kBoth };

constexpr Tone tone_of(std::size_t team) { return team == 0 ? Tone::kLeft : Tone::kRight; }

struct ChartTitle {
  std::string text;
  std::string note;  ///< what the reader must know, such as "attacks to the right"; may be empty
};

/// How often something was where, on square cells around the center of the pitch.
struct HeatMapData {
  ChartTitle title;
  Tone tone = Tone::kBoth;
  double cell_size = 5.0;  ///< meters
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<double> cells;  ///< row by row from the top left; columns * rows, else none is drawn
};
std::string heat_map(const HeatMapData& data);

/// Passes between players: circles at mean positions, lines for pairs.
struct PassNetworkData {
  struct Node {
    int unum = 0;
    soccer::Vec2 position;
    int passes = 0;  ///< given and received
  };

  struct Edge {
    std::size_t first = 0;  ///< indices into nodes
    std::size_t second = 0;
    int passes = 0;  ///< both directions
  };

  ChartTitle title;
  Tone tone = Tone::kLeft;
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};
std::string pass_network_chart(const PassNetworkData& data);

/// Shots of both teams; the left team shoots to the right.
struct ShotMapData {
  struct Shot {
    std::size_t team = 0;
    soccer::Vec2 position;
    double expected = 0.0;  ///< goal probability
    bool goal = false;
    std::string tip;
  };

  ChartTitle title;
  std::array<std::string, 2> teams;  ///< legend of each team
  std::vector<Shot> shots;
};
std::string shot_map(const ShotMapData& data);

/// The time of a match in frames of its log, which continue while the clock is stopped.
struct TimeAxis {
  struct Tick {
    double at = 0.0;  ///< frame
    std::string text;
  };

  double last = 0.0;  ///< frame
  std::vector<Tick> ticks;
  std::vector<double> halves;  ///< frames where the second half and extra time begin
};

/// Sums that grow over the match, one line per team, with goals marked.
struct RaceData {
  struct Step {
    double at = 0.0;  ///< frame; in order
    double gain = 0.0;
    bool goal = false;
    std::string tip;
  };

  ChartTitle title;
  TimeAxis axis;
  std::array<std::string, 2> teams;  ///< legend of each team
  std::array<std::vector<Step>, 2> steps;
};
std::string race_chart(const RaceData& data);

/// Shares of the left team over time, one strip per quantity.
struct SharesData {
  struct Strip {
    std::string name;
    std::vector<double> shares;  ///< 0 to 1 at equal distances from first to last frame; NaN: none
  };

  ChartTitle title;
  TimeAxis axis;
  std::array<std::string, 2> teams;
  std::vector<Strip> strips;
};
std::string shares_chart(const SharesData& data);

/// One moment of the match.
struct SceneData {
  struct Player {
    std::size_t team = 0;
    int unum = 0;
    soccer::Vec2 position;
    double body = 0.0;  ///< degrees
    bool marked = false;
  };

  ChartTitle title;
  std::array<std::string, 2> teams;
  std::vector<Player> players;
  soccer::Vec2 ball;
  std::vector<soccer::Vec2> ball_path;  ///< where the ball was and will be
};
std::string scene_chart(const SceneData& data);

/// A search for the best parameters over its generations.
struct SearchData {
  /// A value with a band around it.
  struct Value {
    double center = 0.0;
    double low = 0.0;
    double high = 0.0;
  };

  struct Trace {
    std::string name;
    std::array<std::string, 2> ends;  ///< texts of the lowest and the highest value
    std::vector<Value> values;        ///< 0 to 1 of the range, from the start values on
  };

  ChartTitle title;
  std::string unit;           ///< of the scores: "goals a match"
  double even = 0.0;          ///< the score of equals
  std::vector<Value> scores;  ///< of each generation
  std::vector<Trace> traces;  ///< one strip per parameter
};
std::string search_chart(const SearchData& data);

/// The strength of teams with its uncertainty.
struct RatingsData {
  struct Team {
    std::string name;
    double elo = 0.0;
    double error = 0.0;  ///< half of the interval
  };

  ChartTitle title;
  std::vector<Team> teams;  ///< from the top
};
std::string ratings_chart(const RatingsData& data);

/// The goal differences of a team against another: their mean as it came about, and how often each
/// occurred.
struct DifferencesData {
  ChartTitle title;
  std::vector<int> differences;  ///< goals for minus goals against, match by match
};
std::string differences_chart(const DifferencesData& data);

}  // namespace cls::viewer
