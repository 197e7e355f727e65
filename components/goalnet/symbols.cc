#include "components/goalnet/symbols.h"

namespace goalnet::inference {
namespace {

std::string lower(std::string_view name) {
  std::string text(name);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c | 0x20);
  return text;
}

}  // namespace

Symbols::Symbols() {
  for (const char* known : {
#define GOALNET_SYMBOL(name) #name,
           GOALNET_SYMBOLS(GOALNET_SYMBOL)
#undef GOALNET_SYMBOL
       })
    intern(known);
}

Symbol Symbols::intern(std::string_view name) {
  const auto [it, added] = numbers_.try_emplace(lower(name), static_cast<Symbol>(names_.size()));
  if (!added) return it->second;
  if (names_.size() >= kMaxSymbols) {
    numbers_.erase(it);
    return symbol::kNone;
  }
  names_.emplace_back(name);
  return it->second;
}

Symbol Symbols::find(std::string_view name) const {
  const auto it = numbers_.find(lower(name));
  return it == numbers_.end() ? Symbol{symbol::kNone} : it->second;
}

}  // namespace goalnet::inference
