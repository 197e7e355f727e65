#include "tools/goalnet/train_ranker_kind.h"

#include <charconv>
#include <filesystem>

#include "components/goalnet/ranker/train.h"
#include "tools/goalnet/stop_signal.h"

namespace goalnet::tools {
namespace {

using namespace goalnet::inference;

template <class Number>
bool parse_number(const std::string& text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

Expected<void> apply_setting(const std::string& name, const std::string& value, TrainingOptions& options) {
  bool good = true;
  if (name == "epochs")
    good = parse_number(value, options.ranker.training.epochs) && options.ranker.training.epochs > 0;
  else if (name == "rate")
    good = parse_number(value, options.ranker.training.rate);
  else if (name == "samples")
    good = parse_number(value, options.ranker.samples) && options.ranker.samples <= 10000;
  else if (name == "neighbours")
    good = parse_number(value, options.ranker.neighbours) && options.ranker.neighbours <= 1000;
  else if (name == "replays")
    good = parse_number(value, options.ranker.replays) && options.ranker.replays <= 1000;
  else if (name == "rerank")
    options.rerank = value != "0";
  else
    return fail(Outcome::kInvalidRequest,
                "the ranker has no setting \"" + name +
                    "\"; it has epochs, rate, samples, neighbours, replays, rerank");
  if (!good) return fail(Outcome::kInvalidRequest, "--set " + name + "=" + value + " is no value for it");
  return {};
}

}  // namespace

Expected<void> train_ranker_kind(const TrainRequest& request) {
  TrainingOptions options;
  options.command = request.command;
  options.ranker.training.seed = request.seed;
  for (const auto& [name, value] : request.settings)
    if (auto ok = apply_setting(name, value, options); !ok) return ok;
  auto language = read_language_texts();
  if (!language) return tl::unexpected(language.error());
  options.language = std::move(*language);
  options.checkpoint = request.out.string() + ".checkpoint";
  std::error_code ignored;
  if (request.fresh) std::filesystem::remove(options.checkpoint, ignored);
  const StopSignal stop;
  options.progress = [&](const std::string& what, double done) {
    if (request.progress) request.progress(done, what);
    return !stop.requested();
  };
  const auto demonstrations = read_demonstrations(request.data);
  if (!demonstrations) return tl::unexpected(demonstrations.error());
  const auto parts = train(*demonstrations, options);
  if (!parts && parts.error().outcome == Outcome::kCancelled)
    return fail(Outcome::kCancelled, "stopped; the same command goes on from " + options.checkpoint);
  if (!parts) return tl::unexpected(parts.error());
  if (auto written = write_ranker(*parts, request.out.string()); !written) return written;
  std::filesystem::remove(options.checkpoint, ignored);
  return {};
}

}  // namespace goalnet::tools
