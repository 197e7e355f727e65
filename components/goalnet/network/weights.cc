#include "components/goalnet/network/weights.h"

#include <array>
#include <map>

#include "components/goalnet/network/encoded_world.h"

namespace goalnet::inference::network {

int NetworkSizes::features() const { return kFirstValue + values; }

NetworkSizes sizes_of(const Lexicon& lexicon, const Grammar& grammar) {
  return {static_cast<int>(lexicon.words().size()), static_cast<int>(grammar.values().size())};
}

std::vector<TensorShape> tensor_shapes(const NetworkConfig& c, const NetworkSizes& sizes) {
  const int s = 2 * c.sentence, o = c.object, h = c.history, d = c.decoder;
  std::vector<TensorShape> shapes = {{"words.vectors", sizes.words, c.word},
                                     {"words.learned", sizes.words, c.word}};
  if (c.encoding == SentenceEncoding::kRecurrent) {
    for (const char* direction : {"forward", "backward"}) {
      const std::string prefix = std::string("sentence.") + direction + ".";
      shapes.push_back({prefix + "in", 3 * c.sentence, c.word});
      shapes.push_back({prefix + "in_bias", 1, 3 * c.sentence});
      shapes.push_back({prefix + "hidden", 3 * c.sentence, c.sentence});
      shapes.push_back({prefix + "hidden_bias", 1, 3 * c.sentence});
    }
    shapes.push_back({"sentence.pool", 1, s});
  } else {
    shapes.push_back({"sentence.in", s, c.encoding == SentenceEncoding::kExternal ? c.external : c.word});
    shapes.push_back({"sentence.in_bias", 1, s});
  }
  const std::vector<TensorShape> rest = {
      {"object.name", o, c.word},
      {"object.feature", sizes.features(), o},
      {"object.sentence", o, s},
      {"object.bias", 1, o},
      {"graph.self_message", 2 * o, o},
      {"graph.relation", kEdgeTypes, o},
      {"graph.bias", 1, o},
      {"attention.objects", o, s},
      {"attention.goal_objects", o, s},
      {"attention.words", s, h},
      {"past.token", kTokens, h},
      {"past.main", h, c.word},
      {"past.second", h, c.word},
      {"past.value", sizes.values, h},
      {"past.state", h, o},
      {"lstm.in", 4 * h, h},
      {"lstm.hidden", 4 * h, h},
      {"lstm.bias", 1, 4 * h},
      {"start.in", d, 2 * o + 2 * s + h},
      {"start.bias", 1, d},
      {"decoder.token_in", kTokens, o},
      {"decoder.main_in", o, o},
      {"decoder.second_in", o, o},
      {"decoder.value_in", sizes.values, o},
      {"decoder.in", 3 * d, o},
      {"decoder.in_bias", 1, 3 * d},
      {"decoder.hidden", 3 * d, d},
      {"decoder.hidden_bias", 1, 3 * d},
      {"decoder.token", kTokens, d},
      {"decoder.token_bias", 1, kTokens},
      {"decoder.main_key", o, o},
      {"decoder.main_query", o, d + o},
      {"decoder.main_query_bias", 1, o},
      {"decoder.main_out", 1, o},
      {"decoder.second_key", o, o},
      {"decoder.second_query", o, d + 2 * o},
      {"decoder.second_query_bias", 1, o},
      {"decoder.second_out", 1, o},
      {"decoder.value", sizes.values, d + 2 * o},
      {"decoder.value_bias", 1, sizes.values},
  };
  shapes.insert(shapes.end(), rest.begin(), rest.end());
  return shapes;
}

Expected<NetworkWeights> load_weights(const SafeTensors& file, const NetworkConfig& config,
                                      const NetworkSizes& sizes) {
  std::map<std::string, Matrix> loaded;
  for (const TensorShape& shape : tensor_shapes(config, sizes)) {
    const std::array<std::uint64_t, 2> wanted = {static_cast<std::uint64_t>(shape.rows),
                                                 static_cast<std::uint64_t>(shape.cols)};
    auto tensor = file.floats(shape.name, wanted);
    if (!tensor) return tl::unexpected(tensor.error());
    loaded[shape.name] = Eigen::Map<const Matrix>(tensor->values.data(), shape.rows, shape.cols);
  }
  const auto matrix = [&loaded](const std::string& name) { return std::move(loaded.at(name)); };
  const auto vector = [&loaded](const std::string& name) -> Vector {
    return loaded.at(name).row(0).transpose();
  };

  NetworkWeights w;
  w.vectors = matrix("words.vectors");
  w.words = w.vectors + matrix("words.learned");
  if (config.encoding == SentenceEncoding::kRecurrent) {
    for (const int direction : {0, 1}) {
      const std::string prefix = direction == 0 ? "sentence.forward." : "sentence.backward.";
      w.gru_unknown[direction] = vector(prefix + "in_bias");
      w.gru_in[direction] = w.words * matrix(prefix + "in").transpose();
      w.gru_in[direction].rowwise() += w.gru_unknown[direction].transpose();
      w.gru_hidden[direction] = matrix(prefix + "hidden");
      w.gru_hidden_bias[direction] = vector(prefix + "hidden_bias");
    }
    w.sentence_pool = vector("sentence.pool");
  } else {
    w.sentence_in = matrix("sentence.in");
    w.sentence_in_bias = vector("sentence.in_bias");
  }
  w.object_name = matrix("object.name");
  w.object_feature = matrix("object.feature");
  w.object_sentence = matrix("object.sentence");
  w.object_bias = vector("object.bias");
  w.graph = matrix("graph.self_message");
  w.graph_relation = matrix("graph.relation");
  w.graph_bias = vector("graph.bias");
  w.attend_objects = matrix("attention.objects");
  w.attend_goal_objects = matrix("attention.goal_objects");
  w.attend_words = matrix("attention.words");
  w.past_token = matrix("past.token");
  w.past_main = matrix("past.main");
  w.past_second = matrix("past.second");
  w.past_value = matrix("past.value");
  w.past_state = matrix("past.state");
  w.lstm_in = matrix("lstm.in");
  w.lstm_hidden = matrix("lstm.hidden");
  w.lstm_bias = vector("lstm.bias");
  w.start = matrix("start.in");
  w.start_bias = vector("start.bias");
  w.decode_token = matrix("decoder.token_in");
  w.decode_main = matrix("decoder.main_in");
  w.decode_second = matrix("decoder.second_in");
  w.decode_value = matrix("decoder.value_in");
  w.decode_in = matrix("decoder.in");
  w.decode_in_bias = vector("decoder.in_bias");
  w.decode_hidden = matrix("decoder.hidden");
  w.decode_hidden_bias = vector("decoder.hidden_bias");
  w.token = matrix("decoder.token");
  w.token_bias = vector("decoder.token_bias");
  w.main_key = matrix("decoder.main_key");
  w.main_query = matrix("decoder.main_query");
  w.main_query_bias = vector("decoder.main_query_bias");
  w.main_out = vector("decoder.main_out");
  w.second_key = matrix("decoder.second_key");
  w.second_query = matrix("decoder.second_query");
  w.second_query_bias = vector("decoder.second_query_bias");
  w.second_out = vector("decoder.second_out");
  w.value = matrix("decoder.value");
  w.value_bias = vector("decoder.value_bias");
  return w;
}

}  // namespace goalnet::inference::network
