#include "tools/bench/infer/peer.h"

namespace goalnet::tools {

std::function<void(std::size_t)> make_infer_peer(const inference::SafeTensors&,
                                                 const std::vector<InferStep>&) {
  return {};
}

}  // namespace goalnet::tools
