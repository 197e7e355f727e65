#include "tools/goalnet/launch/life_signs.h"

#include <unistd.h>

#include <charconv>
#include <chrono>
#include <map>
#include <mutex>
#include <thread>

#include "components/ros/node.h"
#include "components/ros/service.h"
#include "lifecycle_msgs/srv/GetState_service.h"

namespace goalnet::tools {
namespace {

using GetState = lifecycle_msgs::srv::GetState;
constexpr auto kAskEvery = std::chrono::seconds(1);
// Whoever is up answers a newcomer within some 50 ms.
constexpr auto kLookAround = std::chrono::milliseconds(500);

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

struct LifeSigns::Impl {
  // Processes may be on DDS domains of their own, and speak as another distribution does.
  struct Domain {
    std::unique_ptr<ros::Context> context;
    std::unique_ptr<ros::Node> node;
  };
  ros::EventLoop loop;
  ros::Clock wall;                                                // simulated time may stand still
  std::map<std::pair<std::string, std::string>, Domain> domains;  // by ROS_DOMAIN_ID and GOALNET_ROS_DISTRO
  std::map<std::string, std::unique_ptr<ros::Client<GetState>>> clients;  // by full name of the node
  std::shared_ptr<ros::Timer> timer;
  mutable std::mutex mutex;
  std::map<std::string, double> last;
  std::jthread thread;

  Expected<ros::Node*> node_on(const LaunchedProcess& process) {
    const auto own = [&](const char* name) -> std::string {
      const auto found = process.environment.find(name);
      return found == process.environment.end() ? "" : found->second;
    };
    const std::string id = own("ROS_DOMAIN_ID"), distro = own("GOALNET_ROS_DISTRO");
    Domain& domain = domains[{id, distro}];
    if (domain.node) return domain.node.get();
    ros::ContextOptions options;
    if (!distro.empty()) {
      auto parsed = ros::parse_distro(distro);
      if (!parsed)
        return fail(Outcome::kInvalidRequest,
                    "GOALNET_ROS_DISTRO of process " + process.name + ": " + parsed.error().message);
      options.distro = *parsed;
    }
    if (int number = 0; std::from_chars(id.data(), id.data() + id.size(), number).ec == std::errc{})
      options.domain_id = number;
    auto context = ros::Context::create(options);
    if (!context) return tl::unexpected<Error>(std::move(context.error()));
    domain.context = std::move(*context);
    ros::NodeOptions node_options;
    node_options.name = "goalnet_launch_" + std::to_string(getpid());
    node_options.arguments.console = false;
    auto node = ros::Node::create(*domain.context, loop, std::move(node_options));
    if (!node) return tl::unexpected<Error>(std::move(node.error()));
    domain.node = std::move(*node);
    return domain.node.get();
  }

  void ask() {
    for (const auto& [name, client] : clients) {
      if (!client->ready()) continue;
      client->call({}, [this, name = name](const auto& state) {
        if (!state) return;
        const std::lock_guard lock(mutex);
        last[name] = now();
      });
    }
  }

  ~Impl() {
    loop.stop();
    if (thread.joinable()) thread.join();
    timer.reset();
    clients.clear();
    domains.clear();
  }
};

LifeSigns::LifeSigns(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LifeSigns::~LifeSigns() = default;

Expected<std::unique_ptr<LifeSigns>> LifeSigns::watch(const LaunchPlan& plan) {
  auto impl = std::make_unique<Impl>();
  for (const LaunchedProcess& process : plan.processes) {
    if (process.node.empty()) continue;
    auto node = impl->node_on(process);
    if (!node) return tl::unexpected<Error>(std::move(node.error()));
    impl->clients[process.node] =
        std::make_unique<ros::Client<GetState>>(**node, process.node + "/get_state");
  }
  impl->timer = ros::Timer::create(impl->loop, impl->wall, kAskEvery, [raw = impl.get()] { raw->ask(); });
  impl->thread = std::jthread([raw = impl.get()](const std::stop_token&) { raw->loop.run(); });
  return std::unique_ptr<LifeSigns>(new LifeSigns(std::move(impl)));
}

std::string LifeSigns::up_already() const {
  const auto end = std::chrono::steady_clock::now() + kLookAround;
  do {
    for (const auto& [name, client] : impl_->clients) {
      if (client->ready()) return name;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  } while (std::chrono::steady_clock::now() < end);
  return "";
}

double LifeSigns::last(const std::string& node) const {
  const std::lock_guard lock(impl_->mutex);
  const auto found = impl_->last.find(node);
  return found == impl_->last.end() ? 0.0 : found->second;
}

}  // namespace goalnet::tools
