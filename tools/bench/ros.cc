#include "tools/bench/ros.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "components/ros/service.h"
#include "example_interfaces/srv/AddTwoInts_service.h"
#include "std_msgs/msg/String.h"
#include "tools/bench/ros_peer/plain_echo.h"

namespace goalnet::tools {
namespace {

using std_msgs::msg::String;
using SteadyClock = std::chrono::steady_clock;

constexpr std::size_t kMessageBytes = 1000;  // of text: 1 KB on the wire
constexpr auto kPatience = std::chrono::seconds(5);

double microseconds_since(SteadyClock::time_point start) {
  return std::chrono::duration<double, std::micro>(SteadyClock::now() - start).count();
}

// The other process; ends with its standard input.
class Peer {
 public:
  explicit Peer(int domain) {
    const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "goalnet-bench-peer";
    if (!std::filesystem::exists(program))
      throw std::runtime_error("bench ros needs " + program.string() + "; build it");
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("bench ros: no pipe");
    const std::string text = std::to_string(domain);
    pid_ = fork();
    if (pid_ == 0) {
      dup2(ends[0], 0);
      close(ends[1]);
      execl(program.c_str(), program.c_str(), text.c_str(), nullptr);
      _exit(127);
    }
    close(ends[0]);
    input_ = ends[1];
  }
  ~Peer() {
    close(input_);
    int status = 0;
    for (int i = 0; i < 300 && waitpid(pid_, &status, WNOHANG) == 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    kill(pid_, SIGKILL);
    waitpid(pid_, &status, 0);
  }

 private:
  pid_t pid_ = -1;
  int input_ = -1;
};

// Echoes arrive in another thread: wakes whoever waits for the next one, as a condition variable would.
class Echo {
 public:
  void arrived() {
    {
      std::lock_guard lock(mutex_);
      ++count_;
    }
    changed_.notify_one();
  }
  bool wait() {
    std::unique_lock lock(mutex_);
    const bool came = changed_.wait_for(lock, kPatience, [this] { return count_ > seen_; });
    seen_ = count_;
    return came;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int count_ = 0;
  int seen_ = 0;
};

// Everything that is measured in turns, one round trip each.
class RoundTrips {
 public:
  RoundTrips(ros::Node& node, int domain)
      : node_(node),
        plain_(domain, "rt/bench/plain_pong", "rt/bench/plain_ping",
               [this](const std::string&) { plain_echo_.arrived(); }),
        waiting_(domain, "rt/bench/waiting_pong", "rt/bench/waiting_ping",
                 [this](const std::string&) { waiting_echo_.arrived(); }),
        direct_out_(node.advertise<String>("/bench/direct_ping")),
        direct_in_(node.subscribe<String>("/bench/direct_pong", ros::Qos::standard(),
                                          [this](const String&) { direct_echo_.arrived(); },
                                          {.immediate = true})),
        queued_out_(node.advertise<String>("/bench/queued_ping")),
        queued_in_(node.subscribe<String>("/bench/queued_pong", ros::Qos::standard(),
                                          [this](const String&) { ++queued_; })),
        client_(node, "/bench/add"),
        text_(kMessageBytes, 'x') {
    message_.data(text_);
    const auto end = SteadyClock::now() + kPatience;
    const auto plain_matched = [this] { return plain_.matched() && waiting_.matched(); };
    while (!plain_matched() && SteadyClock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (!plain_matched() || !direct_out_->wait_for_subscribers() || !direct_in_->wait_for_publishers() ||
        !queued_out_->wait_for_subscribers() || !queued_in_->wait_for_publishers() ||
        !client_.wait_for_service()) {
      throw std::runtime_error("bench ros: goalnet-bench-peer was not found");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(500));  // until the other side has matched as well
  }

  double plain() {
    return timed([this] { plain_.write(text_); }, [this] { return plain_echo_.wait(); });
  }
  double waiting() {
    return timed([this] { waiting_.write(text_); }, [this] { return waiting_echo_.wait(); });
  }
  double direct() {
    return timed([this] { direct_out_->publish(message_); }, [this] { return direct_echo_.wait(); });
  }
  double queued() {
    const int before = queued_;
    return timed([this] { queued_out_->publish(message_); },
                 [&] { return node_.loop().run_for(kPatience, [&] { return queued_ > before; }); });
  }
  double service() {
    bool answered = false;
    return timed([&] { client_.call({}, [&](auto response) { answered = response.has_value(); }); },
                 [&] { return node_.loop().run_for(kPatience, [&] { return answered; }); });
  }

 private:
  template <class Send, class Wait>
  double timed(const Send& send, const Wait& wait) {
    const auto start = SteadyClock::now();
    send();
    if (!wait()) throw std::runtime_error("bench ros: an echo did not come back");
    return microseconds_since(start);
  }

  ros::Node& node_;
  Echo plain_echo_, waiting_echo_, direct_echo_;
  int queued_ = 0;
  PlainEndpoint plain_, waiting_;
  std::shared_ptr<ros::Publisher<String>> direct_out_;
  std::shared_ptr<ros::Subscription<String>> direct_in_;
  std::shared_ptr<ros::Publisher<String>> queued_out_;
  std::shared_ptr<ros::Subscription<String>> queued_in_;
  ros::Client<example_interfaces::srv::AddTwoInts> client_;
  std::string text_;
  String message_;
};

// A new participant and node until the first message of a writer that was there before [ms].
double start_to_first_message(int domain) {
  const auto start = SteadyClock::now();
  auto context = ros::Context::create({.domain_id = domain});
  if (!context) throw std::runtime_error("bench ros: " + context.error().message);
  ros::EventLoop loop;
  ros::NodeOptions options;
  options.name = "bench_start";
  ros::Node node(**context, loop, options);
  bool seen = false;
  auto in = node.subscribe<String>("/bench/beat", ros::Qos::standard(), [&](const String&) { seen = true; });
  if (!loop.run_for(kPatience, [&] { return seen; })) throw std::runtime_error("bench ros: no first message");
  return microseconds_since(start) / 1000.0;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

// How much longer `a` takes than `b`, which took turns: the median of the ratios of short stretches, so that
// a load on the machine that comes and goes hits both sides of each ratio.
double ratio(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr std::ptrdiff_t kStretch = 50;
  std::vector<double> ratios;
  for (std::ptrdiff_t at = 0; at + kStretch <= static_cast<std::ptrdiff_t>(a.size()); at += kStretch) {
    ratios.push_back(median({a.begin() + at, a.begin() + at + kStretch}) /
                     median({b.begin() + at, b.begin() + at + kStretch}));
  }
  return median(std::move(ratios));
}

}  // namespace

nlohmann::json bench_ros(const BenchOptions& options) {
  // Below 102 the ports of a domain are nobody else's.
  const int domain = 72 + static_cast<int>(getpid() % 9);
  const int count = options.quick ? 500 : 5000;
  Peer peer(domain);
  auto context = ros::Context::create({.domain_id = domain});
  if (!context) throw std::runtime_error("bench ros: " + context.error().message);
  ros::EventLoop loop;
  ros::NodeOptions node_options;
  node_options.name = "bench";
  ros::Node node(**context, loop, node_options);

  // One of each in turn, so that a change of the machine's load hits all alike.
  std::vector<double> plain, waiting, direct, queued, service, start;
  {
    RoundTrips trips(node, domain);
    for (int i = -count / 10; i < count; ++i) {
      const double times[] = {trips.plain(), trips.waiting(), trips.direct(), trips.queued(),
                              trips.service()};
      if (i < 0) continue;  // warming up
      plain.push_back(times[0]);
      waiting.push_back(times[1]);
      direct.push_back(times[2]);
      queued.push_back(times[3]);
      service.push_back(times[4]);
    }
  }
  for (int i = 0; i < (options.quick ? 5 : 20); ++i) start.push_back(start_to_first_message(domain));

  return {{"message_bytes", kMessageBytes},
          {"plain_fast_dds_round_trip", summary(plain, "us")},
          // The other process hears of the message in a thread of its own, as an event loop does.
          {"plain_fast_dds_with_wait_set_round_trip", summary(waiting, "us")},
          {"immediate_callback_round_trip", summary(direct, "us")},
          {"event_loop_callback_round_trip", summary(queued, "us")},
          {"service_round_trip", summary(service, "us")},
          {"start_to_first_message", summary(start, "ms")},
          {"immediate_to_plain_ratio", ratio(direct, plain)},
          {"event_loop_to_plain_ratio", ratio(queued, plain)},
          {"event_loop_to_plain_with_wait_set_ratio", ratio(queued, waiting)},
          {"service_to_plain_ratio", ratio(service, plain)}};
}

}  // namespace goalnet::tools
