// The parameters of the network: one list of names and shapes that training, model files and inference share.
#pragma once

#include <string>
#include <vector>

#include "components/goalnet/network/grammar.h"
#include "components/goalnet/network/lexicon.h"
#include "components/goalnet/network/network_config.h"
#include "components/goalnet/network/tensors.h"
#include "components/goalnet/safetensors.h"

namespace goalnet::inference::network {

// A weight matrix. Vectors are matrices of one row.
struct TensorShape {
  std::string name;
  int rows, cols;
};

// Sizes that follow from the vocabulary.
struct NetworkSizes {
  int words = 0;         // rows of the word tables
  int values = 0;        // values that a state can have
  int features() const;  // features of an object
};
NetworkSizes sizes_of(const Lexicon& lexicon, const Grammar& grammar);

// All trained tensors, and first "words.vectors", which training leaves as it is.
std::vector<TensorShape> tensor_shapes(const NetworkConfig& config, const NetworkSizes& sizes);

// Weights as inference needs them. Products that never change are folded at load (gru_in: per word).
struct NetworkWeights {
  Matrix vectors, words;      // words x word; stored vectors, and stored plus learned
  Matrix gru_in[2];           // words x 3 sentence: input gates of each word, forward and backward
  Vector gru_unknown[2];      // the same for a word that is not known
  Matrix gru_hidden[2];       // 3 sentence x sentence
  Vector gru_hidden_bias[2];  // 3 sentence
  Matrix sentence_in;         // 2 sentence x (word or external); for the other encodings
  Vector sentence_in_bias, sentence_pool;  // 2 sentence
  Matrix object_name, object_feature,
      object_sentence;  // object x word; features x object; object x 2 sentence
  Vector object_bias;
  Matrix graph, graph_relation;  // 2 object x object: self on top, message below; edge types x object
  Vector graph_bias;
  Matrix attend_objects, attend_goal_objects;  // object x 2 sentence
  Matrix attend_words;                         // 2 sentence x history
  Matrix past_token, past_main, past_second,
      past_value;               // tokens x history; history x word; same; values x history
  Matrix past_state;            // history x object
  Matrix lstm_in, lstm_hidden;  // 4 history x history
  Vector lstm_bias;
  Matrix start;  // decoder x (2 object + 4 sentence + history)
  Vector start_bias;
  Matrix decode_token, decode_main, decode_second,
      decode_value;                 // tokens x object; object x object; same; values x object
  Matrix decode_in, decode_hidden;  // 3 decoder x object; 3 decoder x decoder
  Vector decode_in_bias, decode_hidden_bias;
  Matrix token;  // tokens x decoder
  Vector token_bias;
  Matrix main_key, second_key;      // object x object
  Matrix main_query, second_query;  // object x (decoder + object [+ object])
  Vector main_query_bias, second_query_bias, main_out, second_out;
  Matrix value;  // values x (decoder + 2 object)
  Vector value_bias;
};

// Reads every tensor of `shapes` from a file. Errors: kInvalidRequest naming the tensor.
Expected<NetworkWeights> load_weights(const SafeTensors& file, const NetworkConfig& config,
                                      const NetworkSizes& sizes);

}  // namespace goalnet::inference::network
