#include "tools/goalnet/ablate_variants.h"

namespace goalnet::tools {
namespace {

using inference::network::SentenceEncoding;
using inference::network::TemporalContext;
using inference::training::TrainOptions;
using Group = Variant::Group;
using Kind = Variant::Kind;

const std::array kVariants = {
    Variant{"she2016", "She et al. 2016", Group::kModel, Kind::kBaseline, nullptr,
            PaperScores{.448, .450, .512, .370}},
    Variant{"goalnet", "GoalNet", Group::kModel, Kind::kNetwork, [](TrainOptions&) {},
            PaperScores{.562, .601, .651, .468}},
    Variant{"shipped", "goalnet as shipped (ranker)", Group::kModel, Kind::kShipped, nullptr, {}},
    Variant{"no_relations",
            "without relational information",
            Group::kAblation,
            Kind::kNetwork,
            [](TrainOptions& o) { o.config.relations = false; },
            {}},
    Variant{"no_grounding",
            "without instance grounding",
            Group::kAblation,
            Kind::kNetwork,
            [](TrainOptions& o) { o.config.instance_grounding = false; },
            {}},
    Variant{"no_negative",
            "without prediction of negative predicates",
            Group::kAblation,
            Kind::kNetwork,
            [](TrainOptions& o) { o.config.negative = false; },
            {}},
    Variant{"no_positive",
            "without prediction of positive predicates",
            Group::kAblation,
            Kind::kNetwork,
            [](TrainOptions& o) { o.config.positive = false; },
            {}},
    Variant{"no_temporal",
            "without temporal context",
            Group::kAblation,
            Kind::kNetwork,
            [](TrainOptions& o) { o.config.temporal = TemporalContext::kNone; },
            {}},
    Variant{"no_grammar",
            "without grammar mask",
            Group::kAblation,
            Kind::kNetwork,
            [](TrainOptions& o) { o.config.grammar_mask = false; },
            {}},
    Variant{"no_goal_objects",
            "without goal-object attention",
            Group::kAblation,
            Kind::kNetwork,
            [](TrainOptions& o) { o.config.goal_object_attention = false; },
            {}},
    Variant{"no_instruction_attention",
            "without instruction-conditioned attention",
            Group::kAblation,
            Kind::kNetwork,
            [](TrainOptions& o) { o.config.instruction_attention = false; },
            {}},
    Variant{"word_mean",
            "instruction as the mean of word vectors",
            Group::kExploration,
            Kind::kNetwork,
            [](TrainOptions& o) { o.config.encoding = SentenceEncoding::kWordMean; },
            {}},
    Variant{"temporal_both",
            "temporal context of positive and negative predicates",
            Group::kExploration,
            Kind::kNetwork,
            [](TrainOptions& o) { o.config.temporal = TemporalContext::kBoth; },
            {}},
    Variant{"temporal_state",
            "temporal context of states",
            Group::kExploration,
            Kind::kNetwork,
            [](TrainOptions& o) { o.config.temporal = TemporalContext::kState; },
            {}},
    Variant{"planner", "trained with the planner in the loop", Group::kExploration, Kind::kNetwork,
            [](TrainOptions& o) { o.with_planner = true; }, PaperScores{.645, .661, .717, .558}},
};

}  // namespace

std::span<const Variant> variants() { return kVariants; }

}  // namespace goalnet::tools
