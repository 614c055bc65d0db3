// `--record-world-models`: what each player estimated, received and sent, for the decision debugger
// of `cls watch` (viewer/decisions).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "base/io/byte_sink.h"
#include "match/hooks/decision_stream.h"
#include "match/hooks/side_hooks.h"
#include "match/terms/endpoint.h"

namespace cls::match {

/// Records one side.
class WorldModelsOfSide : public SideDecisions {
 public:
  WorldModelsOfSide(soccer::Side side, std::string team, std::filesystem::path file)
      : stream_(side, std::move(team)), file_(std::move(file)) {}

  void on_decision(const proxy::Decision& decision) override { stream_.on_decision(decision); }
  void end_cycle() override;
  /// Writes the remaining decisions. Returns the error, or an empty string.
  std::string close();

 private:
  void write();

  DecisionStream stream_;
  std::filesystem::path file_;
  std::unique_ptr<base::ByteSink> sink_;
  std::string bytes_;  ///< not written yet
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
