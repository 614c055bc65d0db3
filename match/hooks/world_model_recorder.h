// `--record-world-models`: what each player estimated, received and sent, for the decision debugger
// of `cls watch` (viewer/decisions).
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/io/byte_sink.h"
#include "match/hooks/side_hooks.h"
#include "match/terms/endpoint.h"
#include "viewer/decisions/decision_writer.h"

namespace cls::match {

/// Texts and drawings of a team beyond this are left out.
constexpr std::size_t kMaxDrawings = std::size_t{64} << 20;

/// Records one side.
class WorldModelsOfSide : public SideDecisions {
 public:
  WorldModelsOfSide(soccer::Side side, std::string team, std::filesystem::path file)
      : side_(side), team_(std::move(team)), file_(std::move(file)) {}

  void on_decision(const proxy::Decision& decision) override;
  void end_cycle() override { write(); }
  /// Writes the remaining decisions. Returns the error, or an empty string.
  std::string close();

 private:
  void write();

  soccer::Side side_;
  std::string team_;
  std::filesystem::path file_;
  std::unique_ptr<base::ByteSink> sink_;
  viewer::DecisionWriter writer_;
  std::array<std::vector<viewer::DecisionSample>, soccer::kPlayersPerTeam> waiting_;
  std::string bytes_;
  std::size_t room_ = kMaxDrawings;
  std::string error_;
};

/// Writes viewer::kLeftWorldModelsFile and kRightWorldModelsFile into the match folder; each is
/// created with the first decision of its side. In lockstep the same match gives the same
/// decisions, in the same order; their latencies differ.
class WorldModelRecorder : public SideHooks<WorldModelsOfSide> {
 public:
  WorldModelRecorder(const std::filesystem::path& folder, const TeamNames& names);
};

}  // namespace cls::match
