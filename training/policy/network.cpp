// Builds networks from files' descriptions, and runs them.
#include "training/policy/network.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "base/index.h"

namespace cls::training {
namespace {

using base::Error;
using base::Result;

// Four numbers that a processor with vectors computes together: each as if it were alone.
using Four = float __attribute__((vector_size(16)));
constexpr int kFours = 4;
constexpr int kBlock = 4 * kFours;

Four load(const float* from) {
  Four four;
  std::memcpy(&four, from, sizeof four);
  return four;
}
void store(Four four, float* to) { std::memcpy(to, &four, sizeof four); }

float sigmoid(float x) { return 0.5F * portable_tanh(0.5F * x) + 0.5F; }

void activate(Activation activation, float* numbers, int count) {
  for (int i = 0; i < count && activation == Activation::kRelu; ++i) {
    numbers[i] = numbers[i] > 0.0F ? numbers[i] : 0.0F;
  }
  for (int i = 0; i < count && activation == Activation::kTanh; ++i) {
    numbers[i] = portable_tanh(numbers[i]);
  }
}

void pool(const Grid& values, const Grid& there, float* out) {
  const int width = values.width;
  std::fill_n(out, 2 * width, 0.0F);
  int count = 0;
  for (int row = 0; row < values.rows; ++row) {
    if (!(there.numbers[base::index(row * there.width)] > 0.0F)) continue;
    const float* from = &values.numbers[base::index(row * width)];
    for (int i = 0; i < width; ++i) {
      out[i] += from[i];
      out[width + i] = count == 0 || from[i] > out[width + i] ? from[i] : out[width + i];
    }
    ++count;
  }
  for (int i = 0; i < width && count > 0; ++i) out[i] /= static_cast<float>(count);
}

}  // namespace

float portable_tanh(float x) {
  constexpr float kEnd = 7.9F;  // nearer to 1 than floats are to each other
  const float y = x > kEnd ? kEnd : x < -kEnd ? -kEnd : x;
  const float z = y * y;
  float p = -2.76076847742355e-16F;
  for (const float c : {2.00018790482477e-13F, -8.60467152213735e-11F, 5.12229709037114e-08F,
                        1.48572235717979e-05F, 6.37261928875436e-04F, 4.89352455891786e-03F}) {
    p = p * z + c;
  }
  float q = 1.19825839466702e-06F;
  for (const float c : {1.18534705686654e-04F, 2.26843463243900e-03F, 4.89352518554385e-03F}) {
    q = q * z + c;
  }
  return y * p / q;
}

/// Checks the steps in their order and takes their weights.
class Network::Builder {
 public:
  Builder(Network& network, const std::vector<float>& weights)
      : network_(network), weights_(weights) {}

  Result<void> add(const StepPlan& plan) {
    const auto wrong = [this](std::string_view what) {
      return Error{fmt::format("step {}: {}", network_.steps_.size() + 1, what)};
    };
    if (plan.inputs.empty()) return wrong("has no input");
    for (const int input : plan.inputs) {
      if (input < 0 || input > std::ssize(network_.steps_)) return wrong("an input does not exist");
    }

    Step step;
    step.plan = plan;
    if (const std::string_view what = shape(step); !what.empty()) return wrong(what);
    if (step.rows < 1 || step.width < 1 || step.rows > kMaxNumbers / step.width) {
      return wrong("its size is out of range");
    }
    if (!take_weights(step)) return wrong("has fewer weights than it needs");
    network_.steps_.push_back(std::move(step));
    return {};
  }

  bool used_all() const { return used_ == weights_.size(); }

 private:
  int rows_of(int input) const {
    return input == 0 ? 1 : network_.steps_[base::index(input - 1)].rows;
  }
  int width_of(int input) const {
    return input == 0 ? network_.features_ : network_.steps_[base::index(input - 1)].width;
  }

  /// Sets the shape of the result; returns what is wrong.
  std::string_view shape(Step& step) const {
    const StepPlan& plan = step.plan;
    const int input = plan.inputs.front();
    const std::size_t wanted = plan.kind == StepKind::kPool ? 2 : 1;
    if (plan.kind != StepKind::kConcat && plan.inputs.size() != wanted) {
      return "has another number of inputs";
    }

    step.rows = rows_of(input);
    step.width = width_of(input);

    switch (plan.kind) {
      case StepKind::kNorm:
        return "";
      case StepKind::kColumns:
        step.rows = plan.rows;
        step.width = plan.width;
        if (rows_of(input) != 1) return "its input has more than one row";
        if (plan.first < 0 || plan.rows < 1 || plan.width < 1 ||
            plan.rows > (width_of(input) - plan.first) / plan.width) {
          return "its input has fewer columns";
        }
        return "";
      case StepKind::kDense:
        step.width = plan.width;
        return "";
      case StepKind::kGru:
        step.width = plan.width;
        return step.rows == 1 ? "" : "its input has more than one row";
      case StepKind::kPool:
        step.width *= 2;
        if (rows_of(plan.inputs[1]) != step.rows) return "its inputs have not the same rows";
        step.rows = 1;
        return "";
      case StepKind::kFlatten:
        step.width *= step.rows;
        step.rows = 1;
        return "";
      case StepKind::kConcat:
        return shape_of_concat(step);
    }
    return "is unknown";
  }

  std::string_view shape_of_concat(Step& step) const {
    step.width = 0;
    for (const int input : step.plan.inputs) {
      step.rows = std::max(step.rows, rows_of(input));
      step.width += width_of(input);
      if (step.width > kMaxNumbers) return "its size is out of range";
    }
    for (const int input : step.plan.inputs) {
      if (rows_of(input) != 1 && rows_of(input) != step.rows) {
        return "its inputs have not the same rows";
      }
    }
    return "";
  }

  bool take_weights(Step& step) {
    const int in = width_of(step.plan.inputs.front());
    switch (step.plan.kind) {
      case StepKind::kNorm:
        return take(base::index(in), step.scale) && take(base::index(in), step.shift);
      case StepKind::kDense:
        return take_layer(in, step.width, step);
      case StepKind::kGru:
        if (step.width > kMaxNumbers / 3) return false;
        step.state = network_.memory_;
        network_.memory_ += step.width;
        return take_layer(in, 3 * step.width, step) && take_layer(step.width, 3 * step.width, step);
      default:
        return true;
    }
  }

  bool take(std::size_t count, std::vector<float>& out) {
    if (count > weights_.size() - used_) return false;
    const auto from = weights_.begin() + static_cast<std::ptrdiff_t>(used_);
    out.assign(from, from + static_cast<std::ptrdiff_t>(count));
    used_ += count;
    return true;
  }

  bool take_layer(int inputs, int outputs, Step& step) {
    Layer layer;
    layer.inputs = inputs;
    layer.outputs = outputs;
    layer.padded = (outputs + kBlock - 1) / kBlock * kBlock;
    std::vector<float> weight;
    std::vector<float> bias;
    const std::size_t count = base::index(inputs) * base::index(outputs);
    if (!take(count, weight) || !take(base::index(outputs), bias)) return false;

    layer.weight.resize(base::index(inputs) * base::index(layer.padded));
    for (int i = 0; i < inputs; ++i) {
      std::copy_n(weight.begin() + std::ptrdiff_t{i} * outputs, outputs,
                  layer.weight.begin() + std::ptrdiff_t{i} * layer.padded);
    }
    bias.resize(base::index(layer.padded));
    layer.bias = std::move(bias);
    step.layers.push_back(std::move(layer));
    return true;
  }

  Network& network_;
  const std::vector<float>& weights_;
  std::size_t used_ = 0;
};

Result<Network> Network::make(int features, const std::vector<StepPlan>& steps,
                              const std::vector<float>& weights) {
  if (features < 1 || features > kMaxNumbers)
    return Error{"the number of features is out of range"};
  if (steps.empty() || steps.size() > kMaxSteps) return Error{"must have 1 to 100 steps"};
  if (!std::ranges::all_of(weights, [](float one) { return std::isfinite(one); })) {
    return Error{"a weight is not a finite number"};
  }

  Network network;
  network.features_ = features;
  Builder builder(network, weights);
  for (const StepPlan& step : steps) TRY(builder.add(step));
  if (!builder.used_all()) return Error{"has more weights than its steps need"};
  return network;
}

int Network::scores() const {
  return steps_.empty() ? 0 : steps_.back().rows * steps_.back().width;
}

// Of each output: the bias, then the products in the order of the inputs.
void Network::Layer::apply(const float* in, float* out) const {
  for (int block = 0; block < padded; block += kBlock) {
    std::array<Four, kFours> sums;
    for (int k = 0; k < kFours; ++k) sums[base::index(k)] = load(&bias[base::index(block + 4 * k)]);
    const float* row = &weight[base::index(block)];
    for (int i = 0; i < inputs; ++i, row += padded) {
      const Four x = {in[i], in[i], in[i], in[i]};
      for (int k = 0; k < kFours; ++k) sums[base::index(k)] += x * load(row + 4 * k);
    }

    std::array<float, kBlock> results;
    for (int k = 0; k < kFours; ++k) store(sums[base::index(k)], &results[base::index(4 * k)]);
    std::copy_n(results.begin(), std::min(kBlock, outputs - block), out + block);
  }
}

void Network::run_step(const Step& step, float* memory, Workspace& workspace,
                       std::size_t index) const {
  const auto input = [&](std::size_t i) -> const Grid& {
    return workspace.results[base::index(step.plan.inputs[i])];
  };
  const Grid& in = input(0);
  float* out = workspace.results[index].numbers.data();

  switch (step.plan.kind) {
    case StepKind::kColumns:
      std::copy_n(in.numbers.begin() + step.plan.first, step.rows * step.width, out);
      break;
    case StepKind::kFlatten:
      std::ranges::copy(in.numbers, out);
      break;
    case StepKind::kNorm:
      for (std::size_t i = 0; i < in.numbers.size(); ++i) {
        const std::size_t column = i % base::index(in.width);
        out[i] = in.numbers[i] * step.scale[column] + step.shift[column];
      }
      break;
    case StepKind::kDense:
      for (int row = 0; row < step.rows; ++row) {
        step.layers[0].apply(&in.numbers[base::index(row * in.width)], out + row * step.width);
      }
      activate(step.plan.activation, out, step.rows * step.width);
      break;
    case StepKind::kPool:
      pool(in, input(1), out);
      break;
    case StepKind::kConcat:
      for (int row = 0; row < step.rows; ++row) {
        for (std::size_t i = 0; i < step.plan.inputs.size(); ++i) {
          const Grid& part = input(i);
          const int from = part.rows == 1 ? 0 : row * part.width;
          out = std::copy_n(part.numbers.begin() + from, part.width, out);
        }
      }
      break;
    case StepKind::kGru:
      run_gru(step, in.numbers.data(), memory + step.state, workspace.gates, out);
      break;
  }
}

// The state becomes (1 - update) * new + update * state.
void Network::run_gru(const Step& step, const float* in, float* state, std::vector<float>& gates,
                      float* out) {
  const auto width = base::index(step.width);
  gates.resize(6 * width);
  float* from_input = gates.data();
  float* from_state = from_input + 3 * width;
  step.layers[0].apply(in, from_input);
  step.layers[1].apply(state, from_state);

  for (std::size_t i = 0; i < width; ++i) {
    const float reset = sigmoid(from_input[i] + from_state[i]);
    const float update = sigmoid(from_input[width + i] + from_state[width + i]);
    const float next = portable_tanh(from_input[2 * width + i] + reset * from_state[2 * width + i]);
    out[i] = (1.0F - update) * next + update * state[i];
  }
  std::copy_n(out, width, state);
}

const float* Network::run(const float* features, float* memory, Workspace& workspace) const {
  std::vector<Grid>& results = workspace.results;
  results.resize(steps_.size() + 1);
  results[0].rows = 1;
  results[0].width = features_;
  results[0].numbers.assign(features, features + features_);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    Grid& result = results[i + 1];
    result.rows = steps_[i].rows;
    result.width = steps_[i].width;
    result.numbers.resize(base::index(result.rows * result.width));
    run_step(steps_[i], memory, workspace, i + 1);
  }
  return results.back().numbers.data();
}

}  // namespace cls::training
