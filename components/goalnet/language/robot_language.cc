#include "components/goalnet/language/robot_language.h"

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <sstream>

#include "components/core/config_path.h"

namespace goalnet::inference {
namespace {

Expected<std::string> text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) return fail(Outcome::kInvalidRequest, path + ": cannot be read");
  return text.str();
}

}  // namespace

Expected<std::unique_ptr<RobotLanguage>> RobotLanguage::load(Symbols& symbols, bool guesses) {
  std::unique_ptr<RobotLanguage> robot(new RobotLanguage(symbols));
  constexpr int kFiles = 7;
  std::string texts[kFiles], paths[kFiles];
  const char* names[kFiles] = {"language/household.json",  "language/english.json", "language/words.json",
                               "language/confidence.json", "language/kinds.json",   "language/talk.json",
                               "language/background.json"};
  for (int i = 0; i < kFiles; ++i) {
    paths[i] = config_path(names[i]);
    auto text = text_of(paths[i]);
    if (!text) return tl::unexpected(text.error());
    texts[i] = std::move(*text);
  }
  auto lexicon = Lexicon::parse(texts[0], paths[0], symbols);
  if (!lexicon) return tl::unexpected(lexicon.error());
  robot->lexicon_ = std::make_unique<Lexicon>(std::move(*lexicon));
  if (auto added = robot->lexicon_->add_names(texts[1], paths[1]); !added)
    return tl::unexpected(added.error());
  if (auto added = robot->lexicon_->add_names(texts[5], paths[5]); !added)
    return tl::unexpected(added.error());
  symbols.intern("Tray");  // no world lists it, goals may name it
  auto language = Language::parse(texts[0], paths[0], *robot->lexicon_, symbols);
  if (!language) return tl::unexpected(language.error());
  robot->language_ = std::make_unique<Language>(std::move(*language));
  if (auto added = robot->language_->add_english(texts[1], paths[1]); !added)
    return tl::unexpected(added.error());
  if (auto added = robot->language_->add_other_words(texts[2], paths[2]); !added)
    return tl::unexpected(added.error());
  if (auto added = robot->language_->add_kinds(texts[4], paths[4]); !added)
    return tl::unexpected(added.error());
  if (auto added = robot->language_->add_talk(texts[5], paths[5]); !added)
    return tl::unexpected(added.error());
  auto confidence = ReadingConfidence::parse(texts[3], paths[3]);
  if (!confidence) return tl::unexpected(confidence.error());
  robot->confidence_ = *confidence;
  auto background = Background::parse(texts[6], paths[6]);
  if (!background) return tl::unexpected(background.error());
  robot->background_ = std::move(*background);
  if (!guesses) return robot;
  auto gist = gist::GistModel::load(config_path("language/gist.safetensors"));
  if (!gist) return tl::unexpected(gist.error());
  robot->gist_ = std::move(*gist);
  return robot;
}

Instruction RobotLanguage::objects_here(const std::vector<std::string>& objects) {
  // Things that the lexicon does not list are known by their names from here on.
  for (const std::string& object : objects)
    if (const Symbol symbol = symbols_.intern(object); symbol != symbol::kNone && symbol != symbol::kRobot)
      lexicon_->class_of(symbol, symbols_);
  // Parts of things are here with them, though worlds do not list them.
  std::vector<std::string> with_parts = objects;
  const auto add_parts = [&](const char* thing, std::initializer_list<const char*> parts) {
    if (std::find(objects.begin(), objects.end(), thing) != objects.end())
      with_parts.insert(with_parts.end(), parts.begin(), parts.end());
  };
  add_parts("Fridge", {"FridgeLeft", "FridgeRight", "FridgeLeftDoor", "FridgeRightDoor", "FridgeButton"});
  add_parts("Microwave", {"MicrowaveButton"});
  add_parts("Stove", {"StoveKnob_1", "StoveKnob_2", "StoveKnob_3", "StoveKnob_4"});
  add_parts("Sink", {"SinkKnob"});
  return see_instruction({}, nullptr, with_parts, *lexicon_, *language_, symbols_);
}

RobotLanguage::Sight RobotLanguage::see(const std::vector<std::string>& tokens,
                                        const std::vector<std::string>& objects, const SymState& start) {
  Sight sight;
  sight.here = objects_here(objects);
  for (const auto& words : {tokens, normal_words(tokens, *language_).text}) {
    gist::View view{gist::see_message(words, sight.here, *lexicon_, *language_), {}};
    view.requests = gist::possible_requests(view.message, static_cast<int>(sight.views.size()), sight.here,
                                            start, *lexicon_, symbols_);
    sight.views.push_back(std::move(view));
  }
  return sight;
}

RobotLanguage::Reading RobotLanguage::read(const std::vector<std::string>& tokens,
                                           const std::vector<std::string>& objects, const SymState& start,
                                           const Distances* distances) {
  Reading reading;
  reading.words = normal_words(tokens, *language_);
  reading.instruction = objects_here(objects);
  const FrameReader reader(*lexicon_, *language_, symbols_, true);
  reading.understanding = reader.read(reading.words, reading.instruction, start, distances);
  // What cannot be done is no background: the rest is not done without it.
  const std::vector<SentencePart> all = parts(tokens);
  for (const SentencePart& part : all) {
    if (!asks_for_unknown(tokens, part)) continue;
    reading.beyond_robot = true;
    if (reading.understanding.complete || all.size() > 1) {
      std::string said;
      for (std::size_t i = part.begin; i < part.end; ++i) said += (said.empty() ? "" : " ") + tokens[i];
      reading.understanding.problems = {"\"" + said + "\" cannot be done here, so nothing of it is begun; " +
                                        language_->unknown_word(tokens[part.end - 1])};
    }
    reading.understanding.complete = false;
    return reading;
  }
  if (reading.understanding.complete || reading.understanding.for_later) return reading;
  // another spelling would turn on another channel, or be passed off as done
  if (reading.understanding.no_such_number || reading.understanding.contradicted) return reading;
  if (reading.understanding.only_forbids || reading.understanding.only_asks)
    return reading;  // no other spelling may turn that round
  other_readings(tokens, reader, start, distances, reading);
  return reading;
}

}  // namespace goalnet::inference
