#include "scenes/drive/street_piece.h"

#include <algorithm>

namespace cps {
namespace {

/// What speaks for a piece being a street, and against it.
struct PieceScore {
  double things = 0;                      ///< sum over sample points
  std::int64_t blocked = 0, ends = 0;     ///< edges at which something rises, edges of any kind
  std::int64_t on_body = 0, samples = 0;  ///< sample points on top of a closed body, all sample points
};

/// Whether the surface is the top of a closed body that is as high as a storey: below it comes a face that
/// looks down.
bool is_on_body(const SceneRays& rays, const Eigen::Vector3f& surface) {
  constexpr double storey_m = 2.5;
  constexpr float below_m = 0.05f, looks_down = -0.7f;
  const auto hit = first_hit(rays, surface - Eigen::Vector3f(0, below_m, 0), {0, -1, 0});
  return hit && hit->distance_m > storey_m && hit->normal.y() < looks_down;
}

/// Whether something rises within a cell and a half of the surface.
bool is_blocked(const GroundLayers& layers, const SceneRays& rays, const Eigen::Vector3f& surface,
                const Eigen::Vector3f& along) {
  const auto hit = first_hit(rays, surface + Eigen::Vector3f(0, static_cast<float>(bonnet_m), 0), along);
  return hit && hit->distance_m < 1.5 * layers.cell_m;
}

void add_sample(const GroundLayers& layers, const SceneRays& rays, int surface, PieceScore& score) {
  constexpr double share_below_roof = 0.25;
  const double things = std::max(0.0, layers.around[surface].share() - few_things);
  score.things += layers.is_open[surface] != 0 ? things : share_below_roof * things;
  score.on_body += is_on_body(rays, layers.surfaces[surface]) ? 1 : 0;
  ++score.samples;
}

std::vector<PieceScore> score_pieces(const GroundLayers& layers, const SceneRays& rays) {
  std::vector<PieceScore> scores(layers.pieces);
  for (int z = 0; z < layers.nz; ++z)
    for (int x = 0; x < layers.nx; ++x) {
      const int column = z * layers.nx + x;
      for (int i = layers.first[column]; i < layers.first[column + 1]; ++i) {
        PieceScore& score = scores[layers.piece[i]];
        const auto look = [&](int next, const Eigen::Vector3f& along) {
          if (next >= 0) return;
          ++score.ends;
          score.blocked += is_blocked(layers, rays, layers.surfaces[i], along) ? 1 : 0;
        };
        look(layers.east[i], {1, 0, 0});
        look(layers.south[i], {0, 0, 1});
        if (x % sample_stride == 0 && z % sample_stride == 0) add_sample(layers, rays, i, score);
      }
    }
  return scores;
}

/// A roof is the top of a body that covers but a part of the scene; a model's base is a body, too.
bool is_roof(const GroundLayers& layers, const PieceScore& score) {
  constexpr double max_share = 0.25;
  const double share = static_cast<double>(score.samples * sample_stride * sample_stride) /
                       (static_cast<double>(layers.nx) * layers.nz);
  return 2 * score.on_body > score.samples && share < max_share;
}

}  // namespace

StreetPiece street_piece(const GroundLayers& layers, const SceneRays& rays) {
  constexpr double min_blocked = 0.05, rival = 0.1;
  const std::vector<PieceScore> scores = score_pieces(layers, rays);
  StreetPiece best;
  std::vector<double> things;  // of each piece that could be a street
  for (int piece = 0; piece < layers.pieces; ++piece) {
    const PieceScore& score = scores[piece];
    if (!(score.things > 0) || is_roof(layers, score) ||
        static_cast<double>(score.blocked) < min_blocked * static_cast<double>(score.ends))
      continue;
    things.push_back(score.things);
    if (best.piece < 0 || score.things > scores[best.piece].things) best.piece = piece;
  }
  if (best.piece < 0) return best;
  const double most = scores[best.piece].things;
  best.rivals = static_cast<int>(
      std::ranges::count_if(things, [&](double other) { return other >= rival * most; }) - 1);
  return best;
}

}  // namespace cps
