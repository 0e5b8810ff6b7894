#include "apps/render/replay.h"

#include <fmt/ostream.h>

#include <boost/program_options/errors.hpp>

#include "apps/render/text_options.h"
#include "renderer/camera_path.h"
#include "renderer/paths/hit_ids.h"

namespace cps {
namespace {

template <class Triple>
std::string text(const Triple& v) {
  return fmt::format("{:.5g} {:.5g} {:.5g}", v.x(), v.y(), v.z());
}

void print_vertex(const RenderScene& scene, const VertexRecord& vertex, std::size_t index,
                  const std::vector<std::string>& material_names, std::ostream& out) {
  const HitIds ids = ids_of(scene, vertex.hit);
  fmt::print(out, "vertex {}: {:.5g} m on, instance {}, triangle {}, material {} '{}'\n", index, vertex.hit.t,
             ids.instance, vertex.hit.triangle, ids.material, material_names[ids.material]);
  fmt::print(out, "  position    {}\n  normal      {}\n  footprint   {:.3g} m\n", text(vertex.position),
             text(vertex.normal), vertex.footprint_m);
  fmt::print(out, "  throughput  {}\n", text(vertex.throughput));
  fmt::print(out, "  gives       emission {}, sun {}, sky {}, lamps {}, cached {}\n", text(vertex.emission),
             text(vertex.sun), text(vertex.sky), text(vertex.lamps), text(vertex.cached));
}

}  // namespace

void replay(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
            const std::string& which, const std::vector<std::string>& material_names, std::ostream& out) {
  const std::vector<double> numbers = parse_numbers("replay", which, 3, "X,Y,S: pixel and sample");
  const int x = static_cast<int>(numbers[0]), y = static_cast<int>(numbers[1]),
            sample = static_cast<int>(numbers[2]);
  if (x < 0 || x >= camera.pinhole.width || y < 0 || y >= camera.pinhole.height || sample < 0 ||
      sample >= options.samples)
    throw boost::program_options::error(
        fmt::format("--replay {}: the picture has {} x {} pixels of {} samples, counted from 0", which,
                    camera.pinhole.width, camera.pinhole.height, options.samples));

  const PathSource source = make_path_source(camera, options);
  PathRecord record;
  Path paths[packet_size];
  paths[0] = camera_path(source, camera_pixel(source.rays, x, y), x, y, sample);
  paths[0].record = &record;
  if (!paths[0].alive) record.end = "the lens shows nothing there";
  fmt::print(out, "pixel {}, {}, sample {}: from {} towards {}\n", x, y, sample, text(paths[0].ray.origin),
             text(paths[0].ray.direction));
  trace_packet(scene, options, paths);
  for (std::size_t i = 0; i < record.vertices.size(); ++i)
    print_vertex(scene, record.vertices[i], i, material_names, out);
  fmt::print(out, "end: {}; from beyond {}\n", record.end, text(record.beyond));
  fmt::print(out, "radiance {} kcd/m2, {} rays\n", text(paths[0].radiance), paths[0].rays);
}

}  // namespace cps
