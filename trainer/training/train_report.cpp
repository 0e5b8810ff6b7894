#include <fmt/format.h>

#include "trainer/training/train.h"

namespace cps {
namespace {

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

std::string to_string(const EpochReport& r) {
  return fmt::format(
      "epoch {:3}/{}  loss {:.4f}  val loss {:.4f}  cosine {:+.3f}  H-FOV MAE {:6.2f} deg  lr {:.1e}  "
      "{:.1f} images/s ({:2.0f} % loading)  {} left{}",
      r.epoch, r.planned_epochs, r.training_loss, r.validation_loss, r.validation_cosine,
      r.validation_hfov_mae_deg, r.learning_rate, r.images_per_second, 100 * r.loader_share,
      duration(r.seconds_left), r.is_best ? "  *" : "");
}

std::string TrainSummary::brief_report() const {
  return fmt::format(
      "trained on {} images, validated on {}, {:.2f} M parameters; {} of {} epochs in {} (images ready after {});\n"
      "{}\n"
      "best epoch {}: val loss {:.4f}, cosine {:+.3f}, H-FOV MAE {:.2f} deg",
      training_images, validation_images, static_cast<double>(parameters) / 1e6, epochs.size(),
      epochs.empty() ? 0 : epochs.back().planned_epochs, duration(train_seconds), duration(decode_seconds),
      precision_line, best.epoch, best.validation_loss, best.validation_cosine, best.validation_hfov_mae_deg);
}

}  // namespace cps
