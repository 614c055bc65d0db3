// The hypotheses of a comparison on the mean of its samples.
#pragma once

#include <string>

#include "league/rating/hypotheses.h"
#include "tournament/report/comparison.h"

namespace cls::tournament {

/// The most that a match may contribute to a sample, in either direction: points or goals.
int limit_of(const Comparison& comparison, Measure measure);
/// The same in steps of counted_value().
int steps_of(const Comparison& comparison, Measure measure);

Hypotheses hypotheses_of(const Comparison& comparison);

/// The variance of a sample when a fifth of the matches are draws and the matches of a pair share
/// half of their randomness, as in the table of docs/tournaments.md; of goals when the difference
/// of a match has a standard deviation of about two.
double typical_variance(const Comparison& comparison);

/// One line that names the test, its hypotheses and its errors.
std::string model_text(const Comparison& comparison);

}  // namespace cls::tournament
