#include "production/make_views.h"

#include <fmt/format.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include "numbers/cpu_time.h"
#include "numbers/wall_time.h"
#include "production/condition_scene.h"
#include "production/dense_labels.h"
#include "production/view_images.h"
#include "production/view_render.h"

namespace cps {
namespace {

std::string name_of(const Plan& plan, const PlannedView& view) {
  return fmt::format("{} {} {} of {}", plan.sets[view.set].folder, plan.rig.cameras[view.rig_camera].name,
                     view.index, plan.scenes[plan.conditions[view.condition].scene].file.filename().string());
}

/// A view that is rendered, and then its images are made.
struct ViewInFlight {
  ViewImages wanted;
  RenderedView rendered = {};
  std::vector<std::vector<DenseRecord>> dense = {};  ///< by image
  MadeImages made = {};
};

/// The stages of the pipeline and what they share.
class ViewLine {
 public:
  ViewLine(const Plan& plan, const std::vector<std::int64_t>& views, Journal& journal,
           const std::filesystem::path& root, int threads, const Watch& watch, const LightCacheOptions& cache)
      : plan_(plan),
        views_(views),
        journal_(journal),
        root_(root),
        threads_(threads),
        watch_(watch),
        loaded_(cache) {}

  void run() {
    using Token = std::shared_ptr<ViewInFlight>;
    const auto render = [this](tbb::flow_control& flow) -> Token {
      Token view;
      attempt([&] { view = render_next(); });
      if (!view) flow.stop();
      return view;
    };
    const auto images = [this](Token view) {
      attempt([&] {
        view->made = make_images(view->wanted, view->rendered, root_, image_times_);
        view->rendered = {};
        for (std::size_t i = 0; i < view->dense.size(); ++i)
          view->made.record.images[i].dense = std::move(view->dense[i]);
      });
      return view;
    };
    const auto enter = [this](const Token& view) {
      if (!view->made.record.images.empty()) attempt([&] { append(view->made); });
    };
    tbb::parallel_pipeline(static_cast<std::size_t>(views_in_flight(threads_)),
                           tbb::make_filter<void, Token>(tbb::filter_mode::serial_in_order, render) &
                               tbb::make_filter<Token, Token>(tbb::filter_mode::parallel, images) &
                               tbb::make_filter<Token, void>(tbb::filter_mode::serial_out_of_order, enter));
    if (error_) std::rethrow_exception(error_);
  }

  MakeViewsSummary summary() const {
    MakeViewsSummary summary = summary_;
    summary.is_interrupted = next_ < views_.size() || was_given_up_;
    summary.cpu.labels_s = 1e-9 * static_cast<double>(labels_ns_);
    summary.cpu.warp_s = 1e-9 * static_cast<double>(image_times_.warp_ns);
    summary.cpu.develop_s = 1e-9 * static_cast<double>(image_times_.develop_ns);
    summary.cpu.encode_s = 1e-9 * static_cast<double>(image_times_.encode_ns);
    summary.cpu.write_s = 1e-9 * static_cast<double>(image_times_.write_ns);
    return summary;
  }

 private:
  /// Keeps the first error and lets the views in flight be completed. An exception that TBB sees would cancel
  /// the loops inside other images, which would then be written with pixels missing.
  template <typename Work>
  void attempt(Work&& work) {
    try {
      work();
    } catch (const Interrupted&) {
    } catch (...) {
      const std::lock_guard lock(failing_);
      if (!error_) error_ = std::current_exception();
      has_failed_ = true;
    }
  }

  bool must_stop() const { return has_failed_ || watch_.is_stopped(); }

  /// Null when no view is left or the work must stop.
  std::shared_ptr<ViewInFlight> render_next() {
    if (must_stop() || next_ == views_.size()) return nullptr;
    auto in_flight =
        std::make_shared<ViewInFlight>(ViewInFlight{.wanted = images_of(plan_, views_[next_++])});
    const PlannedView& view = plan_.views[in_flight->wanted.view];
    was_given_up_ = true;  // until it is rendered
    LitScene& scene = loaded_.of(plan_, view);
    if (scenes_in_memory(threads_) > 1) prefetch_after(view);
    in_flight->rendered = render_view(plan_.recipe, view, in_flight->wanted, scene, [this](int, int) {
      if (must_stop()) throw Interrupted();
    });
    summary_.cpu.render_s += in_flight->rendered.cpu_s;
    // Now, while the scene and the car in it are this view's.
    in_flight->dense = make_dense_labels(plan_.recipe, view, in_flight->wanted, scene, root_, labels_ns_);
    was_given_up_ = false;
    return in_flight;
  }

  /// Begins to load the scene of the next condition, if there is one and it is not loading yet.
  void prefetch_after(const PlannedView& view) {
    const auto next =
        std::find_if(views_.begin() + static_cast<std::ptrdiff_t>(next_), views_.end(),
                     [&](std::int64_t v) { return plan_.views[v].condition != view.condition; });
    if (next != views_.end()) loaded_.prefetch(plan_, plan_.views[*next]);
  }

  void append(const MadeImages& made) {
    const ViewRecord& record = made.record;
    journal_.append(record);
    const auto images = static_cast<std::int64_t>(record.images.size());
    ++summary_.views;
    summary_.images += images;
    const std::string name = name_of(plan_, plan_.views[record.view]);
    summary_.badly_exposed.add(made.exposure, name);
    watch_.advanced(images, name);
  }

  const Plan& plan_;
  const std::vector<std::int64_t>& views_;
  Journal& journal_;
  const std::filesystem::path& root_;
  const int threads_;
  const Watch& watch_;

  std::size_t next_ = 0;
  bool was_given_up_ = false;
  ConditionScene loaded_;
  std::atomic<std::int64_t> labels_ns_ = 0;
  ImageTimes image_times_;
  MakeViewsSummary summary_;
  std::mutex failing_;
  std::exception_ptr error_;
  std::atomic<bool> has_failed_ = false;
};

}  // namespace

std::string MakeViewsSummary::brief() const {
  const auto share = [&](double seconds) { return cpu_s > 0 ? 100 * seconds / cpu_s : 0.0; };
  return fmt::format(
      "{} views, {} images in {:.1f} s ({:.2f} images/s); {:.1f} CPU-s: render {:.1f} %{}, warp {:.1f} %, "
      "develop {:.1f} %, encode {:.1f} %, write {:.1f} %, scenes and the rest {:.1f} %; {} threads {:.1f} % "
      "busy",
      views, images, wall_s, wall_s > 0 ? static_cast<double>(images) / wall_s : 0.0, cpu_s,
      share(cpu.render_s), cpu.labels_s > 0 ? fmt::format(", labels {:.1f} %", share(cpu.labels_s)) : "",
      share(cpu.warp_s), share(cpu.develop_s), share(cpu.encode_s), share(cpu.write_s),
      share(cpu_s - cpu.sum_s()), threads, wall_s > 0 ? 100 * cpu_s / (wall_s * threads) : 0.0);
}

int views_in_flight(int threads) {
  return 2 + threads / 8;
}

int scenes_in_memory(int threads) {
  return threads > 1 ? 2 : 1;
}

MakeViewsSummary make_views(const Plan& plan, const std::vector<std::int64_t>& views, Journal& journal,
                            const std::filesystem::path& root, int threads, const Watch& watch,
                            const LightCacheOptions& cache) {
  const auto begin = std::chrono::steady_clock::now();
  const double cpu_begin_s = cpu_s(CLOCK_PROCESS_CPUTIME_ID);
  OIIO::attribute("threads", 1);  // OpenImageIO starts none of its own: all threads are TBB's
  ViewLine line(plan, views, journal, root, threads, watch, cache);
  line.run();
  MakeViewsSummary summary = line.summary();
  summary.threads = threads;
  summary.wall_s = seconds_since(begin);
  summary.cpu_s = cpu_s(CLOCK_PROCESS_CPUTIME_ID) - cpu_begin_s;
  return summary;
}

}  // namespace cps
