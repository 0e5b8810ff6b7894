"""Renders a glTF scene with Blender's Cycles the way `cps render --materials diffuse` does, for comparison.

    blender -b --factory-startup -P bench/renderer/cycles.py -- SCENE.glb OUT.exr [--key value ...]

Base colours become Lambert surfaces, alpha masks are cut at their cutoffs, light is a sun disc and a constant sky.
Prints the CPU seconds of the render alone, loading and BVH apart (persistent data: the first, tiny render pays
for them). Written for Blender 3.4, whose glTF importer needs numpy.bool.
"""
import argparse
import math
import resource
import sys

import numpy

numpy.bool = bool  # removed from NumPy 1.24; the importer still asks for it
import bpy
from mathutils import Matrix, Vector


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("scene")
    parser.add_argument("output")
    parser.add_argument("--size", default="696x256")
    parser.add_argument("--hfov", type=float, default=70)
    parser.add_argument("--position", default="0,1.65,0")
    parser.add_argument("--look-at", default="1,1.65,0")
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--max_shaded_vertices", type=int, default=5, help="as for cps render")
    parser.add_argument("--sun-elevation", type=float, default=40)
    parser.add_argument("--sun-azimuth", type=float, default=135)
    parser.add_argument("--sun-irradiance", type=float, default=3)
    parser.add_argument("--sky", type=float, default=1)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--no-textures", action="store_true")
    parser.add_argument("--nearest", action="store_true", help="texels are not interpolated")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1:])


def vector(text):
    """glTF's y up to Blender's z up."""
    x, y, z = (float(part) for part in text.split(","))
    return Vector((x, -z, y))


def make_lambert(material, args):
    """Keeps of the importer's graph the base colour, the vertex colour it may carry, and the alpha cutoff."""
    tree = material.node_tree
    principled = next((n for n in tree.nodes if n.type == "BSDF_PRINCIPLED"), None)
    output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL" and n.is_active_output)
    if principled is None:
        return
    diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
    color = principled.inputs["Base Color"]
    diffuse.inputs["Color"].default_value = color.default_value
    if color.links and not args.no_textures:
        tree.links.new(color.links[0].from_socket, diffuse.inputs["Color"])
    elif color.links:
        diffuse.inputs["Color"].default_value = (0.5, 0.5, 0.5, 1)
    surface = diffuse.outputs["BSDF"]
    alpha = principled.inputs["Alpha"]
    if material.blend_method in ("CLIP", "HASHED") and alpha.links:
        # The importer leaves the cutoff to Eevee's setting: cut by a node of its own.
        test = tree.nodes.new("ShaderNodeMath")
        test.operation = "LESS_THAN"
        tree.links.new(alpha.links[0].from_socket, test.inputs[0])
        test.inputs[1].default_value = material.alpha_threshold
        surface = through(tree, test.outputs["Value"], surface)
    if material.use_backface_culling:
        # cps hides single-sided backs from the camera only.
        geometry = tree.nodes.new("ShaderNodeNewGeometry")
        path = tree.nodes.new("ShaderNodeLightPath")
        both = tree.nodes.new("ShaderNodeMath")
        both.operation = "MULTIPLY"
        tree.links.new(geometry.outputs["Backfacing"], both.inputs[0])
        tree.links.new(path.outputs["Is Camera Ray"], both.inputs[1])
        surface = through(tree, both.outputs["Value"], surface)
    tree.links.new(surface, output.inputs["Surface"])
    if args.nearest:
        for node in tree.nodes:
            if node.type == "TEX_IMAGE":
                node.interpolation = "Closest"


def through(tree, share, surface):
    """The surface with so much of it transparent."""
    transparent = tree.nodes.new("ShaderNodeBsdfTransparent")
    mix = tree.nodes.new("ShaderNodeMixShader")
    tree.links.new(share, mix.inputs["Fac"])
    tree.links.new(surface, mix.inputs[1])
    tree.links.new(transparent.outputs["BSDF"], mix.inputs[2])
    return mix.outputs["Shader"]


def add_light(scene, args):
    elevation, azimuth = math.radians(args.sun_elevation), math.radians(args.sun_azimuth)
    to_sun = Vector((math.cos(elevation) * math.sin(azimuth), math.cos(elevation) * math.cos(azimuth),
                     math.sin(elevation)))
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy = args.sun_irradiance
    sun.angle = math.radians(0.53)
    sun.use_shadow = True
    lamp = bpy.data.objects.new("sun", sun)
    lamp.rotation_mode = "QUATERNION"
    lamp.rotation_quaternion = to_sun.to_track_quat("Z", "Y")
    scene.collection.objects.link(lamp)
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (args.sky, args.sky, args.sky, 1)
    background.inputs["Strength"].default_value = 1
    scene.world = world


def add_camera(scene, args):
    position, at = vector(args.position), vector(args.look_at)
    forward = (at - position).normalized()
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "HORIZONTAL"
    camera.angle = math.radians(args.hfov)
    camera.clip_start, camera.clip_end = 1e-3, 1e5
    placed = bpy.data.objects.new("camera", camera)
    placed.matrix_world = Matrix.Translation(position) @ forward.to_track_quat("-Z", "Y").to_matrix().to_4x4()
    scene.collection.objects.link(placed)
    scene.camera = placed


def set_up(scene, args):
    scene.render.engine = "CYCLES"
    scene.render.use_persistent_data = True
    width, height = (int(part) for part in args.size.split("x"))
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    scene.render.threads_mode, scene.render.threads = "FIXED", args.threads
    scene.render.filter_size = 1
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_denoising = False
    cycles.use_adaptive_sampling = False
    cycles.pixel_filter_type = "BOX"
    cycles.seed = args.seed
    # "4" shades five vertices, and the ray that leaves the fifth may still see the sky.
    cycles.max_bounces = cycles.diffuse_bounces = args.max_shaded_vertices - 1
    cycles.transparent_max_bounces = 64
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True


def render(scene, samples, output):
    """CPU seconds of all threads."""
    scene.cycles.samples = samples
    scene.render.filepath = output
    before = resource.getrusage(resource.RUSAGE_SELF)
    bpy.ops.render.render(write_still=True)
    after = resource.getrusage(resource.RUSAGE_SELF)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    args = arguments()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=args.scene)
    for material in bpy.data.materials:
        if material.use_nodes:
            make_lambert(material, args)
    scene = bpy.context.scene
    add_light(scene, args)
    add_camera(scene, args)
    set_up(scene, args)
    loading = render(scene, 1, args.output)
    rendering = render(scene, args.samples, args.output)
    print(f"cycles: {args.samples} samples, {rendering:.2f} CPU-s, loading and one sample {loading:.2f} CPU-s")


main()
