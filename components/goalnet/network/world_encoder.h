// Turns facts, history and the words of the instruction into an EncodedWorld.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "components/core/predicate.h"
#include "components/goalnet/goal_model.h"
#include "components/goalnet/network/encoded_world.h"
#include "components/goalnet/network/grammar.h"
#include "components/goalnet/network/lexicon.h"
#include "components/goalnet/network/name_table.h"
#include "components/goalnet/network/network_config.h"

namespace goalnet::inference::network {

inline constexpr std::size_t kMaxObjects = 4096;  // a world larger than this is refused

// The instruction as the world encoder sees it.
struct EncodedSentence {
  std::vector<int> words;  // ids in the lexicon, -1 for unknown words, in order
  int known() const;
};

// Not thread-safe: keeps scratch memory. Allocates only while its buffers grow.
class WorldEncoder {
 public:
  // All references must outlive the encoder. `vectors`: the stored word vectors, one row per word.
  WorldEncoder(const NetworkConfig& config, const Lexicon& lexicon, const Grammar& grammar,
               const Matrix& vectors, NameTable& names);

  // Encodes `state`, in which `goals` have been pursued before. `texts` are the sentence's words, for
  // grounding. Facts about objects that state.objects lacks are ignored. kInvalidRequest above kMaxObjects
  // objects.
  Expected<void> encode(const EncodedSentence& sentence, std::span<const std::string> texts,
                        const Grounding* grounding, const WorldState& state, std::span<const Goal> goals,
                        EncodedWorld& out);

 private:
  struct Mention {
    float grounded_share, sense, similarity;
    int grounded_rank, sense_rank;
    bool grounded, full_name, partial_name;
  };

  void read_facts(const WorldState& state, EncodedWorld& out);
  void read_goals(std::span<const Goal> goals, EncodedWorld& out);
  void read_grounding(std::span<const std::string> texts, const Grounding& grounding);
  void match_words(const EncodedSentence& sentence, const EncodedWorld& world);
  void write_items(EncodedWorld& out);
  void add(int object, int feature, float value) { scratch_.push_back({object, {feature, value}}); }

  const NetworkConfig& config_;
  const Lexicon& lexicon_;
  const Grammar& grammar_;
  Matrix unit_vectors_;  // word vectors of length 1
  NameTable& names_;
  NameIndex index_;
  struct Scratch {
    int object;
    FeatureItem item;
  };
  std::vector<Scratch> scratch_;
  std::vector<Mention> mentions_;
  std::vector<int> class_count_, class_rank_;
};

}  // namespace goalnet::inference::network
