#!/usr/bin/env bash
# Equal-error race with Blender's Cycles: bench/renderer/race.sh FOLDER [CPS]
# A procedural city, Lambert materials, masked leaves, textures, sun and constant sky, one thread each, renders of both
# interleaved in one run. Prints the samples and CPU seconds with which cps reaches the RMSE of Cycles' 64 samples, each
# against its own converged picture (their texture filters differ), and how far the converged pictures are apart.
# Needs Debian's blender, python3-numpy and openimageio-tools; FOLDER keeps the pictures. SIZE, SAMPLES and REFERENCE
# (samples of the converged pictures) can be set, and OPTIONS for Cycles' script alone (--nearest, --no-textures).
set -euo pipefail
out=$1 cps=${2:-build/release/bin/cps}
SIZE=${SIZE:-348x128} SAMPLES=${SAMPLES:-64} REFERENCE=${REFERENCE:-2048}
mkdir -p "$out"
script=$(dirname "$0")/cycles.py

[ -e "$out/city.glb" ] || $cps city --seed 7 --extent-m 300 -o "$out/city.glb"
view=(--size "$SIZE" --hfov 70 --position=172,1.65,-4.9 --look-at=69.7,1.65,-183.2) # along a street of that city

cycles() { # NAME SAMPLES [OPTIONS]
  blender -b --factory-startup -P "$script" -- "$out/city.glb" "$out/$1.exr" "${view[@]}" --samples "$2" ${OPTIONS:-} "${@:3}" 2>&1 |
    grep '^cycles:'
}
ours() { # NAME SAMPLES [OPTIONS]
  $cps render "$out/city.glb" "${view[@]}" --materials diffuse --sky 1 --sun-irradiance 3 \
    --threads 1 --samples "$2" -o "$out/$1.exr" "${@:3}"
}

echo "# references"
[ -e "$out/cycles_reference.exr" ] || cycles cycles_reference "$REFERENCE" --seed 1
[ -e "$out/cps_reference.exr" ] || ours cps_reference "$REFERENCE" --seed 1
echo "# Cycles, and its error"
cycles cycles "$SAMPLES"
idiff -warn 1e-9 -fail 1e9 "$out/cycles_reference.exr" "$out/cycles.exr" | grep RMS
echo "# cps, and its error"
ours cps "$SAMPLES" --reference "$out/cps_reference.exr"
echo "# converged pictures against each other"
idiff -warn 1e-9 -fail 1e9 -o "$out/difference.exr" -abs -scale 4 "$out/cycles_reference.exr" "$out/cps_reference.exr" | grep -E "Mean|RMS" || true
