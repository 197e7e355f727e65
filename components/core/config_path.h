// Where this program and its configuration lie.
#pragma once

#include <string>
#include <string_view>

namespace goalnet {

// The folder in which this program lies.
std::string program_folder();

// The folder `config`: the environment variable GOALNET_CONFIG_DIR, else ./config if it is ours (has
// scenes/), else the one installed with this program (../share/goalnet/config beside its folder), else that
// of the source tree it was built from.
std::string config_folder();

// config_path("domains/household.pddl") is that file in the folder above.
std::string config_path(std::string_view relative);

// config_file("domains", "household", ".pddl") is the same file; a name with a slash or that ending is a path
// already.
std::string config_file(std::string_view folder, std::string_view name_or_path, std::string_view ending);

}  // namespace goalnet
