// A match of the real server, read from its rcg (version 6) and rcl.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "gamelog/frame.h"
#include "soccer/player_params.h"
#include "soccer/player_type.h"
#include "soccer/server_params.h"

namespace cls::tests {

struct RecordedMatch {
  /// A frame, and how many frames with the same time were before it: the server's stoppage.
  struct Show {
    gamelog::Frame frame;
    int stoppage = 0;
  };
  /// What a player or coach (unum 0) sent.
  struct Received {
    soccer::Side side = soccer::Side::kLeft;
    int unum = 0;
    std::string text;
  };
  /// What the referee said.
  struct Called {
    std::string word;
  };
  using Line = std::variant<Received, Called>;

  soccer::ServerParams server;
  soccer::PlayerParams player;
  std::vector<soccer::PlayerType> types;
  std::vector<Show> shows;
  /// The text log by its stamps, time and stoppage.
  std::map<std::pair<int, int>, std::vector<Line>> lines;
};

/// Throws std::runtime_error, which fails the test, on anything it does not understand.
RecordedMatch read_recorded_match(const std::filesystem::path& rcg,
                                  const std::filesystem::path& rcl);

}  // namespace cls::tests
