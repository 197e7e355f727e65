// Whatever an instruction holds: bounded words or one message.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "components/goalnet/tokenizer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace goalnet::inference;
  const auto words = tokenize({reinterpret_cast<const char*>(data), size});
  if (!words) {
    if (words.error().message.empty()) std::abort();
    return 0;
  }
  if (words->size() > kMaxWords + 1) std::abort();
  for (const std::string& word : *words)
    if (word.empty() || word.find(' ') != std::string::npos) std::abort();
  return 0;
}
