#include "components/core/config_path.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace goalnet {

std::string program_folder() {
  std::error_code failed;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", failed);
  return failed ? "." : program.parent_path().string();
}

std::string config_folder() {
  if (const char* folder = std::getenv("GOALNET_CONFIG_DIR"); folder != nullptr && *folder != '\0')
    return folder;
  std::error_code ignored;
  if (std::filesystem::is_directory("config/scenes", ignored)) return "config";
  std::string installed = program_folder() + "/../share/goalnet/config";
  if (std::filesystem::is_directory(installed, ignored))
    return std::filesystem::path(installed).lexically_normal().string();
  return GOALNET_CONFIG_FOLDER;
}

std::string config_path(std::string_view relative) { return config_folder() + "/" + std::string(relative); }

std::string config_file(std::string_view folder, std::string_view name_or_path, std::string_view ending) {
  if (name_or_path.find('/') != std::string_view::npos || name_or_path.ends_with(ending))
    return std::string(name_or_path);
  return config_path(std::string(folder) + "/" + std::string(name_or_path) + std::string(ending));
}

}  // namespace goalnet
