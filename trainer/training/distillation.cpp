#include "trainer/training/distillation.h"

#include <algorithm>
#include <stdexcept>

#include "trainer/model/predictor.h"
#include "trainer/training/losses.h"

namespace cps {

std::unique_ptr<const Predictor> load_teacher(const TrainOptions& student, Device device) {
  if (student.teacher.empty()) return nullptr;
  auto teacher = std::make_unique<const Predictor>(student.teacher, device);
  const TrainOptions& its = teacher->card().options;
  if (is_deepcalib(its.head))
    throw std::runtime_error("teacher " + student.teacher + ": its head is " + to_string(its.head) +
                             ", so it has learned lenses of another family: choose another teacher");
  if (its.reduction != student.reduction)
    throw std::runtime_error("teacher " + student.teacher +
                             ": takes images of another size: train with its width and reduce");
  if (its.orientation.measured && its.orientation != student.orientation)
    throw std::runtime_error(
        "teacher " + student.teacher +
        ": takes the orientation of edges: train with its orientation and orientation-width");
  for (const std::string& name : student.outputs)
    if (std::ranges::find(its.outputs, name) == its.outputs.end())
      throw std::runtime_error("teacher " + student.teacher + ": has not learned " + name +
                               ": leave it out of outputs or choose another teacher");
  return teacher;
}

torch::Tensor distillation_loss(const torch::Tensor& predicted, const Predictor& teacher,
                                std::span<const BatchImage> images, const ModelCard& student) {
  torch::Tensor wanted = torch::empty({static_cast<long>(images.size()), output_count});
  float* out = wanted.data_ptr<float>();
  const std::vector<Outputs> answers = teacher(images);
  for (std::size_t i = 0; i < images.size(); ++i) {
    const ImageSize size = images[i].original;
    const Outputs answer = convert(answers[i], teacher.card().options.target_space,
                                   student.options.target_space, size.width, size.height);
    for (double v : standardise(answer, student.targets)) *out++ = static_cast<float>(v);
  }
  return output_loss(Loss::mse, predicted.narrow(1, 0, output_count), wanted, output_mask(student.options));
}

}  // namespace cps
