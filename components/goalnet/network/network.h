// The numbers of the GoalNet network: encodes sentence and world, remembers, and decodes predicates.
//
//   words -> bidirectional GRU -> sentence ----------+-----------------+--------+
//   objects (name, features) -> graph -> attention --+-> start state -> decoder: token -> main -> second or
//   value, ... mentioned objects -> goal-object attention ------+ earlier goals -> LSTM -> attention over
//   words ---+
//
// Deterministic; allocates only while its buffers grow to the largest sentence and world seen. Not
// thread-safe. The formulas equal components/goalnet/training/torch_network.cc to 1e-5 (a test).
#pragma once

#include <span>
#include <vector>

#include "components/goalnet/network/encoded_world.h"
#include "components/goalnet/network/name_table.h"
#include "components/goalnet/network/network_config.h"
#include "components/goalnet/network/recurrent.h"
#include "components/goalnet/network/weights.h"

namespace goalnet::inference::network {

class Network {
 public:
  // The references must outlive the network.
  Network(const NetworkConfig& config, const NetworkWeights& weights, const NameTable& names);

  // 1. The sentence: word ids (-1 unknown); or, for an external encoding, its vector.
  void read_sentence(std::span<const int> words);
  void read_sentence(const Vector& external);
  // 2. The world: objects, graph, attentions, and the history in it.
  void read_world(const EncodedWorld& world);
  // With TemporalContext::kState: forget the history, then remember the states one by one, each after
  // read_world.
  void forget();
  void remember_state();
  // 3. Decoding starts from what was read. With kState the last remember_state() must be the present's.
  void start();
  // Scores (logits) of the next predicate's tokens, its main objects, second objects and values.
  const Vector& token_scores();
  const Vector& main_scores(int token);
  const Vector& second_scores(int token, int main);
  const Vector& value_scores(int token, int main);
  // The predicate just decoded goes into the decoder's state. second or value: -1 where it has none.
  void advance(int token, int main, int second, int value);

 private:
  void read_names();
  void pool_sentence();
  void encode_objects(const EncodedWorld& world);
  void attend(const Matrix& weights, const std::vector<std::uint8_t>* mask, Vector& out);
  void run_history(const EncodedWorld& world);
  void query(const Matrix& weights, const Vector& bias, int token, int main, const Matrix& keys,
             const Vector& out);

  const NetworkConfig& config_;
  const NetworkWeights& w_;
  const NameTable& names_;

  Matrix name_objects_, name_main_, name_second_;  // by slot: projected name vectors
  Eigen::Index named_ = 0;                         // slots projected so far

  Eigen::Index length_ = 0;  // words of the sentence, at least 1
  Matrix tokens_;            // length x 2 sentence
  Vector sentence_, word_scores_;
  Eigen::Index objects_ = 0;
  Matrix raw_, mixed_, encoded_, main_keys_, second_keys_;  // objects x object
  bool second_keys_ready_ = false;
  Vector context_, goal_objects_, words_, object_query_, object_scores_;
  Vector past_, history_, memory_;
  std::vector<PastPredicate> remembered_;  // the goals that history_ has read, to go on from there
  std::vector<int> remembered_first_;
  Vector start_in_, state_, input_, gates_, query_in_, query_, token_scores_, main_scores_, second_scores_,
      value_scores_;
  GateScratch sentence_gates_, lstm_gates_, decoder_gates_;
};

// Turns scores into probabilities in place.
void softmax(Eigen::Ref<Vector> scores);

}  // namespace goalnet::inference::network
