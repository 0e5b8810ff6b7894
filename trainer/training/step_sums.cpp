#include "trainer/training/step_sums.h"

#include <torch/utils.h>

namespace cps {

StepSums::StepSums(Network& network) : parameters_(network.parameters()) {
  for (const torch::Tensor& buffer : network.buffers())
    (buffer.is_floating_point() ? buffers_ : counts_).push_back(buffer);
  std::int64_t length = 2;
  for (const auto* list : {&parameters_, &buffers_})
    for (const torch::Tensor& t : *list) length += t.numel();
  row_ = torch::zeros({length}, network.device());
  for (const torch::Tensor& buffer : buffers_) before_.push_back(buffer.clone());
  for (const torch::Tensor& count : counts_) after_.push_back(count + 1);
}

void StepSums::begin_batch() {
  const torch::NoGradGuard no_gradients;
  for (std::size_t i = 0; i < buffers_.size(); ++i) buffers_[i].copy_(before_[i]);
}

void StepSums::add_batch(double loss_of_images) {
  const torch::NoGradGuard no_gradients;
  std::int64_t at = 0;
  const auto add = [&](const torch::Tensor& t) {
    row_.narrow(0, at, t.numel()).add_(t.flatten());
    at += t.numel();
  };
  for (const torch::Tensor& p : parameters_) add(p.grad());
  for (const torch::Tensor& b : buffers_) add(b);
  row_[at] += loss_of_images;
  row_[at + 1] += 1;
}

double StepSums::finish(const Ranks& ranks) {
  const torch::NoGradGuard no_gradients;
  ranks.sum(row_);
  const std::int64_t numbers = row_.numel() - 2;
  const double batches = row_[numbers + 1].item<double>();
  row_.narrow(0, 0, numbers).div_(batches);
  std::int64_t at = 0;
  const auto take = [&](const torch::Tensor& like) {
    at += like.numel();
    return row_.narrow(0, at - like.numel(), like.numel()).view_as(like);
  };
  for (torch::Tensor& p : parameters_) p.mutable_grad() = take(p).clone();
  for (torch::Tensor& b : buffers_) b.copy_(take(b));
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i].copy_(after_[i]);  // counts steps, not batches
  return row_[numbers].item<double>();
}

}  // namespace cps
