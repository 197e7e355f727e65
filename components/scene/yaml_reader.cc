#include "components/scene/yaml_reader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace goalnet::scene {

void Mistakes::add(const std::string& file, const YAML::Mark& mark, const std::string& what) {
  ++count_;
  if (texts_.size() >= 20) return;
  std::string place = file;
  if (!mark.is_null()) place.append(":").append(std::to_string(mark.line + 1));
  texts_.push_back(place + ": " + what);
}

Error Mistakes::error() const {
  std::string text;
  for (const auto& line : texts_) text.append(text.empty() ? "" : "\n").append(line);
  if (count_ > texts_.size())
    text += "\n... and " + std::to_string(count_ - texts_.size()) + " more mistakes";
  return {Outcome::kInvalidRequest, text};
}

Expected<YAML::Node> read_yaml_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    return fail(Outcome::kInvalidRequest, path + ": cannot be opened; check the name and the permissions");
  std::string text;
  text.resize(kMaxFileBytes + 1);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) return fail(Outcome::kInvalidRequest, path + ": cannot be read; it must be a file");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return read_yaml_text(text, path);
}

Expected<YAML::Node> read_yaml_text(const std::string& text, const std::string& name) {
  if (text.size() > kMaxFileBytes) {
    return fail(Outcome::kInvalidRequest, name + ": larger than 4 MiB; split it into several libraries");
  }
  try {
    YAML::Node node = YAML::Load(text);
    if (!node.IsMap()) return fail(Outcome::kInvalidRequest, name + ":1: must be a map of keys and values");
    return node;
  } catch (const YAML::Exception& error) {
    const int line = error.mark.is_null() ? 1 : error.mark.line + 1;
    return fail(Outcome::kInvalidRequest, name + ":" + std::to_string(line) + ": not valid YAML: " +
                                              error.msg + "; check indentation, quotes and brackets");
  }
}

YamlReader::YamlReader(YAML::Node node, std::string file, Mistakes& mistakes)
    : node_(std::move(node)), file_(std::move(file)), mistakes_(&mistakes) {
  if (!node_.IsMap()) {
    mistake("expected a map of keys and values");
    return;
  }
  std::set<std::string> keys;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) {
      mistakes_->add(file_, entry.first.Mark(), "keys must be plain words");
    } else if (!keys.insert(entry.first.Scalar()).second) {
      mistakes_->add(file_, entry.first.Mark(),
                     "key '" + entry.first.Scalar() + "' stands twice; remove one");
    }
  }
}

void YamlReader::mistake(const std::string& what) { mistakes_->add(file_, node_.Mark(), what); }

void YamlReader::mistake_at(const std::string& key, const std::string& what) {
  const YAML::Node value = find(key, false);
  mistakes_->add(file_, value ? value.Mark() : node_.Mark(), what);
}

YAML::Node YamlReader::find(const std::string& key, bool required) {
  asked_.insert(key);
  if (node_.IsMap()) {
    for (const auto& entry : node_) {
      if (entry.first.IsScalar() && entry.first.Scalar() == key) return entry.second;
    }
  }
  if (required) mistake("key '" + key + "' is missing; add it");
  return YAML::Node(YAML::NodeType::Undefined);
}

bool YamlReader::has(const std::string& key) { return find(key, false).IsDefined(); }

double YamlReader::number_of(const YAML::Node& node, const std::string& key, double min, double max) {
  double value = 0.0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value)) {
    mistakes_->add(file_, node.Mark(), "'" + key + "' must be a number");
    return std::clamp(0.0, min, max);
  }
  if (!std::isfinite(value)) {
    mistakes_->add(file_, node.Mark(), "'" + key + "' must be a finite number");
    return std::clamp(0.0, min, max);
  }
  if (value < min || value > max) {
    std::ostringstream text;
    text << "'" << key << "' is " << value << " but must be between " << min << " and " << max;
    mistakes_->add(file_, node.Mark(), text.str());
    return std::clamp(value, min, max);
  }
  return value;
}

double YamlReader::number(const std::string& key, double min, double max) {
  const YAML::Node node = find(key, true);
  return node ? number_of(node, key, min, max) : std::clamp(0.0, min, max);
}

double YamlReader::number(const std::string& key, double min, double max, double otherwise) {
  const YAML::Node node = find(key, false);
  return node ? number_of(node, key, min, max) : otherwise;
}

bool YamlReader::flag(const std::string& key, bool otherwise) {
  const YAML::Node node = find(key, false);
  if (!node) return otherwise;
  bool value = otherwise;
  if (!node.IsScalar() || !YAML::convert<bool>::decode(node, value)) {
    mistakes_->add(file_, node.Mark(), "'" + key + "' must be true or false");
    return otherwise;
  }
  return value;
}

std::optional<std::string> YamlReader::scalar_of(const YAML::Node& node, const std::string& key) {
  if (!node.IsScalar() || node.Scalar().empty()) {
    mistakes_->add(file_, node.Mark(), "'" + key + "' must be a word");
    return {};
  }
  if (node.Scalar().size() > 200) {
    mistakes_->add(file_, node.Mark(), "'" + key + "' is longer than 200 characters");
    return {};
  }
  return node.Scalar();
}

std::string YamlReader::text(const std::string& key) {
  const YAML::Node node = find(key, true);
  return node ? scalar_of(node, key).value_or("") : "";
}

std::string YamlReader::text(const std::string& key, const std::string& otherwise) {
  const YAML::Node node = find(key, false);
  return node ? scalar_of(node, key).value_or(otherwise) : otherwise;
}

std::string YamlReader::choice(const std::string& key, const std::vector<std::string>& choices,
                               const std::optional<std::string>& otherwise) {
  const YAML::Node node = find(key, !otherwise.has_value());
  if (!node) return otherwise.value_or(choices.front());
  const std::string word = scalar_of(node, key).value_or("");
  if (std::find(choices.begin(), choices.end(), word) != choices.end()) return word;
  std::string all;
  for (const auto& name : choices) all += (all.empty() ? "" : ", ") + name;
  mistakes_->add(file_, node.Mark(), "'" + key + "' is '" + word + "' but must be one of: " + all);
  return choices.front();
}

std::vector<double> YamlReader::numbers(const std::string& key, std::size_t length, double min, double max,
                                        const std::optional<std::vector<double>>& otherwise) {
  const std::vector<double> harmless =
      otherwise.value_or(std::vector<double>(length, std::clamp(0.0, min, max)));
  const YAML::Node node = find(key, !otherwise.has_value());
  if (!node) return harmless;
  if (!node.IsSequence() || node.size() != length) {
    mistakes_->add(file_, node.Mark(),
                   "'" + key + "' must be a list of " + std::to_string(length) + " numbers");
    return harmless;
  }
  std::vector<double> values;
  for (const auto& element : node) values.push_back(number_of(element, key, min, max));
  return values;
}

Eigen::Vector3d YamlReader::vector3(const std::string& key, const std::optional<Eigen::Vector3d>& otherwise) {
  std::optional<std::vector<double>> values;
  if (otherwise) values = std::vector<double>{otherwise->x(), otherwise->y(), otherwise->z()};
  const std::vector<double> read = numbers(key, 3, -1000.0, 1000.0, values);
  return {read[0], read[1], read[2]};
}

std::vector<std::string> YamlReader::texts(const std::string& key) {
  const YAML::Node node = find(key, false);
  std::vector<std::string> words;
  if (!node) return words;
  if (!node.IsSequence() || node.size() > kMaxListLength) {
    mistakes_->add(file_, node.Mark(), "'" + key + "' must be a list of words, at most 10000 long");
    return words;
  }
  for (const auto& element : node) {
    if (auto word = scalar_of(element, key)) words.push_back(*word);
  }
  return words;
}

std::vector<Predicate> YamlReader::predicates(const std::string& key) {
  std::vector<Predicate> facts;
  const YAML::Node node = find(key, false);
  if (!node) return facts;
  for (const auto& word : texts(key)) {
    auto fact = parse_predicate(word);
    if (fact) {
      facts.push_back(*fact);
    } else {
      mistakes_->add(file_, node.Mark(),
                     fact.error().message + "; write facts like \"(state SinkKnob TapIsOn)\"");
    }
  }
  return facts;
}

std::vector<YamlReader> YamlReader::maps(const std::string& key) {
  const YAML::Node node = find(key, false);
  std::vector<YamlReader> readers;
  if (!node) return readers;
  if (!node.IsSequence() || node.size() > kMaxListLength) {
    mistakes_->add(file_, node.Mark(), "'" + key + "' must be a list, at most 10000 long");
    return readers;
  }
  for (const auto& element : node) readers.emplace_back(element, file_, *mistakes_);
  return readers;
}

std::vector<std::pair<std::string, YamlReader>> YamlReader::named_maps(const std::string& key) {
  const YAML::Node node = find(key, false);
  std::vector<std::pair<std::string, YamlReader>> readers;
  if (!node) return readers;
  if (!node.IsMap() || node.size() > kMaxListLength) {
    mistakes_->add(file_, node.Mark(), "'" + key + "' must be a map of names, at most 10000 long");
    return readers;
  }
  std::set<std::string> names;
  for (const auto& entry : node) {
    const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (!names.insert(name).second) {
      mistakes_->add(file_, entry.first.Mark(), "'" + name + "' stands twice; remove one");
    }
    readers.emplace_back(name, YamlReader(entry.second, file_, *mistakes_));
  }
  return readers;
}

std::optional<YamlReader> YamlReader::map(const std::string& key) {
  const YAML::Node node = find(key, false);
  if (!node) return {};
  return YamlReader(node, file_, *mistakes_);
}

void YamlReader::finish() {
  if (!node_.IsMap()) return;
  const std::vector<std::string> known(asked_.begin(), asked_.end());
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar() || asked_.contains(entry.first.Scalar())) continue;
    const std::string near = nearest_word(entry.first.Scalar(), known);
    mistakes_->add(file_, entry.first.Mark(),
                   "key '" + entry.first.Scalar() + "' is not known here; " +
                       (near.empty() ? "remove it" : "did you mean '" + near + "'?"));
  }
}

std::string nearest_word(const std::string& word, const std::vector<std::string>& candidates) {
  std::size_t best = word.size() / 2 + 1;
  std::string nearest;
  if (word.size() > 100) return nearest;
  for (const auto& candidate : candidates) {
    std::vector<std::size_t> row(candidate.size() + 1);
    for (std::size_t j = 0; j <= candidate.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= word.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= candidate.size(); ++j) {
        const std::size_t above = row[j];
        row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (word[i - 1] == candidate[j - 1] ? 0 : 1)});
        diagonal = above;
      }
    }
    if (row.back() < best) {
      best = row.back();
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace goalnet::scene
