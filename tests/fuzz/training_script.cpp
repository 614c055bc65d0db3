// Plays training scripts.
#include "tests/fuzz/training_script.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/text/json.h"
#include "base/text/number_text.h"
#include "tests/fuzz/require.h"
#include "tests/training/stage.h"

namespace cls::tests {
namespace {

// The report of a broken promise has the last error of the engine.
void promise(bool kept, const char* what) { require(kept, what, cls_training_error()); }

constexpr int kMaxSteps = 60;

// A failure has one line of text that names its cause.
bool succeeds(int code) {
  if (code == CLS_TRAINING_OK) return true;
  const std::string_view text = cls_training_error();
  promise(code != CLS_TRAINING_INTERNAL, "no internal error");
  promise(!text.empty() && text.find('\n') == std::string_view::npos, "one line");
  return false;
}

// The setup with a few worlds; none if it has so many threads, agents or skipped cycles that a run
// would take long.
std::string smaller(std::string_view config) {
  constexpr int kMaxWorlds = 3;
  auto json = base::Json::parse_or_discarded(config);
  if (!json.is_object()) return std::string(config);
  const auto limit = [&json](const char* key, int most) {
    const base::Json* found = json.find(key);
    if (found != nullptr && found->is_number() && found->get<double>() > most) json[key] = most;
  };
  limit("num_envs", kMaxWorlds);
  limit("threads", 2);
  limit("frame_skip", 4);
  return json.dump();
}

class Pool {
 public:
  explicit Pool(const std::string& config) : pool_(config) {}

  void play(std::string_view line) {
    const char kind = line.empty() ? '.' : line.front();
    const std::string argument(line.substr(std::min<std::size_t>(2, line.size())));
    const std::uint64_t handle = pool_.handle;
    if (kind == 'r') check(pool_.reset(static_cast<std::uint64_t>(first_number(argument))));
    if (kind == 'a') set_actions(argument);
    if (kind == 's' && steps_ < kMaxSteps) {
      ++steps_;
      check(pool_.step());
    }
    if (kind == 'o') succeeds(cls_training_set_options(handle, -1, argument.c_str()));
    if (kind == 'k') succeeds(cls_training_snapshot(handle, 0, &snapshot_));
    if (kind == 'p') check(cls_training_restore(handle, pool_.worlds - 1, snapshot_));
    if (kind == 'f') check(cls_training_fork(handle, 0, pool_.worlds - 1));
    if (kind == 'v') look();
    if (kind == 'b') bind(static_cast<std::size_t>(first_number(argument)));
  }

  int steps() const { return steps_; }

 private:
  static int first_number(const std::string& text) {
    int number = 0;
    return base::parse_int_prefix(text, number) > 0 ? std::abs(number) : 1;
  }

  // After a call that fills rows.
  void check(int code) {
    if (!succeeds(code)) return;
    const auto finite = [](float value) { return std::isfinite(value); };
    for (const auto* values : {&pool_.observations, &pool_.rewards, &pool_.state}) {
      promise(std::all_of(values->begin(), values->end(), finite), "what is written is finite");
    }
  }

  void set_actions(const std::string& text) {
    std::vector<float> numbers;
    const char* at = text.c_str();
    for (char* end = nullptr; numbers.size() < 1000; at = end) {
      numbers.push_back(std::strtof(at, &end));
      if (end == at) break;
    }
    std::size_t next = 0;
    for (std::int32_t& id : pool_.action_ids) {
      const float number = numbers[next++ % numbers.size()];
      id = std::abs(number) < 1e6F ? static_cast<std::int32_t>(number) : -1;
    }
    for (float& value : pool_.action_values) value = numbers[next++ % numbers.size()];
    for (std::uint64_t& seed : pool_.next_seeds) seed = next++;
  }

  void look() const {
    cls_training_world world = {};
    world.struct_size = sizeof world;
    if (!succeeds(cls_training_view(pool_.handle, 0, &world))) return;
    promise(std::isfinite(world.ball_x) && std::isfinite(world.ball_vy), "the ball is somewhere");
  }

  void bind(std::size_t which) {
    cls_training_buffers changed = pool_.buffers;
    auto* buffers = &changed.action_ids;
    const std::size_t count = (sizeof changed - sizeof changed.struct_size) / sizeof *buffers;
    cls_training_buffer& one = buffers[which % count];
    one.count += 1;
    if (one.data != nullptr) promise(!succeeds(cls_training_bind(pool_.handle, &changed)), "sizes");
  }

  BoundPool pool_;
  std::uint64_t snapshot_ = 0;
  int steps_ = 0;
};

}  // namespace

int play_training_script(std::string_view script) {
  std::optional<Pool> pool;
  bool first = true;
  while (!script.empty()) {
    const std::string_view line = script.substr(0, script.find('\n'));
    script.remove_prefix(std::min(line.size() + 1, script.size()));
    if (pool) pool->play(line);
    if (!std::exchange(first, false)) continue;
    try {
      pool.emplace(smaller(line));
    } catch (const std::runtime_error& refusal) {
      std::uint64_t handle = 0;
      const int code = cls_training_create(std::string(line).c_str(), &handle);
      promise(code != CLS_TRAINING_OK && *refusal.what() != '\0', "refused with a reason");
      return 0;
    }
  }
  return pool ? pool->steps() : 0;
}

}  // namespace cls::tests
