// `goalnet replay`: publishes what a bag holds.
#pragma once

namespace goalnet::tools {

int replay_command(int argc, char** argv);

}  // namespace goalnet::tools
