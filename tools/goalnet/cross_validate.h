#pragma once

#include <cstdint>
#include <string>

namespace goalnet::tools {

struct CrossValidateRequest {
  std::string folder;           // of demonstrations
  std::string by = "scenario";  // or "verb"
  std::string grounding = "given";
  int folds = 5;
  int only = 0;  // how many of the folds to run; 0: all
  std::uint64_t seed = 7;
  unsigned threads = 1;
  std::string sentences;  // table of other sentences to test with; empty: the recorded ones
  std::string runs;       // write the runs here, for score.py; empty: nowhere
  bool json = false;
};

// goalnet eval DIR --cross-validate scenario|verb: trains the shipped kind of model anew for each fold and
// prints mean and spread of the scores over the folds, and how well the confidence is calibrated. Returns the
// exit code.
int cross_validate(const CrossValidateRequest& request);

}  // namespace goalnet::tools
