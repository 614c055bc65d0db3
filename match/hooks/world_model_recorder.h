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
#include "match/hooks/match_hooks.h"
#include "viewer/decisions/decision_writer.h"

namespace cls::match {

/// Texts and drawings of a team beyond this are left out.
constexpr std::size_t kMaxDrawings = std::size_t{64} << 20;

/// Writes viewer::kLeftWorldModelsFile and kRightWorldModelsFile into the match folder; each is
/// created with the first decision of its side. In lockstep the same match gives the same
/// decisions, in the same order; their latencies differ.
class WorldModelRecorder : public MatchHooks {
 public:
  WorldModelRecorder(const std::filesystem::path& folder, const std::string& left_name,
                     const std::string& right_name);

  SideListener* listener(soccer::Side side) override;

  /// Writes the remaining decisions. Returns the error, or an empty string.
  std::string close();

 private:
  class SideRecorder : public SideListener, public proxy::DecisionListener {
   public:
    SideRecorder(soccer::Side side, std::string team, std::filesystem::path file)
        : side_(side), team_(std::move(team)), file_(std::move(file)) {}
    proxy::DecisionListener* decisions() override { return this; }
    bool needs_calls() const override { return false; }
    void on_call(const proxy::RpcCall& /*call*/) override {}
    void on_decision(const proxy::Decision& decision) override;
    void end_cycle() override;
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

  std::array<SideRecorder, 2> sides_;
};

}  // namespace cls::match
