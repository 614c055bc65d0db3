// The configuration of `cls tune`: what is searched, and how (tune.toml).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tournament/report/comparison.h"
#include "tournament/tuning/parameter.h"

namespace cls::tournament {

inline constexpr const char* kTuneFile = "tune.toml";

enum class TuneMethod { kCmaEs, kSpsa };

struct TuneConfig {
  std::string team;                    ///< a SIDE with placeholders {NAME} and {file}
  std::vector<std::string> opponents;  ///< SIDEs or teams; empty: candidates play each other (SPSA)
  TuneMethod method = TuneMethod::kCmaEs;
  Measure measure = Measure::kGoals;
  int max_goals = 3;
  int generations = 20;
  int population = 0;       ///< candidates of a generation; 0: as the method needs
  int pairs = 8;            ///< of each candidate; opponents take turns
  double stop = 0.1;        ///< error probability with which a worse candidate stops; 0: never
  int verdict_pairs = 200;  ///< maximum of the final comparison; 0: none
  std::uint64_t seed = 1;
  std::string file;           ///< name of the file that {file} stands for: *.json or *.toml
  std::string file_template;  ///< its text with placeholders; empty: names and values
  std::vector<std::pair<std::string, std::string>> environment;  ///< name, text with placeholders
  std::vector<Parameter> parameters;
  std::vector<Constraint> constraints;
};

struct ParsedTuneConfig {
  TuneConfig config;
  std::vector<std::string> errors;  ///< "tune.toml:3: unknown key 'pais'; did you mean 'pairs'?"
};

/// Parses the text of a file; `file` is its name in messages. Reads no template: `file_template` is
/// its path then. Checks everything but the sides.
ParsedTuneConfig parse_tune_config(std::string_view text, const std::string& file);

/// Lines "key = value" that are equal for equal searches; the budget (generations, verdict_pairs)
/// is left out, because it may change.
std::vector<std::string> plan_lines(const TuneConfig& config);

/// A commented file for `cls tune init`, which is playable.
std::string commented_tune_config();

}  // namespace cls::tournament
