// Reads and replays logs, formats misses.
#include "tests/simulator/replay/replayed_logs.h"

#include <stdexcept>
#include <utility>

namespace cls::simulator {

Logs read_logs(const std::filesystem::path& stem) {
  return {*gamelog::read_rcg_file(stem.string() + ".rcg.gz"),
          *gamelog::read_rcl_file(stem.string() + ".rcl.gz")};
}

LogAgreement replay(const Logs& logs) {
  auto agreement = replay_log(logs.game, logs.text);
  if (!agreement) throw std::runtime_error(agreement.error().message);
  return *std::move(agreement);
}

std::string all_misses(const LogAgreement& agreement) {
  std::string text;
  for (const Miss& miss : agreement.misses) {
    text += std::to_string(miss.clock.time) + ',' + std::to_string(miss.clock.stoppage) + " slot " +
            std::to_string(miss.slot) + ' ' + std::string(name(miss.step_class)) + ": " +
            miss.what + '\n';
  }
  for (const std::string& miss : agreement.game_misses) text += miss + '\n';
  for (const std::string& call : agreement.missing_calls) text += "only recorded: " + call + '\n';
  for (const std::string& call : agreement.extra_calls) text += "only simulated: " + call + '\n';
  return text;
}

}  // namespace cls::simulator
