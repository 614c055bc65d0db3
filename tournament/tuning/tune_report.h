// The result of a tuning as text, JSON and a picture.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "tournament/tuning/tuning.h"

namespace cls::tournament {

/// The final comparison of the best values with the start values, once it was played.
struct TuneVerdict {
  std::string text;     ///< as `cls compare` prints it
  std::string verdict;  ///< "better", "not better", "undecided"
};

/// One line: "generation 3/20: -0.12 goals a match (-0.45 to +0.21)  speed 2.4  power 61".
std::string generation_line(const Tuning& tuning);

/// A mean of pairs with its 95 % interval: "+0.12 goals a match (-0.21 to +0.45)".
std::string score_text(const TuneConfig& config, const Estimate& score);

/// At most `width` characters per line: a table of the parameters, their difference as a diff, and
/// the verdict.
std::string tune_text(const Tuning& tuning, const std::optional<TuneVerdict>& verdict,
                      std::size_t width);

/// The document cls.tune/1.
std::string tune_json(const Tuning& tuning, const std::optional<TuneVerdict>& verdict);

/// Scores and parameters over the generations, as an SVG file.
std::string tune_picture(const Tuning& tuning);

/// "-NAME = OLD" and "+NAME = NEW" for each parameter that changed.
std::string values_diff(const TuneConfig& config, const Values& before, const Values& after);

}  // namespace cls::tournament
