#include "components/goalnet/goal_model.h"
#include "components/goalnet/network/network_model.h"
#include "components/goalnet/ranker/ranker_model.h"
#include "components/goalnet/safetensors.h"

namespace goalnet::inference {

Expected<std::unique_ptr<GoalModel>> load_model(const std::filesystem::path& path, ModelUse use) {
  constexpr TensorLimits kLimits{.max_file_bytes = 64ull << 20};
  const auto file = SafeTensors::load(path.string(), kLimits);
  if (!file) return tl::unexpected(file.error());
  const auto kind = file->metadata("goalnet.kind");
  if (!kind) return tl::unexpected(kind.error());
  if (*kind == "network") return make_network_model(*file);
  if (*kind != "ranker")
    return fail(Outcome::kInvalidRequest,
                path.string() + ": unknown kind of model \"" + *kind + "\"; known: ranker, network");
  auto parts = read_ranker(*file);
  if (!parts) return tl::unexpected(parts.error());
  auto model = std::make_unique<RankerModel>(std::move(*parts), use);
  if (use == ModelUse::kRobot)
    if (auto read = model->read_language(); !read) return tl::unexpected(read.error());
  return model;
}

}  // namespace goalnet::inference
