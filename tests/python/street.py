"""A street for `cps generate`, as glTF: ground, boxes, and the lanes of six parallel streets."""

import json
import struct


def write_street(folder):
    ground = [(-200, 0, -200), (200, 0, -200), (200, 0, 200), (-200, 0, 200)]
    box = [(x - 0.5, y, z - 0.5) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    corners = b"".join(struct.pack("<3f", *corner) for corner in ground + box)
    triangles = [0, 2, 1, 0, 3, 2]
    triangles += [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 2, 6, 7, 2, 7, 3]
    indices = struct.pack(f"<{len(triangles)}I", *triangles)
    (folder / "street.bin").write_bytes(corners + indices)

    nodes, lanes = [{"mesh": 0}], []
    for s in range(6):
        z = -60 + 24 * s
        for b in range(12):
            height = 5 + (b * 7 + s) % 9
            nodes.append({"mesh": 1, "translation": [-170 + 30 * b, 0, z + 12], "scale": [14, height, 9]})
        lanes.append({"street": f"s{s}", "width_m": 3.5, "points": [[-150, 0, z], [150, 0, z]]})

    def accessor(view, offset, component, count, kind, **bounds):
        place = {"bufferView": view, "byteOffset": offset, "componentType": component}
        return {**place, "count": count, "type": kind, **bounds}

    scene = {
        "asset": {"version": "2.0", "copyright": "made by a test"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes))), "extras": {"cps_lanes": lanes}}],
        "nodes": nodes,
        "meshes": [
            {"primitives": [{"attributes": {"POSITION": 0}, "indices": 2, "material": 0}]},
            {"primitives": [{"attributes": {"POSITION": 1}, "indices": 3, "material": 1}]},
        ],
        "materials": [
            {"pbrMetallicRoughness": {"baseColorFactor": [gray, gray, gray, 1], "metallicFactor": 0}}
            for gray in (0.3, 0.6)
        ],
        "buffers": [{"uri": "street.bin", "byteLength": len(corners + indices)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(corners)},
            {"buffer": 0, "byteOffset": len(corners), "byteLength": len(indices)},
        ],
        "accessors": [
            accessor(0, 0, 5126, 4, "VEC3", min=[-200, 0, -200], max=[200, 0, 200]),
            accessor(0, 48, 5126, 8, "VEC3", min=[-0.5, 0, -0.5], max=[0.5, 1, 0.5]),
            accessor(1, 0, 5125, 6, "SCALAR"),
            accessor(1, 24, 5125, 30, "SCALAR"),
        ],
    }
    file = folder / "street.gltf"
    file.write_text(json.dumps(scene))
    return file
