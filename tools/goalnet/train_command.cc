#include "tools/goalnet/train_command.h"

#include <cstdio>
#include <filesystem>

#include "tools/goalnet/command_line.h"
#include "tools/goalnet/progress_line.h"
#include "tools/goalnet/train_kinds.h"

namespace goalnet::tools {
namespace {

std::string typed(int argc, char** argv) {
  std::string text;
  for (int i = 0; i < argc; ++i) text += (i > 0 ? " " : "") + std::string(argv[i]);
  return text;
}

}  // namespace

int train_command(int argc, char** argv) {
  TrainRequest request;
  std::string data, out, model(train_kinds()[0].name);
  std::vector<std::string> settings;
  bool json = false;
  CLI::App app{"Learns a model from a folder of demonstrations.", "goalnet train"};
  app.footer(
      "Examples:\n"
      "  goalnet train demonstrations -o model.safetensors\n"
      "  goalnet run --model model.safetensors \"fill the mug with water\"\n"
      "\n"
      "Ctrl-C keeps a checkpoint beside the model; the same command goes on from there.");
  app.add_option("DIR", data, "folder of demonstrations (*.json)")->required();
  app.add_option("-o,--out", out, "the model file to write")->required();
  std::string kinds;
  for (const TrainKind& kind : train_kinds())
    kinds += "\n  " + std::string(kind.name) + ": " + std::string(kind.summary);
  app.add_option("--model", model, "what to train:" + kinds);
  app.add_option("--seed", request.seed, "fixes everything that is random");
  app.add_option("--set", settings, "a setting of the training, NAME=VALUE (repeatable)");
  app.add_flag("--fresh", request.fresh, "start anew even if an interrupted training left a checkpoint");
  app.add_flag("--json", json, "print the result as one JSON object");
  if (const auto code = parse_or_tell(app, argc, argv)) return *code;
  const auto failed = [&](const Error& error) { return tell(app.get_name(), error, json); };
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
      return failed({Outcome::kInvalidRequest, "--set " + setting + " should be NAME=VALUE"});
    request.settings[setting.substr(0, equals)] = setting.substr(equals + 1);
  }
  const TrainKind* kind = nullptr;
  for (const TrainKind& known : train_kinds()) {
    if (known.name == model) kind = &known;
  }
  if (kind == nullptr)
    return failed(
        {Outcome::kInvalidRequest, "there is no model \"" + model + "\" in this build; there are:" + kinds});
  // Known before the training, not after it.
  if (std::error_code none; std::filesystem::is_directory(out, none))
    return failed(
        {Outcome::kInvalidRequest, out + " is a folder; -o takes the model's file, for example " +
                                       (std::filesystem::path(out) / "model.safetensors").string()});
  request.data = data;
  request.out = out;
  request.command = typed(argc, argv);
  ProgressLine line;
  request.progress = [&line](double done, const std::string& measured) { line.show(done, measured); };
  const auto trained = kind->train(request);
  line.finish();
  if (!trained) return failed(trained.error());
  if (json) {
    print_json({{"model", out}, {"kind", model}, {"seed", request.seed}, {"wall_time_s", line.seconds()}});
  } else {
    std::fprintf(stderr, "wrote %s after %.0f s\n", out.c_str(), line.seconds());
  }
  return 0;
}

}  // namespace goalnet::tools
