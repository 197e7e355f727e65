// The two recurrent cells, with the gate order and formulas of libtorch's GRUCell and LSTMCell.
#pragma once

#include "components/goalnet/network/tensors.h"

namespace goalnet::inference::network {

// Scratch for one cell; sized by the caller once.
struct GateScratch {
  Vector in, hidden;
};

// state <- GRU(gates_in, state). gates_in = W x + b (3 n: reset, update, new).
template <class In>
void gru_step(const In& gates_in, const Matrix& hidden, const Vector& hidden_bias, GateScratch& scratch,
              Eigen::Ref<Vector> state) {
  const Eigen::Index n = state.size();
  scratch.hidden.noalias() = hidden * state;
  scratch.hidden += hidden_bias;
  auto gates = scratch.hidden.head(2 * n);
  gates += gates_in.head(2 * n);
  gates = gates.array().logistic().matrix();
  auto fresh = scratch.hidden.tail(n);
  fresh = (gates_in.tail(n).array() + gates.head(n).array() * fresh.array()).tanh().matrix();
  state = (fresh.array() + gates.tail(n).array() * (state.array() - fresh.array())).matrix();
}

// (state, memory) <- LSTM(input). Gates: input, forget, cell, output.
inline void lstm_step(const Vector& input, const Matrix& in, const Matrix& hidden, const Vector& bias,
                      GateScratch& scratch, Vector& state, Vector& memory) {
  const Eigen::Index n = state.size();
  scratch.in.noalias() = in * input;
  scratch.hidden.noalias() = hidden * state;
  scratch.in += scratch.hidden;
  scratch.in += bias;
  auto g = scratch.in.array();
  g.head(2 * n) = g.head(2 * n).logistic();
  g.segment(2 * n, n) = g.segment(2 * n, n).tanh();
  g.tail(n) = g.tail(n).logistic();
  memory.array() = g.segment(n, n) * memory.array() + g.head(n) * g.segment(2 * n, n);
  state.array() = g.tail(n) * memory.array().tanh();
}

}  // namespace goalnet::inference::network
