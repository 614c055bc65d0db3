// Samples of a comparison in which NEW and BASE played the same: their difference had no effect.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "league/matches/fixture.h"
#include "tournament/report/comparison.h"

namespace cls::cli {

/// True if both text logs exist and hold the same commands of the left team and of the right team,
/// agent by agent in all cycles, whatever the names of the teams.
bool have_same_commands(const std::filesystem::path& match, const std::filesystem::path& other);

/// Compares the logs of each sample once, when it is complete.
class AlikeSamples {
 public:
  /// `folder` is that of the comparison.
  AlikeSamples(const tournament::Comparison& comparison, std::filesystem::path folder)
      : comparison_(comparison), folder_(std::move(folder)) {}

  /// Reads what is new in `matches`, in the order of the schedule. A line to print when the first
  /// sample turned out alike, otherwise empty.
  std::string look_at(std::span<const tournament::ScheduledMatch> matches);

  /// Samples so far in which NEW and BASE sent the same commands.
  std::size_t count() const { return alike_; }

  /// "in 3 of 14 pairs NEW and BASE sent the same commands in all cycles".
  std::string text() const;

 private:
  bool is_alike(std::span<const tournament::ScheduledMatch> sample) const;

  const tournament::Comparison& comparison_;
  std::filesystem::path folder_;
  std::size_t samples_ = 0;
  std::size_t alike_ = 0;
};

}  // namespace cls::cli
