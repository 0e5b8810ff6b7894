"""A driver's eye on the first lane of a glTF city, and a point ahead of it: X,Y,Z X,Y,Z in the scene's frame."""
import json
import struct
import sys

EYE_HEIGHT_M = 1.65

with open(sys.argv[1], "rb") as file:
    length, = struct.unpack_from("<I", file.read(20), 12)
    lane = json.loads(file.read(length))["scenes"][0]["extras"]["cps_lanes"][0]
print(*(f"{x:.3f},{y + EYE_HEIGHT_M:.3f},{z:.3f}" for x, y, z in lane["points"][:2]))
