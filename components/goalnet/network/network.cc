#include "components/goalnet/network/network.h"

#include <algorithm>

#include "components/goalnet/network/index.h"

namespace goalnet::inference::network {
namespace {

// Grows a matrix, never shrinks it: so that a smaller world after a larger one allocates nothing.
void reserve_rows(Matrix& matrix, Eigen::Index rows, Eigen::Index cols) {
  if (matrix.rows() < rows || matrix.cols() != cols) matrix.resize(std::max(matrix.rows(), rows), cols);
}

void reserve(Vector& vector, Eigen::Index size) {
  if (vector.size() < size) vector.resize(size);
}

}  // namespace

void softmax(Eigen::Ref<Vector> scores) {
  if (scores.size() == 0) return;
  scores.array() = (scores.array() - scores.maxCoeff()).exp();
  scores /= scores.sum();
}

Network::Network(const NetworkConfig& config, const NetworkWeights& weights, const NameTable& names)
    : config_(config), w_(weights), names_(names) {
  const int s = 2 * config.sentence, h = config.history, d = config.decoder, o = config.object;
  sentence_ = words_ = Vector::Zero(s);
  context_ = goal_objects_ = object_query_ = Vector::Zero(o);
  past_ = history_ = memory_ = Vector::Zero(h);
  start_in_.resize(2 * o + 2 * s + h);
  state_ = Vector::Zero(d);
  input_.resize(o);
  gates_.resize(3 * d);
  query_in_.resize(d + 2 * o);
  query_.resize(o);
  token_scores_.resize(kTokens);
  value_scores_.resize(weights.value.rows());
  sentence_gates_.hidden.resize(3 * config.sentence);
  lstm_gates_ = {Vector(4 * h), Vector(4 * h)};
  decoder_gates_.hidden.resize(3 * d);
  remembered_first_.assign(1, 0);
}

void Network::read_names() {
  const auto known = static_cast<Eigen::Index>(names_.size());
  if (known < named_) named_ = 0;  // the table was cleared
  if (known == named_) return;
  const Eigen::Index grown = std::max<Eigen::Index>(known, 2 * name_objects_.rows());
  if (name_objects_.rows() < known) {
    name_objects_.conservativeResize(grown, config_.object);
    name_main_.conservativeResize(grown, config_.history);
    name_second_.conservativeResize(grown, config_.history);
  }
  Vector mean(config_.word);
  for (; named_ < known; ++named_) {
    const NameEntry& entry = names_.entry(static_cast<int>(named_));
    mean.setZero();
    for (const int word : entry.words) mean += w_.words.row(word).transpose();
    if (!entry.words.empty()) mean /= static_cast<float>(entry.words.size());
    name_objects_.row(named_).noalias() = mean.transpose() * w_.object_name.transpose();
    name_main_.row(named_).noalias() = mean.transpose() * w_.past_main.transpose();
    name_second_.row(named_).noalias() = mean.transpose() * w_.past_second.transpose();
  }
}

void Network::read_sentence(std::span<const int> words) {
  const Eigen::Index s = config_.sentence;
  length_ = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(words.size()));
  reserve_rows(tokens_, length_, 2 * s);
  reserve(word_scores_, length_);
  if (words.empty()) tokens_.row(0).setZero();
  if (config_.encoding == SentenceEncoding::kWordMean) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      auto row = tokens_.row(static_cast<Eigen::Index>(i)).transpose();
      row = w_.sentence_in_bias;
      if (words[i] >= 0) row.noalias() += w_.sentence_in * w_.words.row(words[i]).transpose();
      row = row.array().tanh().matrix();
    }
    sentence_ = tokens_.topRows(length_).colwise().mean().transpose();
    return;
  }
  for (const int direction : {0, 1}) {
    Vector& state = direction == 0 ? sentence_ : words_;  // borrowed as the running state
    state.head(s).setZero();
    for (std::size_t k = 0; k < words.size(); ++k) {
      const std::size_t i = direction == 0 ? k : words.size() - 1 - k;
      const int word = words[i];
      const auto gates = word >= 0 ? Eigen::Map<const Vector>(w_.gru_in[direction].row(word).data(), 3 * s)
                                   : Eigen::Map<const Vector>(w_.gru_unknown[direction].data(), 3 * s);
      gru_step(gates, w_.gru_hidden[direction], w_.gru_hidden_bias[direction], sentence_gates_,
               state.head(s));
      tokens_.row(static_cast<Eigen::Index>(i)).segment(direction * s, s) = state.head(s).transpose();
    }
  }
  pool_sentence();
}

void Network::read_sentence(const Vector& external) {
  length_ = 1;
  reserve_rows(tokens_, 1, 2 * config_.sentence);
  reserve(word_scores_, 1);
  sentence_.noalias() = w_.sentence_in * external;
  sentence_ += w_.sentence_in_bias;
  sentence_ = sentence_.array().tanh().matrix();
  tokens_.row(0) = sentence_.transpose();
}

void Network::pool_sentence() {
  const auto tokens = tokens_.topRows(length_);
  if (!config_.instruction_attention) {
    sentence_ = tokens.colwise().mean().transpose();
    return;
  }
  auto scores = word_scores_.head(length_);
  scores.noalias() = tokens * w_.sentence_pool;
  softmax(scores);
  sentence_.noalias() = tokens.transpose() * scores;
}

void Network::encode_objects(const EncodedWorld& world) {
  const Eigen::Index o = config_.object;
  objects_ = world.objects;
  reserve_rows(raw_, objects_, o);
  reserve_rows(mixed_, objects_, 2 * o);
  reserve_rows(encoded_, objects_, o);
  reserve_rows(main_keys_, objects_, o);
  reserve_rows(second_keys_, objects_, o);
  reserve(object_scores_, objects_);
  object_query_.noalias() = w_.object_sentence * sentence_;
  object_query_ += w_.object_bias;
  for (int i = 0; i < world.objects; ++i) {
    auto row = raw_.row(i);
    row = object_query_.transpose() + name_objects_.row(world.slot[at(i)]);
    for (const FeatureItem& item : world.items_of(i)) row += item.value * w_.object_feature.row(item.feature);
    row = row.cwiseMax(0.0F);
  }
  if (!config_.relations) {
    encoded_.topRows(objects_) = raw_.topRows(objects_);
    return;
  }
  mixed_.topRows(objects_).noalias() = raw_.topRows(objects_) * w_.graph.transpose();
  auto encoded = encoded_.topRows(objects_);
  encoded = mixed_.topRows(objects_).leftCols(o).rowwise() + w_.graph_bias.transpose();
  for (const RelationEdge& edge : world.edges) {
    encoded.row(edge.to).array() +=
        w_.graph_relation.row(edge.type).array() * mixed_.row(edge.from).tail(o).array();
  }
  encoded = encoded.cwiseMax(0.0F) + raw_.topRows(objects_);
}

void Network::attend(const Matrix& weights, const std::vector<std::uint8_t>* mask, Vector& out) {
  const auto encoded = encoded_.topRows(objects_);
  auto scores = object_scores_.head(objects_);
  bool any = objects_ > 0;
  if (config_.instruction_attention) {
    object_query_.noalias() = weights * sentence_;
    scores.noalias() = encoded * object_query_;
  } else {
    scores.setZero();
  }
  if (mask != nullptr) {
    any = std::find(mask->begin(), mask->end(), 1) != mask->end();
    for (Eigen::Index i = 0; i < objects_; ++i) {
      if (!(*mask)[static_cast<std::size_t>(i)]) scores[i] = -1e9F;
    }
  }
  if (!any) {
    out.setZero();
    return;
  }
  softmax(scores);
  out.noalias() = encoded.transpose() * scores;
}

void Network::run_history(const EncodedWorld& world) {
  if (config_.temporal == TemporalContext::kNone || config_.temporal == TemporalContext::kState) return;
  // Go on after the goals that the state has already read, when these are the same ones.
  const std::size_t read = remembered_first_.size() - 1;
  bool same = read < world.first_past.size() && remembered_.size() <= world.past.size() &&
              std::equal(remembered_first_.begin(), remembered_first_.end(), world.first_past.begin()) &&
              std::equal(remembered_.begin(), remembered_.end(), world.past.begin());
  if (!same) forget();
  for (std::size_t goal = remembered_first_.size() - 1; goal + 1 < world.first_past.size(); ++goal) {
    past_.setZero();
    for (const PastPredicate& past : world.past_of(static_cast<int>(goal))) {
      if (config_.temporal == TemporalContext::kPositive && !is_positive_token(past.token)) continue;
      past_ += w_.past_token.row(past.token).transpose() + name_main_.row(past.main_slot).transpose();
      if (past.second_slot >= 0) past_ += name_second_.row(past.second_slot).transpose();
      if (past.value >= 0) past_ += w_.past_value.row(past.value).transpose();
    }
    lstm_step(past_, w_.lstm_in, w_.lstm_hidden, w_.lstm_bias, lstm_gates_, history_, memory_);
  }
  remembered_.assign(world.past.begin(), world.past.end());
  remembered_first_.assign(world.first_past.begin(), world.first_past.end());
}

void Network::forget() {
  history_.setZero();
  memory_.setZero();
  remembered_.clear();
  remembered_first_.assign(1, 0);
}

void Network::remember_state() {
  past_.noalias() = w_.past_state * context_;
  lstm_step(past_, w_.lstm_in, w_.lstm_hidden, w_.lstm_bias, lstm_gates_, history_, memory_);
}

void Network::read_world(const EncodedWorld& world) {
  read_names();
  encode_objects(world);
  attend(w_.attend_objects, nullptr, context_);
  goal_objects_.setZero();
  if (config_.goal_object_attention) attend(w_.attend_goal_objects, &world.mentioned, goal_objects_);
  run_history(world);
}

void Network::start() {
  if (config_.instruction_attention) {
    words_.noalias() = w_.attend_words * history_;
    auto scores = word_scores_.head(length_);
    scores.noalias() = tokens_.topRows(length_) * words_;
    softmax(scores);
    words_.noalias() = tokens_.topRows(length_).transpose() * scores;
  } else {
    words_ = sentence_;
  }
  start_in_ << context_, goal_objects_, sentence_, words_, history_;
  state_.noalias() = w_.start * start_in_;
  state_ += w_.start_bias;
  state_ = state_.array().tanh().matrix();
  main_keys_.topRows(objects_).noalias() = encoded_.topRows(objects_) * w_.main_key.transpose();
  second_keys_ready_ = false;
  input_ = w_.decode_token.row(kStopToken).transpose();
  gates_.noalias() = w_.decode_in * input_;
  gates_ += w_.decode_in_bias;
  gru_step(gates_, w_.decode_hidden, w_.decode_hidden_bias, decoder_gates_, state_);
}

const Vector& Network::token_scores() {
  token_scores_.noalias() = w_.token * state_;
  token_scores_ += w_.token_bias;
  return token_scores_;
}

void Network::query(const Matrix& weights, const Vector& bias, int token, int main, const Matrix& keys,
                    const Vector& out) {
  const Eigen::Index d = config_.decoder, o = config_.object;
  Vector& scores = main < 0 ? main_scores_ : second_scores_;
  const Eigen::Index width = d + o + (main < 0 ? 0 : o);
  query_in_.head(d) = state_;
  query_in_.segment(d, o) = w_.decode_token.row(token).transpose();
  if (main >= 0) query_in_.segment(d + o, o) = encoded_.row(main).transpose();
  query_.noalias() = weights * query_in_.head(width);
  query_ += bias;
  if (scores.size() != objects_) scores.resize(objects_);
  for (Eigen::Index i = 0; i < objects_; ++i) {
    scores[i] = (keys.row(i).transpose() + query_).cwiseMax(0.0F).dot(out);
  }
}

const Vector& Network::main_scores(int token) {
  query(w_.main_query, w_.main_query_bias, token, -1, main_keys_, w_.main_out);
  return main_scores_;
}

const Vector& Network::second_scores(int token, int main) {
  if (!second_keys_ready_) {
    second_keys_.topRows(objects_).noalias() = encoded_.topRows(objects_) * w_.second_key.transpose();
    second_keys_ready_ = true;
  }
  query(w_.second_query, w_.second_query_bias, token, main, second_keys_, w_.second_out);
  return second_scores_;
}

const Vector& Network::value_scores(int token, int main) {
  const Eigen::Index d = config_.decoder, o = config_.object;
  query_in_.head(d) = state_;
  query_in_.segment(d, o) = w_.decode_token.row(token).transpose();
  query_in_.tail(o) = encoded_.row(main).transpose();
  value_scores_.noalias() = w_.value * query_in_;
  value_scores_ += w_.value_bias;
  return value_scores_;
}

void Network::advance(int token, int main, int second, int value) {
  input_ = w_.decode_token.row(token).transpose();
  input_.noalias() += w_.decode_main * encoded_.row(main).transpose();
  if (second >= 0) input_.noalias() += w_.decode_second * encoded_.row(second).transpose();
  if (value >= 0) input_ += w_.decode_value.row(value).transpose();
  gates_.noalias() = w_.decode_in * input_;
  gates_ += w_.decode_in_bias;
  gru_step(gates_, w_.decode_hidden, w_.decode_hidden_bias, decoder_gates_, state_);
}

}  // namespace goalnet::inference::network
