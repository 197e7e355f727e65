// The ranker's model file. Metadata: kind, language (the JSON of words and things), names, options,
// fingerprint, command. Tensors, for each of "given" and "none": the policy's weights and the remembered
// demonstrations.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "components/core/config_path.h"
#include "components/goalnet/ranker/ranker_model.h"
#include "components/goalnet/ranker/reranker.h"

namespace goalnet::inference {
namespace {

using nlohmann::json;

constexpr int kVersion = 3;
constexpr std::uint64_t kMaxMemories = 100000;

// Hashes of 32 bits as two halves: floats hold 16 bits exactly.
void put_hash(std::vector<float>& out, std::uint32_t hash) {
  out.push_back(static_cast<float>(hash >> 16));
  out.push_back(static_cast<float>(hash & 0xffffu));
}

std::uint32_t get_hash(const float* at) {
  return static_cast<std::uint32_t>(at[0]) << 16 | static_cast<std::uint32_t>(at[1]);
}

json options_json(const RankerOptions& options) {
  return {{"neighbours", options.neighbours},
          {"replays", options.replays},
          {"samples", options.samples},
          {"moments", options.moments},
          {"temperature", options.temperature},
          {"greedy_weight", options.greedy_weight},
          {"replay_weight", options.replay_weight},
          {"reading_weight", options.reading_weight},
          {"epochs", options.training.epochs},
          {"rate", options.training.rate},
          {"decay", options.training.decay},
          {"seed", options.training.seed}};
}

RankerOptions options_from(const json& j) {
  RankerOptions options;
  options.neighbours = std::min<std::size_t>(j.at("neighbours").get<std::size_t>(), 1000);
  options.replays = std::min<std::size_t>(j.at("replays").get<std::size_t>(), 1000);
  options.samples = std::min<std::size_t>(j.at("samples").get<std::size_t>(), 10000);
  options.moments = std::min<std::size_t>(j.at("moments").get<std::size_t>(), 1000000);
  options.temperature = std::clamp(j.at("temperature").get<float>(), 0.01f, 100.0f);
  options.greedy_weight = j.at("greedy_weight").get<float>();
  options.replay_weight = j.at("replay_weight").get<float>();
  options.reading_weight = j.at("reading_weight").get<float>();
  return options;
}

// Names that memories refer to, by their place in a list.
class NameList {
 public:
  float number(Symbol symbol, const Symbols& symbols) {
    const auto [it, added] = numbers_.try_emplace(symbol, names_.size());
    if (added) names_.push_back(symbols.name(symbol));
    return static_cast<float>(it->second);
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::map<Symbol, std::size_t> numbers_;
  std::vector<std::string> names_;
};

Expected<void> write_one(SafeTensorsWriter& writer, const std::string& prefix, const Ranker& ranker,
                         NameList& names, const Symbols& symbols) {
  if (auto ok = writer.add(prefix + ".policy", {kFeatureBuckets}, ranker.policy.weights()); !ok) return ok;
  if (!ranker.reranker.empty()) {
    std::vector<float> nodes, roots(ranker.reranker.roots().begin(), ranker.reranker.roots().end());
    for (const BoostedTrees::Node& node : ranker.reranker.nodes())
      for (const float value : {static_cast<float>(node.feature), node.threshold,
                                static_cast<float>(node.left), static_cast<float>(node.right)})
        nodes.push_back(value);
    if (auto ok = writer.add(prefix + ".trees.nodes", {nodes.size() / 4, 4}, nodes); !ok) return ok;
    if (auto ok = writer.add(prefix + ".trees.roots", {roots.size()}, roots); !ok) return ok;
  }
  std::vector<float> terms, layouts, mentions, steps, counts;
  for (const Memory& memory : ranker.neighbours.memories()) {
    for (const auto& [hash, amount] : memory.terms) put_hash(terms, hash), terms.push_back(amount);
    for (const std::uint32_t hash : memory.layout) put_hash(layouts, hash);
    for (const std::uint32_t hash : memory.mentions) put_hash(mentions, hash);
    for (const Memory::Step& step : memory.steps)
      for (const float value : {static_cast<float>(step.action.verb), names.number(step.action.x, symbols),
                                names.number(step.action.y, symbols), static_cast<float>(step.x_class),
                                static_cast<float>(step.y_class), static_cast<float>(step.x_mention),
                                static_cast<float>(step.y_mention)})
        steps.push_back(value);
    for (const std::size_t count :
         {memory.terms.size(), memory.layout.size(), memory.mentions.size(), memory.steps.size()})
      counts.push_back(static_cast<float>(count));
  }
  const auto add = [&](const char* what, std::uint64_t columns, const std::vector<float>& values) {
    return writer.add(prefix + ".memory." + what, {values.size() / columns, columns}, values);
  };
  for (const auto& result : {add("terms", 3, terms), add("layouts", 2, layouts), add("mentions", 2, mentions),
                             add("steps", 7, steps), add("counts", 4, counts)})
    if (!result) return result;
  return {};
}

// Reads rows of numbers one after the other and never past the end.
class Rows {
 public:
  Rows(const FloatTensor& tensor, std::size_t columns) : values_(tensor.values), columns_(columns) {}
  const float* next() {
    if ((row_ + 1) * columns_ > values_.size()) return nullptr;
    return values_.data() + columns_ * row_++;
  }
  bool at_end() const { return row_ * columns_ == values_.size(); }

 private:
  const std::vector<float>& values_;
  std::size_t columns_, row_ = 0;
};

bool is_count(float value, float most) { return value >= 0 && value <= most && value == std::floor(value); }

Expected<Ranker> read_one(const SafeTensors& file, const std::string& prefix,
                          const std::vector<Symbol>& names, const RankerOptions& options,
                          std::size_t classes) {
  Ranker ranker;
  ranker.options = options;
  const std::uint64_t policy_shape[] = {kFeatureBuckets};
  auto policy = file.floats(prefix + ".policy", policy_shape);
  if (!policy) return tl::unexpected(policy.error());
  ranker.policy.weights() = std::move(policy->values);
  const auto table = [&](const char* what, std::uint64_t columns) {
    const std::uint64_t shape[] = {0, columns};
    return file.floats(prefix + ".memory." + what, shape);
  };
  const auto terms = table("terms", 3), layouts = table("layouts", 2), mentions = table("mentions", 2),
             steps = table("steps", 7), counts = table("counts", 4);
  for (const auto* tensor : {&terms, &layouts, &mentions, &steps, &counts})
    if (!*tensor) return tl::unexpected(tensor->error());
  const auto bad = [&] {
    return fail(Outcome::kInvalidRequest,
                file.name() + ": the memories of \"" + prefix + "\" are inconsistent");
  };
  Rows term_rows(*terms, 3), layout_rows(*layouts, 2), mention_rows(*mentions, 2), step_rows(*steps, 7),
      count_rows(*counts, 4);
  std::vector<Memory> memories;
  while (const float* count = count_rows.next()) {
    if (memories.size() >= kMaxMemories) return bad();
    for (int i = 0; i < 4; ++i)
      if (!is_count(count[i], 1e6f)) return bad();
    Memory memory;
    for (int i = 0; i < static_cast<int>(count[0]); ++i) {
      const float* row = term_rows.next();
      if (!row || !is_count(row[0], 65535) || !is_count(row[1], 65535)) return bad();
      memory.terms.emplace_back(get_hash(row), row[2]);
    }
    for (auto [rows, number, hashes] : {std::tuple{&layout_rows, count[1], &memory.layout},
                                        std::tuple{&mention_rows, count[2], &memory.mentions}})
      for (int i = 0; i < static_cast<int>(number); ++i) {
        const float* row = rows->next();
        if (!row || !is_count(row[0], 65535) || !is_count(row[1], 65535)) return bad();
        hashes->push_back(get_hash(row));
      }
    if (!std::is_sorted(memory.layout.begin(), memory.layout.end())) return bad();
    for (int i = 0; i < static_cast<int>(count[3]); ++i) {
      const float* row = step_rows.next();
      const float most_name = static_cast<float>(names.size()) - 1;
      if (!row || !is_count(row[0], kVerbs - 1) || !is_count(row[1], most_name) ||
          !is_count(row[2], most_name))
        return bad();
      for (int k = 3; k < 5; ++k)
        if (!is_count(row[k], 65535) || (row[k] >= static_cast<float>(classes) && row[k] != kNoClass))
          return bad();
      for (int k = 5; k < 7; ++k)
        if (!is_count(row[k] + 1, 1000)) return bad();
      memory.steps.push_back({.action = {static_cast<Verb>(row[0]), names[static_cast<std::size_t>(row[1])],
                                         names[static_cast<std::size_t>(row[2])]},
                              .x_class = static_cast<ClassId>(row[3]),
                              .y_class = static_cast<ClassId>(row[4]),
                              .x_mention = static_cast<std::int16_t>(row[5]),
                              .y_mention = static_cast<std::int16_t>(row[6])});
    }
    memories.push_back(std::move(memory));
  }
  if (!term_rows.at_end() || !layout_rows.at_end() || !mention_rows.at_end() || !step_rows.at_end())
    return bad();
  ranker.neighbours = Neighbours(std::move(memories));
  if (!file.contains(prefix + ".trees.nodes")) return ranker;
  const std::uint64_t node_shape[] = {0, 4}, root_shape[] = {0};
  const auto nodes = file.floats(prefix + ".trees.nodes", node_shape),
             roots = file.floats(prefix + ".trees.roots", root_shape);
  for (const auto* tensor : {&nodes, &roots})
    if (!*tensor) return tl::unexpected(tensor->error());
  constexpr float kMost = 1 << 24;  // whole numbers up to here are exact in a float
  std::vector<BoostedTrees::Node> tree_nodes;
  Rows node_rows(*nodes, 4);
  while (const float* row = node_rows.next()) {
    if (!is_count(row[0] + 1, kMost) || !is_count(row[2], kMost) || !is_count(row[3], kMost)) return bad();
    tree_nodes.push_back({static_cast<std::int32_t>(row[0]), row[1], static_cast<std::int32_t>(row[2]),
                          static_cast<std::int32_t>(row[3])});
  }
  std::vector<std::int32_t> tree_roots;
  for (const float value : roots->values) {
    if (!is_count(value, kMost)) return bad();
    tree_roots.push_back(static_cast<std::int32_t>(value));
  }
  if (!ranker.reranker.assign(std::move(tree_nodes), std::move(tree_roots), kRunFeatures)) return bad();
  return ranker;
}

Places places_from(const json& j, std::size_t classes) {
  Places places{j.at("on").get<std::vector<ClassId>>(), j.at("in").get<std::vector<ClassId>>()};
  for (auto* list : {&places.on, &places.in}) {
    std::erase_if(*list, [&](ClassId id) { return id >= classes; });
    std::sort(list->begin(), list->end());
  }
  return places;
}

Confidence confidence_from(const json& j) {
  auto points = j.get<std::vector<Confidence::Point>>();
  std::sort(points.begin(), points.end());
  for (auto& [expected, sji] : points) sji = std::clamp(sji, 0.0f, 1.0f);
  return Confidence(std::move(points));
}

}  // namespace

Expected<LanguageTexts> read_language_texts() {
  LanguageTexts texts;
  for (const auto& [name, text] :
       {std::pair{"household", &texts.household}, {"english", &texts.english}, {"words", &texts.words}}) {
    const std::string path = config_path(std::string("language/") + name + ".json");
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    if (!file) return fail(Outcome::kInvalidRequest, path + ": cannot be read");
    *text = content.str();
  }
  return texts;
}

Expected<RankerParts> make_parts(LanguageTexts texts, const std::string& name) {
  RankerParts parts;
  auto lexicon = Lexicon::parse(texts.household, name, parts.symbols);
  if (!lexicon) return tl::unexpected(lexicon.error());
  parts.lexicon = std::make_unique<Lexicon>(std::move(*lexicon));
  if (!texts.english.empty())
    if (auto added = parts.lexicon->add_names(texts.english, name); !added)
      return tl::unexpected(added.error());
  auto language = Language::parse(texts.household, name, *parts.lexicon, parts.symbols);
  if (!language) return tl::unexpected(language.error());
  parts.language = std::make_unique<Language>(std::move(*language));
  if (!texts.english.empty())
    if (auto added = parts.language->add_english(texts.english, name); !added)
      return tl::unexpected(added.error());
  if (!texts.words.empty())
    if (auto added = parts.language->add_other_words(texts.words, name); !added)
      return tl::unexpected(added.error());
  parts.texts = std::move(texts);
  return parts;
}

std::string to_json(const RankerOptions& options) { return options_json(options).dump(); }

Expected<void> write_ranker(const RankerParts& parts, const std::string& path) {
  SafeTensorsWriter writer;
  NameList names;
  for (const auto& [prefix, ranker] : {std::pair{"given", &parts.given}, {"none", &parts.none}})
    if (auto ok = write_one(writer, prefix, *ranker, names, parts.symbols); !ok) return ok;
  const auto places = [](const Places& p) { return json{{"on", p.on}, {"in", p.in}}; };
  writer.metadata("goalnet.kind", "ranker");
  writer.metadata("goalnet.version", std::to_string(kVersion));
  writer.metadata("goalnet.language", parts.texts.household);
  writer.metadata("goalnet.english", parts.texts.english);
  writer.metadata("goalnet.words", parts.texts.words);
  writer.metadata("goalnet.names", json(names.names()).dump());
  writer.metadata("goalnet.vocabulary", json(parts.known_words).dump());
  writer.metadata(
      "goalnet.config",
      json{{"options", options_json(parts.given.options)},
           {"places", places(parts.given.places)},
           {"confidence",
            {{"given", parts.given.confidence.points()}, {"none", parts.none.confidence.points()}}}}
          .dump());
  writer.metadata("goalnet.data_fingerprint", parts.fingerprint);
  writer.metadata("goalnet.command", parts.command);
  return writer.write(path);
}

Expected<RankerParts> read_ranker(const SafeTensors& file) {
  std::map<std::string, std::string> texts;
  for (const char* key : {"version", "language", "english", "words", "names", "vocabulary", "config",
                          "data_fingerprint", "command"}) {
    auto text = file.metadata(std::string("goalnet.") + key);
    if (!text) return tl::unexpected(text.error());
    texts[key] = std::move(*text);
  }
  if (texts["version"] != std::to_string(kVersion))
    return fail(Outcome::kInvalidRequest, file.name() + ": model version " + texts["version"] +
                                              "; this program reads version " + std::to_string(kVersion) +
                                              "; train it again");
  auto parts =
      make_parts({texts["language"], texts["english"], texts["words"]}, file.name() + " (goalnet.language)");
  if (!parts) return parts;
  try {
    std::vector<Symbol> names;
    for (const auto& name : json::parse(texts["names"]).get<std::vector<std::string>>())
      names.push_back(parts->symbols.intern(name));
    parts->known_words = json::parse(texts["vocabulary"]).get<std::vector<std::string>>();
    const json config = json::parse(texts["config"]);
    const RankerOptions options = options_from(config.at("options"));
    const Places places = places_from(config.at("places"), parts->lexicon->classes());
    for (auto [prefix, ranker] : {std::pair{"given", &parts->given}, {"none", &parts->none}}) {
      auto one = read_one(file, prefix, names, options, parts->lexicon->classes());
      if (!one) return tl::unexpected(one.error());
      *ranker = std::move(*one);
      ranker->places = places;
      ranker->confidence = confidence_from(config.at("confidence").at(prefix));
    }
  } catch (const json::exception& error) {
    return fail(Outcome::kInvalidRequest, file.name() + ": " + error.what());
  }
  parts->fingerprint = texts["data_fingerprint"];
  parts->command = texts["command"];
  return parts;
}

}  // namespace goalnet::inference
