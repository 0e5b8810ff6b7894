#include "trainer/training/ranks.h"

#include <torch/types.h>

#include <charconv>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <torch/csrc/distributed/c10d/ProcessGroupGloo.hpp>
#include <torch/csrc/distributed/c10d/TCPStore.hpp>

#include "trainer/training/slurm_step.h"

namespace cps {

struct Ranks::Group {
  c10::intrusive_ptr<c10d::ProcessGroupGloo> gloo;
};

Ranks::Ranks() = default;
Ranks::~Ranks() = default;
Ranks::Ranks(Ranks&&) noexcept = default;
Ranks& Ranks::operator=(Ranks&&) noexcept = default;

namespace {

const char* variable(const char* name, const char* other = nullptr) {
  const char* value = std::getenv(name);
  return value || !other ? value : std::getenv(other);
}

int number(const char* name, const char* text, int min, int max) {
  int value = 0;
  const std::string_view word = text ? text : "";
  const auto [end, error] = std::from_chars(word.begin(), word.end(), value);
  if (error != std::errc() || end != word.end() || word.empty() || value < min || value > max)
    throw std::runtime_error(std::string(name) + ": must be a whole number from " + std::to_string(min) +
                             " to " + std::to_string(max) + ", not '" + std::string(word) + "'");
  return value;
}

std::shared_ptr<gloo::transport::Device> device_towards(const std::string& host) {
  using Gloo = c10d::ProcessGroupGloo;
  if (const char* interface = variable("CPS_NETWORK_INTERFACE"))
    return Gloo::createDeviceForInterface(interface);
  return host == "127.0.0.1" ? Gloo::createDeviceForHostname(host) : Gloo::createDefaultDevice();
}

[[noreturn]] void lost(const std::exception& error) {
  const std::string what = error.what();
  throw std::runtime_error("another process of this training is gone or cannot be reached: " +
                           what.substr(0, what.find('\n')));
}

}  // namespace

void Ranks::sum(torch::Tensor& tensor) const {
  if (!group_) return;
  try {
    std::vector<torch::Tensor> tensors{tensor.cpu()};
    group_->gloo->allreduce(tensors)->wait();
    if (!tensor.is_cpu()) tensor.copy_(tensors[0]);
  } catch (const std::exception& error) {
    lost(error);
  }
}

double Ranks::sum(double value) const {
  torch::Tensor tensor = torch::full({1}, value, torch::kDouble);
  sum(tensor);
  return tensor.item<double>();
}

void Ranks::wait() const {
  sum(0.0);
}

Ranks join_ranks() {
  Ranks ranks;
  // Slurm's count of the step, not of the job: the job's script itself is a single process.
  const char* count = variable("WORLD_SIZE", "SLURM_STEP_NUM_TASKS");
  if (!count) return ranks;
  ranks.count = number("WORLD_SIZE", count, 1, 4096);
  if (ranks.count == 1) return ranks;
  ranks.rank = number("RANK", variable("RANK", "SLURM_PROCID"), 0, ranks.count - 1);
  MeetingPoint meeting = slurm_meeting_point();
  if (const char* host = variable("MASTER_ADDR")) meeting = {host, 29500};
  if (meeting.host.empty()) throw std::runtime_error("MASTER_ADDR: is not set: name the machine of rank 0");
  if (const char* port = variable("MASTER_PORT")) meeting.port = number("MASTER_PORT", port, 1, 65535);
  try {
    const auto store = c10::make_intrusive<c10d::TCPStore>(
        meeting.host, c10d::TCPStoreOptions{.port = static_cast<std::uint16_t>(meeting.port),
                                            .isServer = ranks.rank == 0,
                                            .numWorkers = static_cast<std::size_t>(ranks.count),
                                            .timeout = std::chrono::minutes(5)});
    // Long, because the others wait while rank 0 decodes every image. A process that ends is noticed at once.
    auto options = c10d::ProcessGroupGloo::Options::create(std::chrono::hours(24 * 7));
    options->devices.push_back(device_towards(meeting.host));
    ranks.group_ = std::make_unique<Ranks::Group>();
    ranks.group_->gloo =
        c10::make_intrusive<c10d::ProcessGroupGloo>(store, ranks.rank, ranks.count, std::move(options));
    ranks.wait();
  } catch (const std::exception& error) {
    lost(error);
  }
  return ranks;
}

}  // namespace cps
