#include <cstdio>

#include "trainer/training/train.h"

namespace cps {
namespace {

std::string duration(double seconds) {
  char text[32];
  if (seconds < 90)
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  else if (seconds < 5400)
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
  else
    std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
  return text;
}

}  // namespace

std::string to_string(const EpochReport& r) {
  char line[256];
  std::snprintf(line, sizeof line,
                "epoch %3d/%d  loss %.4f  val loss %.4f  cosine %+.3f  H-FOV MAE %6.2f deg  lr %.1e  %.1f "
                "images/s (%2.0f %% "
                "loading)  %s left%s",
                r.epoch, r.planned_epochs, r.training_loss, r.validation_loss, r.validation_cosine,
                r.validation_hfov_mae_deg, r.learning_rate, r.images_per_second, 100 * r.loader_share,
                duration(r.seconds_left).c_str(), r.is_best ? "  *" : "");
  return line;
}

std::string TrainSummary::brief_report() const {
  char line[384];
  std::snprintf(line, sizeof line,
                "trained on %d images, validated on %d, %.2f M parameters; %zu of %d epochs in %s (images "
                "ready after %s);\n"
                "best epoch %d: val loss %.4f, cosine %+.3f, H-FOV MAE %.2f deg",
                training_images, validation_images, static_cast<double>(parameters) / 1e6, epochs.size(),
                epochs.empty() ? 0 : epochs.back().planned_epochs, duration(train_seconds).c_str(),
                duration(decode_seconds).c_str(), best.epoch, best.validation_loss, best.validation_cosine,
                best.validation_hfov_mae_deg);
  return line;
}

}  // namespace cps
