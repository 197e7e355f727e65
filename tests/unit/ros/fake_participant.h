// A DDS participant of a few sockets, for what no DDS library lets a test do: answer an announcement once, at
// once, or not listen.
#pragma once

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "components/ros/detail/announcements.h"

namespace goalnet::ros {

class FakeParticipant {
 public:
  using Bytes = std::vector<std::uint8_t>;

  // The last byte of the vendor's id: 0x0f for Fast DDS, 0x10 for Cyclone DDS.
  explicit FakeParticipant(int domain, std::uint8_t number = 0, std::uint8_t vendor = 0x0f)
      : port_(static_cast<std::uint16_t>(7400 + 250 * domain)), vendor_(vendor) {
    prefix_[7] = number;
    unicast_ = ::socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in own = address("127.0.0.1", 0);
    socklen_t size = sizeof own;
    if (::bind(unicast_, reinterpret_cast<sockaddr*>(&own), sizeof own) != 0 ||
        ::getsockname(unicast_, reinterpret_cast<sockaddr*>(&own), &size) != 0) {
      throw std::runtime_error("no socket");
    }
    own_port_ = ntohs(own.sin_port);
    multicast_ = ::socket(AF_INET, SOCK_DGRAM, 0);
    const int yes = 1;
    ::setsockopt(multicast_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in any = address("0.0.0.0", port_);
    if (::bind(multicast_, reinterpret_cast<sockaddr*>(&any), sizeof any) != 0)
      throw std::runtime_error("no multicast socket");
    ip_mreq group{};
    group.imr_multiaddr.s_addr = inet_addr("239.255.0.1");
    group.imr_interface.s_addr = inet_addr("127.0.0.1");
    ::setsockopt(multicast_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group);
    in_addr loopback{inet_addr("127.0.0.1")};
    ::setsockopt(unicast_, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback);
    for (const int one : {unicast_, multicast_}) {
      timeval patience{0, 20'000};
      ::setsockopt(one, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    }
  }
  ~FakeParticipant() {
    ::close(unicast_);
    ::close(multicast_);
  }
  FakeParticipant(const FakeParticipant&) = delete;

  const std::array<std::uint8_t, 12>& prefix() const { return prefix_; }
  // Another participant from now on, as far as others can tell.
  void rename() {
    for (std::size_t i = prefix_.size() - 1; i >= 8 && ++prefix_[i] == 0; --i) {
    }
  }
  // What it announces: others forget it after this time without a word.
  void set_lease(std::chrono::milliseconds lease) { lease_ = lease; }

  // Announces itself to everybody, or to one participant alone.
  void announce() { send(announcement(), address("239.255.0.1", port_)); }
  void announce_to(const detail::UdpAddress& to) {
    char text[20];
    std::snprintf(text, sizeof text, "%d.%d.%d.%d", to.ip[0], to.ip[1], to.ip[2], to.ip[3]);
    send(announcement(), address(text, to.port));
  }

  // Says to everybody that it goes, as who is not killed, in the words of its vendor.
  void leave() { send(vendor_ == 0x10 ? farewell() : disposal(), address("239.255.0.1", port_)); }

  // The next announcement of anybody that comes by multicast; nothing after 20 ms.
  std::optional<detail::Announcement> heard() { return detail::read_announcement(receive(multicast_)); }
  // The next message to us alone; empty after 20 ms.
  Bytes received() { return receive(unicast_); }

  Bytes announcement() const {
    Bytes body = data(1);
    append(body, {0, 3, 0, 0});
    parameter(body, 0x15, {2, 3, 0, 0});
    parameter(body, 0x16, {0x01, vendor_, 0, 0});
    parameter(body, 0x50, guid());
    Bytes locator;
    append(locator, {1, 0, 0, 0, low(own_port_), high(own_port_), 0, 0});
    append(locator, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 127, 0, 0, 1});
    parameter(body, 0x32, locator);  // metatraffic
    parameter(body, 0x31, locator);
    parameter(body, 0x02, duration(lease_));
    parameter(body, 0x58, {0x3f, 0x0c, 0, 0});
    parameter(body, 1, {});
    return message(0x05, body);
  }

  // As Cyclone DDS says that it goes: its key is the payload.
  Bytes farewell() const {
    Bytes body = data(2);
    parameter(body, 0x71, {0, 0, 0, 3});  // disposed and unregistered
    parameter(body, 1, {});
    append(body, {0, 3, 0, 0});
    parameter(body, 0x50, guid());
    parameter(body, 1, {});
    return message(0x0b, body);
  }

 private:
  Bytes disposal() const {
    Bytes body = data(2);
    parameter(body, 0x70, guid());
    parameter(body, 0x71, {0, 0, 0, 3});  // disposed and unregistered
    parameter(body, 1, {});
    return message(0x03, body);
  }
  Bytes guid() const {
    Bytes out;
    append(out, prefix_);
    append(out, {0, 0, 1, 0xc1});
    return out;
  }
  static Bytes duration(std::chrono::milliseconds time) {
    Bytes out;
    for (const std::uint64_t word :
         {std::uint64_t(time.count() / 1000), (std::uint64_t(time.count() % 1000) << 32) / 1000}) {
      append(out, {low(word), high(word), high(word >> 8), high(word >> 16)});
    }
    return out;
  }
  // How a sample of the writer of participants begins.
  static Bytes data(std::uint8_t sequence_number) {
    return {0, 0, 16, 0, 0, 1, 0, 0xc7, 0, 1, 0, 0xc2, 0, 0, 0, 0, sequence_number, 0, 0, 0};
  }
  Bytes message(std::uint8_t flags, const Bytes& body) const {
    Bytes out;
    append(out, {'R', 'T', 'P', 'S', 2, 3, 0x01, vendor_});
    append(out, prefix_);
    append(out, {0x15, flags, low(body.size()), high(body.size())});
    append(out, body);
    return out;
  }
  static sockaddr_in address(const char* ip, std::uint16_t port) {
    sockaddr_in out{};
    out.sin_family = AF_INET;
    out.sin_addr.s_addr = inet_addr(ip);
    out.sin_port = htons(port);
    return out;
  }
  static std::uint8_t low(std::size_t number) { return static_cast<std::uint8_t>(number); }
  static std::uint8_t high(std::size_t number) { return static_cast<std::uint8_t>(number >> 8); }
  static void append(Bytes& out, std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) out.push_back(byte);
  }
  static void append(Bytes& out, std::initializer_list<std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) out.push_back(byte);
  }
  static void parameter(Bytes& out, std::uint8_t id, const Bytes& value) {
    append(out, {id, 0, low(value.size()), 0});
    append(out, value);
  }
  void send(const Bytes& bytes, const sockaddr_in& to) {
    ::sendto(unicast_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }
  static Bytes receive(int from) {
    Bytes buffer(65'536);
    const ssize_t size = ::recv(from, buffer.data(), buffer.size(), 0);
    buffer.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
    return buffer;
  }

  const std::uint16_t port_;
  const std::uint8_t vendor_;
  std::uint16_t own_port_ = 0;
  int unicast_ = -1, multicast_ = -1;
  std::chrono::milliseconds lease_{20'000};
  std::array<std::uint8_t, 12> prefix_{0x01, 0x0f, 0x12, 0x34, 0x56, 0x78, 0, 0, 0, 0, 0, 1};
};

}  // namespace goalnet::ros
