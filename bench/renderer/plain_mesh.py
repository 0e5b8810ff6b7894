"""Writes a glTF scene's triangles, in world coordinates and of one grey material, as OBJ and as .glb.

    python3 bench/renderer/plain_mesh.py SCENE.glb OUT.obj OUT.glb

What programs that read no glTF can be compared on. Reads what `cps city` writes: indexed triangles, instances by
EXT_mesh_gpu_instancing.
"""
import array
import json
import pathlib
import struct
import sys

FORMATS = {5121: "B", 5123: "H", 5122: "h", 5125: "I", 5126: "f"}
SCALES = {5121: 255, 5123: 65535, 5122: 32767}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
IDENTITY = [[float(r == c) for c in range(4)] for r in range(4)]


def read_accessor(gltf, data, index):
    accessor = gltf["accessors"][index]
    view = gltf["bufferViews"][accessor["bufferView"]]
    kind, width = accessor["componentType"], WIDTHS[accessor["type"]]
    entry = struct.Struct(f"<{width}{FORMATS[kind]}")
    stride = view.get("byteStride", entry.size)
    begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    values = (entry.unpack_from(data, begin + i * stride) for i in range(accessor["count"]))
    scale = SCALES[kind] if accessor.get("normalized") else 1
    return [tuple(v / scale for v in value) if scale != 1 else value for value in values]


def transform(node):
    if "matrix" in node:
        return [[node["matrix"][4 * c + r] for c in range(4)] for r in range(4)]
    t, s = node.get("translation", (0, 0, 0)), node.get("scale", (1, 1, 1))
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    turn = ((1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
            (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
            (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)))
    return [[turn[r][c] * s[c] for c in range(3)] + [t[r]] for r in range(3)] + [[0, 0, 0, 1]]


def times(a, b):
    return [[sum(a[r][k] * b[k][c] for k in range(4)) for c in range(4)] for r in range(4)]


def instances(gltf, data, node):
    names = node.get("extensions", {}).get("EXT_mesh_gpu_instancing", {}).get("attributes")
    if not names:
        return [IDENTITY]
    columns = {name.lower(): read_accessor(gltf, data, i) for name, i in names.items() if not name.startswith("_")}
    return [transform(dict(zip(columns, row))) for row in zip(*columns.values())]


def collect(gltf, data):
    positions, corners = array.array("f"), array.array("I")

    def visit(index, parent):
        node = gltf["nodes"][index]
        world = times(parent, transform(node))
        for each in instances(gltf, data, node) if "mesh" in node else ():
            (a, b, c, d), (e, f, g, h), (i, j, k, l) = times(world, each)[:3]
            for primitive in gltf["meshes"][node["mesh"]]["primitives"]:
                first = len(positions) // 3
                for x, y, z in read_accessor(gltf, data, primitive["attributes"]["POSITION"]):
                    positions.extend((a * x + b * y + c * z + d, e * x + f * y + g * z + h, i * x + j * y + k * z + l))
                corners.extend(first + corner for corner, in read_accessor(gltf, data, primitive["indices"]))
        for child in node.get("children", ()):
            visit(child, world)

    for root in gltf["scenes"][0]["nodes"]:
        visit(root, IDENTITY)
    return positions, corners


def write_obj(file, positions, corners):
    material = file.with_suffix(".mtl")
    material.write_text("newmtl grey\nKd 0.5 0.5 0.5\nillum 2\n")
    with open(file, "w") as out:
        out.write(f"mtllib {material.name}\nusemtl grey\n")
        for i in range(0, len(positions), 3):
            out.write("v %.5f %.5f %.5f\n" % tuple(positions[i:i + 3]))
        for i in range(0, len(corners), 3):
            out.write("f %d %d %d\n" % tuple(corner + 1 for corner in corners[i:i + 3]))


def write_glb(file, positions, corners):
    parts = positions.tobytes(), corners.tobytes()
    size = sum(map(len, parts))
    gltf = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "materials": [{"doubleSided": True,
                       "pbrMetallicRoughness": {"baseColorFactor": [.5, .5, .5, 1], "metallicFactor": 0}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "buffers": [{"byteLength": size}],
        "bufferViews": [{"buffer": 0, "byteLength": len(parts[0])},
                        {"buffer": 0, "byteOffset": len(parts[0]), "byteLength": len(parts[1])}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(positions) // 3, "type": "VEC3",
                       "min": [min(positions[i::3]) for i in range(3)],
                       "max": [max(positions[i::3]) for i in range(3)]},
                      {"bufferView": 1, "componentType": 5125, "count": len(corners), "type": "SCALAR"}]}
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    with open(file, "wb") as out:
        out.write(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + size, len(text), 0x4E4F534A) + text)
        out.write(struct.pack("<II", size, 0x004E4942) + b"".join(parts))


def main():
    scene, obj, glb = map(pathlib.Path, sys.argv[1:])
    content = scene.read_bytes()
    length, = struct.unpack_from("<I", content, 12)
    positions, corners = collect(json.loads(content[20:20 + length]), content[28 + length:])
    write_obj(obj, positions, corners)
    write_glb(glb, positions, corners)
    print(f"{len(corners) // 3} triangles")


main()
