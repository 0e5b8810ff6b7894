#!/usr/bin/env bash
# Rays a second beside Embree's own path tracer: bench/renderer/embree_tutorial.sh FOLDER [CPS]
# The triangles of a procedural city in grey, one thread each, in turns. The tutorial lights them by a constant sky
# with a shadow ray at each surface, cps by a sun and a constant sky. Needs Debian's embree-tools.
set -euo pipefail
out=$1 cps=${2:-build/release/bin/cps}
mkdir -p "$out"
[ -e "$out/city.glb" ] || $cps city --seed 7 --extent-m 300 -o "$out/city.glb"
[ -e "$out/grey.glb" ] || python3 "$(dirname "$0")/plain_mesh.py" "$out/city.glb" "$out/grey.obj" "$out/grey.glb"
read -r position look_at < <(python3 "$(dirname "$0")/first_lane.py" "$out/city.glb")

for _ in 1 2 3; do
  pathtracer -i "$out/grey.obj" --size 348 128 --spp 16 --max-path-length 5 --ambientlight 1 1 1 --threads 1 --isa avx2 \
    --vp ${position//,/ } --vi ${look_at//,/ } --vu 0 1 0 --fov 28.9 --legacy --benchmark 2 8 |
    awk '/MRAYPS_AVG / {printf "embree: %.2f M rays/s\n", $2}'
  $cps render "$out/grey.glb" --size 348x128 --hfov 70 "--position=$position" "--look-at=$look_at" \
    --materials diffuse --sky 1 --sun-irradiance 3 --threads 1 --samples 64 -o "$out/grey.exr" |
    sed -E 's/.* at ([0-9]+) ns, ([0-9.]+) rays.*/\1 \2/' | awk '{printf "cps: %.2f M rays/s\n", 1e3 * $2 / $1}'
done
