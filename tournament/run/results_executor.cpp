// "Plays" matches that were played elsewhere: takes their results from a file.
#include <utility>

#include "tournament/run/match_executor.h"
#include "tournament/store/results_file.h"

namespace cls::tournament {
namespace {

using base::Result;

class ResultsExecutor : public MatchExecutor {
 public:
  ResultsExecutor(const TournamentConfig& config, ResultsFile results)
      : config_(config), results_(std::move(results)) {}

  int free_slots() const override { return 1; }
  int running() const override { return static_cast<int>(finished_.size()); }

  Result<void> start(std::span<const Assignment> assignments) override {
    for (const Assignment& assignment : assignments) {
      TRY_INIT(auto outcome, results_.find(config_, assignment.fixture));
      outcome.attempts = assignment.number;
      finished_.push_back({assignment.fixture.index, std::move(outcome)});
    }
    return {};
  }

  Result<std::vector<FinishedMatch>> wait(std::chrono::milliseconds /*limit*/) override {
    return std::exchange(finished_, {});
  }

  void interrupt() override {}

 private:
  const TournamentConfig& config_;
  ResultsFile results_;
  std::vector<FinishedMatch> finished_;
};

}  // namespace

Result<std::unique_ptr<MatchExecutor>> results_executor(const TournamentConfig& config,
                                                        const std::filesystem::path& file) {
  TRY_INIT(auto results, ResultsFile::read(file, config));
  return std::unique_ptr<MatchExecutor>(
      std::make_unique<ResultsExecutor>(config, std::move(results)));
}

}  // namespace cls::tournament
