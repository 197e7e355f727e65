#include "tools/bench/infer.h"

#include <chrono>
#include <stdexcept>

#include "components/core/config_path.h"
#include "components/goalnet/network/network_core.h"
#include "components/goalnet/network/network_model.h"
#include "components/goalnet/tokenizer.h"
#include "tools/bench/infer/peer.h"
#include "tools/bench/infer/steps.h"

namespace goalnet::tools {
namespace {

using namespace inference;

template <class T>
T need(Expected<T> value) {
  if (!value) throw std::runtime_error(value.error().message);
  return std::move(*value);
}

// Microseconds of each of `count` calls, steps in turn.
template <class Call>
std::vector<double> measure(const std::vector<InferStep>& steps, int count, Call call) {
  std::vector<double> sample;
  sample.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const InferStep& step = steps[static_cast<std::size_t>(i) % steps.size()];
    const auto begin = std::chrono::steady_clock::now();
    call(step);
    sample.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
  }
  return sample;
}

}  // namespace

nlohmann::json bench_infer(const BenchOptions& options) {
  const std::string path = config_path("models/goalnet_network.safetensors");
  const SafeTensors file = need(SafeTensors::load(path));
  network::NetworkCore core(need(network::load_parts(file)));
  const std::unique_ptr<GoalModel> model = need(make_network_model(file));
  const std::vector<InferStep> steps = infer_steps();
  const int count = options.quick ? 300 : 5000;

  std::vector<std::vector<std::string>> words;
  for (const InferStep& step : steps) words.push_back(need(tokenize(step.sentence)));
  const auto run = [&](const InferStep& step) { need(core.step(step.input())); };
  const auto with_sentence = [&](const InferStep& step) {
    core.encode_sentence();
    run(step);
  };
  nlohmann::json result;
  std::vector<double> core_times, same_times;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::vector<InferStep> one = {steps[i]};
    core.set_words(words[i]);
    measure(one, 50, with_sentence);
    const int share = count / static_cast<int>(steps.size());
    const auto fresh = measure(one, share, with_sentence), same = measure(one, share, run);
    core_times.insert(core_times.end(), fresh.begin(), fresh.end());
    same_times.insert(same_times.end(), same.begin(), same.end());
  }
  result["core"] = summary(core_times, "us");
  result["core_same_sentence"] = summary(same_times, "us");
  const auto whole = [&](const InferStep& step) { static_cast<void>(model->infer(step.input())); };
  measure(steps, 100, whole);
  result["model"] = summary(measure(steps, count, whole), "us");
  result["model_file"] = path;
  if (const auto peer = make_infer_peer(file, steps)) {
    const int peer_count = options.quick ? 50 : 300;
    for (int i = 0; i < 30; ++i) peer(static_cast<std::size_t>(i) % steps.size());
    std::vector<double> sample;
    for (int i = 0; i < peer_count; ++i) {
      const auto begin = std::chrono::steady_clock::now();
      peer(static_cast<std::size_t>(i) % steps.size());
      sample.push_back(
          std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
    }
    result["libtorch"] = summary(sample, "us");
    result["times_faster"] =
        result["libtorch"]["median_us"].get<double>() / result["core"]["median_us"].get<double>();
  }
  return result;
}

}  // namespace goalnet::tools
