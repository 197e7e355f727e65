#include "components/goalnet/training/checkpoint.h"

#include <array>
#include <cstring>
#include <filesystem>

#include <nlohmann/json.hpp>

namespace goalnet::inference::training {
namespace {

Expected<void> add(SafeTensorsWriter& writer, const std::string& name, const torch::Tensor& tensor) {
  const torch::Tensor flat = tensor.detach().contiguous();
  return writer.add(name,
                    {static_cast<std::uint64_t>(flat.size(0)), static_cast<std::uint64_t>(flat.size(1))},
                    {flat.data_ptr<float>(), static_cast<std::size_t>(flat.numel())});
}

Expected<void> read(const SafeTensors& file, const std::string& name, torch::Tensor& tensor) {
  const std::array<std::uint64_t, 2> shape = {static_cast<std::uint64_t>(tensor.size(0)),
                                              static_cast<std::uint64_t>(tensor.size(1))};
  const auto values = file.floats(name, shape);
  if (!values) return tl::unexpected(values.error());
  torch::NoGradGuard no_gradients;
  std::memcpy(tensor.data_ptr<float>(), values->values.data(), values->values.size() * sizeof(float));
  return {};
}

}  // namespace

Expected<void> write_checkpoint(const std::string& path, const std::string& identity,
                                const Adam::Parameters& parameters, const Adam& adam,
                                const std::vector<EpochReport>& curve) {
  SafeTensorsWriter writer;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto& [name, tensor] = parameters[i];
    for (const auto& [prefix, values] : {std::pair<const char*, const torch::Tensor*>{"weight.", &tensor},
                                         {"first.", &adam.first[i]},
                                         {"second.", &adam.second[i]}}) {
      if (auto done = add(writer, prefix + name, *values); !done) return done;
    }
  }
  nlohmann::json json = {{"identity", identity}, {"steps", adam.steps}, {"curve", nlohmann::json::array()}};
  for (const EpochReport& r : curve) {
    json["curve"].push_back(
        {r.epoch, r.epochs, r.loss, r.accuracy, r.held_out_loss, r.held_out_accuracy, r.seconds});
  }
  writer.metadata("goalnet.checkpoint", json.dump());
  return writer.write(path);
}

Expected<bool> read_checkpoint(const std::string& path, const std::string& identity,
                               Adam::Parameters& parameters, Adam& adam, std::vector<EpochReport>& curve) {
  if (!std::filesystem::exists(path)) return false;
  const auto file = SafeTensors::load(path);
  if (!file) return tl::unexpected(file.error());
  const auto text = file->metadata("goalnet.checkpoint");
  if (!text) return tl::unexpected(text.error());
  try {
    const auto json = nlohmann::json::parse(*text);
    if (json.at("identity") != identity) {
      return fail(Outcome::kInvalidRequest,
                  path +
                      " is the checkpoint of another training (other data, options or version); "
                      "remove it to start anew");
    }
    adam.steps = json.at("steps");
    curve.clear();
    for (const auto& r : json.at("curve"))
      curve.push_back({r.at(0), r.at(1), r.at(2), r.at(3), r.at(4), r.at(5), r.at(6), 0});
  } catch (const nlohmann::json::exception& error) {
    return fail(Outcome::kInvalidRequest, path + " is no checkpoint: " + error.what());
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string& name = parameters[i].first;
    for (const auto& [prefix, values] :
         {std::pair<const char*, torch::Tensor*>{"weight.", &parameters[i].second},
          {"first.", &adam.first[i]},
          {"second.", &adam.second[i]}}) {
      if (auto done = read(*file, prefix + name, *values); !done) return tl::unexpected(done.error());
    }
  }
  return true;
}

}  // namespace goalnet::inference::training
