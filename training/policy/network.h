// A small neural network that gives the same bits on every processor: sums in a fixed order, in
// float, without fused operations. python/cls_gym/network.py computes the same bits.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/text/enum_names.h"

namespace cls::training {

enum class StepKind : std::uint8_t {
  kColumns,  ///< part of the features, or of another result with one row, as rows
  kNorm,     ///< x * scale + shift of each column
  kDense,    ///< of each row: a linear layer and its activation
  kPool,     ///< mean and maximum over the rows whose first column in the second input is above 0
  kConcat,   ///< the columns of the inputs side by side; those with one row join each row
  kFlatten,  ///< all rows as one
  kGru,      ///< a gated recurrent unit, whose state is its result
};
constexpr auto kStepKindNames =
    base::enum_names<StepKind>("columns", "norm", "dense", "pool", "concat", "flatten", "gru");

enum class Activation : std::uint8_t { kNone, kRelu, kTanh };
constexpr auto kActivationNames = base::enum_names<Activation>("none", "relu", "tanh");

/// One operation, as a file describes it.
struct StepPlan {
  StepKind kind = StepKind::kDense;
  std::vector<int> inputs;  ///< 0: the features; n: the result of step n - 1, which comes before
  int first = 0;            ///< kColumns: of the input
  int rows = 0;             ///< kColumns
  int width = 0;            ///< of a row of the result; kColumns, kDense, kGru
  Activation activation = Activation::kNone;  ///< kDense
};

/// Rows of numbers.
struct Grid {
  int rows = 0;
  int width = 0;
  std::vector<float> numbers;
};

/// An immutable list of steps, of which the last one gives the scores.
class Network {
 public:
  /// Limits of networks from files.
  static constexpr int kMaxSteps = 100;
  static constexpr int kMaxNumbers = 1 << 16;  ///< of a result
  static constexpr std::size_t kMaxWeights = 1 << 24;

  Network() = default;
  /// `weights`: of the steps in their order, row by row: of kNorm scale[in] and shift[in], of
  /// kDense weight[in, out] and bias[out], of kGru weight[in, 3 out], bias[3 out], weight[out, 3
  /// out] and bias[3 out], in the order reset, update, new. The error names the step.
  static base::Result<Network> make(int features, const std::vector<StepPlan>& steps,
                                    const std::vector<float>& weights);

  int features() const { return features_; }
  int scores() const;
  /// Numbers that are kept from one run to the next: the states of kGru.
  int memory() const { return memory_; }

  /// Results of a run, used again by the next one.
  struct Workspace {
    std::vector<Grid> results;
    std::vector<float> gates;
  };
  /// `memory` has memory() numbers, zeros at first. Returns scores() numbers, valid until the next
  /// run with this workspace. Does not allocate after the first run.
  const float* run(const float* features, float* memory, Workspace& workspace) const;

 private:
  /// Rows of weights are padded to whole blocks, so that blocks are computed alike.
  struct Layer {
    int inputs = 0;
    int outputs = 0;
    int padded = 0;
    std::vector<float> weight;
    std::vector<float> bias;

    void apply(const float* in, float* out) const;
  };
  struct Step {
    StepPlan plan;
    int rows = 0;
    int width = 0;
    std::vector<Layer> layers;  ///< kDense: one; kGru: of the input and of the state
    std::vector<float> scale;   ///< kNorm
    std::vector<float> shift;
    int state = 0;  ///< kGru: place of its state in the memory
  };
  class Builder;

  void run_step(const Step& step, float* memory, Workspace& workspace, std::size_t index) const;
  static void run_gru(const Step& step, const float* in, float* state, std::vector<float>& gates,
                      float* out);

  int features_ = 0;
  int memory_ = 0;
  std::vector<Step> steps_;
};

/// tanh by a rational function: exact operations only, an error of at most 4e-7.
float portable_tanh(float x);

}  // namespace cls::training
