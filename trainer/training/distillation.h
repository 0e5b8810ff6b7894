#pragma once

#include <torch/types.h>

#include <memory>
#include <span>

#include "trainer/images/batches.h"
#include "trainer/model/model_card.h"
#include "trainer/network/device.h"

namespace cps {

class Predictor;

/// The trained network in the folder that student.teacher names; null when none is named. Throws
/// std::runtime_error with one line when the folder holds no model, or one that sees images of another size
/// or has not learned all that the student is to learn.
std::unique_ptr<const Predictor> load_teacher(const TrainOptions& student, Device device = Device::cpu);

/// Mean squared difference between what the student says, [n, 8] standardised, and what the teacher says of
/// the same images, over the outputs that the student learns (Hinton, Vinyals, Dean 2015, for numbers rather
/// than classes).
torch::Tensor distillation_loss(const torch::Tensor& said, const Predictor& teacher,
                                std::span<const BatchImage> images, const ModelCard& student);

}  // namespace cps
