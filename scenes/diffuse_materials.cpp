#include "scenes/diffuse_materials.h"

namespace cps {

void make_diffuse(Scene& scene) {
  for (Material& material : scene.materials) {
    Material diffuse;
    diffuse.name = material.name;
    diffuse.base_color = material.base_color;
    diffuse.base_color_texture = material.base_color_texture;
    diffuse.emissive = material.emissive;
    diffuse.emissive_texture = material.emissive_texture;
    diffuse.alpha_mode = material.alpha_mode;
    diffuse.alpha_cutoff = material.alpha_cutoff;
    diffuse.double_sided = material.double_sided;
    diffuse.unlit = material.unlit;
    diffuse.metallic = 0;
    diffuse.specular = 0;
    material = diffuse;
  }
}

}  // namespace cps
