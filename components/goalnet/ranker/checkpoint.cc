#include "components/goalnet/ranker/checkpoint.h"

#include <filesystem>

#include "components/goalnet/safetensors.h"

namespace goalnet::inference {
namespace {

constexpr const char* kIdentity = "goalnet.training";

}  // namespace

Expected<Checkpoint> Checkpoint::open(const std::string& path, const std::string& identity) {
  Checkpoint checkpoint;
  checkpoint.path_ = path;
  checkpoint.identity_ = identity;
  std::error_code error;
  if (path.empty() || !std::filesystem::exists(path, error)) return checkpoint;
  const auto file = SafeTensors::load(path);
  if (!file)
    return fail(Outcome::kInvalidRequest,
                "checkpoint " + file.error().message + "; remove it (--fresh) to start anew");
  const auto written = file->metadata().find(kIdentity);
  if (written == file->metadata().end() || written->second != identity)
    return fail(Outcome::kInvalidRequest,
                path +
                    " is the checkpoint of another training (other data, options or version); remove it "
                    "(--fresh) to start anew");
  for (const auto& [stage, entry] : file->tensors()) {
    const std::uint64_t any[] = {0};
    auto values = file->floats(stage, any);
    if (!values) return tl::unexpected(values.error());
    checkpoint.stages_[stage] = std::move(values->values);
  }
  return checkpoint;
}

const std::vector<float>* Checkpoint::find(const std::string& stage) const {
  const auto it = stages_.find(stage);
  return it == stages_.end() ? nullptr : &it->second;
}

Expected<void> Checkpoint::keep(const std::string& stage, std::vector<float> values) {
  if (path_.empty()) return {};
  stages_[stage] = std::move(values);
  SafeTensorsWriter writer;
  writer.metadata(kIdentity, identity_);
  for (const auto& [name, numbers] : stages_)
    if (auto ok = writer.add(name, {numbers.size()}, numbers); !ok) return ok;
  return writer.write(path_);
}

}  // namespace goalnet::inference
