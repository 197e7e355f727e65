// The tables of config/language: the first byte says which of them the text stands for; the others are small.
// What is accepted is used to read a sentence.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "components/goalnet/language/background.h"
#include "components/goalnet/language/language.h"
#include "components/goalnet/language/reading_confidence.h"
#include "components/goalnet/language/words.h"
#include "components/goalnet/lexicon.h"

namespace {

using namespace goalnet;
using namespace goalnet::inference;

constexpr std::string_view kHousehold =
    R"({"classes": {"mug": {"kinds": ["movable", "vessel"], "objects": ["Mug_1"], "names": ["mug"], "also": ["cup"]}},
        "objects": {"Mug_1": ["red mug"]}, "rooms": {"kitchen": ["Mug_1"]},
        "verbs": {"take": ["take", "grab"]}, "contents": {"Water": ["water"]}, "fillers": ["please"]})";

void harmless(const Expected<void>& added) {
  if (!added && added.error().message.empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  const int which = data[0] % 7;
  if (which == 5) return static_cast<void>(Background::parse(text, "fuzz")), 0;
  if (which == 6) return static_cast<void>(ReadingConfidence::parse(text, "fuzz")), 0;
  Symbols symbols;
  auto lexicon = Lexicon::parse(which == 0 ? text : kHousehold, "fuzz", symbols);
  if (!lexicon) return lexicon.error().message.empty() ? (std::abort(), 0) : 0;
  if (which == 1 || which == 4) harmless(lexicon->add_names(text, "fuzz"));
  auto language = Language::parse(which == 0 ? text : kHousehold, "fuzz", *lexicon, symbols);
  if (!language) return language.error().message.empty() ? (std::abort(), 0) : 0;
  if (which == 1) harmless(language->add_english(text, "fuzz"));
  if (which == 2) harmless(language->add_other_words(text, "fuzz"));
  if (which == 3) harmless(language->add_kinds(text, "fuzz"));
  if (which == 4) harmless(language->add_talk(text, "fuzz"));
  normal_words({"please", "grab", "two", "of", "the", "mgus", "then", "fill", "it", "."}, *language);
  return 0;
}
