#pragma once

#include <torch/types.h>

#include <memory>
#include <span>

#include "trainer/images/batches.h"
#include "trainer/model/model_card.h"
#include "trainer/network/device.h"

namespace cps {

class Predictor;

/// Loads the trained network from the folder student.teacher; null if that is empty. Throws
/// std::runtime_error with one line if the folder holds no model, or one with a DeepCalib head, or one that takes
/// images of another size, or orientation that the student does not take, or that has not learned all outputs
/// that the student learns.
std::unique_ptr<const Predictor> load_teacher(const TrainOptions& student, Device device = Device::cpu);

/// Mean squared difference between the student's predictions ([n, 8], standardised) and the teacher's for the
/// same images, over the outputs that the student learns (Hinton, Vinyals, Dean 2015, for numbers instead of
/// classes).
torch::Tensor distillation_loss(const torch::Tensor& predicted, const Predictor& teacher,
                                std::span<const BatchImage> images, const ModelCard& student);

}  // namespace cps
