#!/usr/bin/env bash
# Equal-error race with Blender's Cycles: bench/renderer/race.sh FOLDER [CPS]
# A procedural city, Lambert materials, masked leaves, textures, sun and constant sky, one thread each, renders of both
# in turns in one run. Prints for each the samples, CPU seconds and RMSE: the RMS difference between pictures of two
# seeds over √2, so that neither needs a converged picture and their different texture filters play no part. Set
# REFERENCE to a number of samples to see as well how far the converged pictures are apart.
# Needs Debian's blender, python3-numpy and openimageio-tools; FOLDER keeps the pictures. SIZE, SAMPLES (of Cycles), OURS
# and SEEDS can be set, and OPTIONS for Cycles' script alone (--nearest, --no-textures).
set -euo pipefail
out=$1 cps=${2:-build/release/bin/cps}
SIZE=${SIZE:-348x128} SAMPLES=${SAMPLES:-64} OURS=${OURS:-32 48 64} SEEDS=${SEEDS:-1 2}
mkdir -p "$out"
script=$(dirname "$0")/cycles.py

[ -e "$out/city.glb" ] || $cps city --seed 7 --extent-m 300 -o "$out/city.glb"
read -r position look_at < <(python3 "$(dirname "$0")/first_lane.py" "$out/city.glb")
view=(--size "$SIZE" --hfov 70 "--position=$position" "--look-at=$look_at")

cycles() { # NAME SAMPLES SEED
  blender -b --factory-startup -P "$script" -- "$out/city.glb" "$out/full.exr" "${view[@]}" --samples "$2" --seed "$3" \
    ${OPTIONS:-} 2>&1 | grep '^cycles:'
  oiiotool "$out/full.exr" --ch R,G,B -o "$out/$1.exr" # without alpha, which would dilute the error
}
ours() { # NAME SAMPLES SEED
  $cps render "$out/city.glb" "${view[@]}" --materials diffuse --sky 1 --sun-irradiance 3 \
    --threads 1 --samples "$2" --seed "$3" -o "$out/$1.exr"
}
rms() { # PICTURE PICTURE
  idiff -fail 0 "$out/$1.exr" "$out/$2.exr" | awk '/RMS/ {print $4}' || true
}

for seed in $SEEDS; do
  cycles "cycles_$seed" "$SAMPLES" "$seed"
  for samples in $OURS; do ours "cps${samples}_$seed" "$samples" "$seed"; done
done
read -r first second _ <<< "$SEEDS"
for name in cycles $(printf 'cps%s ' $OURS); do
  awk -v d="$(rms "${name}_$first" "${name}_$second")" -v n="$name" 'BEGIN {printf "%s: RMSE %.5f\n", n, d / sqrt(2)}'
done
if [ -n "${REFERENCE:-}" ]; then
  cycles cycles_reference "$REFERENCE" 1
  ours cps_reference "$REFERENCE" 1
  echo "converged pictures differ by (mean, RMS):"
  idiff -fail 0 -o "$out/difference.exr" -abs -scale 4 "$out/cycles_reference.exr" "$out/cps_reference.exr" |
    grep -E "Mean|RMS" || true
fi
