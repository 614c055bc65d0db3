// Bradley-Terry ratings of all teams from all matches.
#pragma once

#include <span>
#include <vector>

namespace cls::league {

/// All results between two teams; draws are half a win for each.
struct PairResults {
  int first = 0;
  int second = 0;
  double first_points = 0.0;  ///< wins and half of the draws of `first`
  double games = 0.0;
};

/// Ratings in Elo, their mean over all teams 0.
struct Ratings {
  std::vector<double> elo;
  std::vector<double> error;                     ///< half of the 95 % interval, against the mean
  std::vector<std::vector<double>> superiority;  ///< likelihood that row is better than column
};

/// Maximum-likelihood fit of the Bradley-Terry model, P(i beats j) = g_i / (g_i + g_j). Every team
/// also has one virtual draw against the average team. That keeps ratings finite where a team won
/// or lost every match, and where groups of teams never met. Errors come from the inverse of the
/// information matrix; draws and paired seeds make the true errors smaller. `teams` is their
/// number.
Ratings fit_bradley_terry(int teams, std::span<const PairResults> results);

}  // namespace cls::league
