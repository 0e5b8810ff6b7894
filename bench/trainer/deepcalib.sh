#!/usr/bin/env bash
# Our method and DeepCalib's (Bogdan et al. 2018) on both kinds of lenses: networks that are trained for the same time on
# pictures of the same places, each on lenses of the family that it says, and measured on both families and on KITTI.
#     bench/trainer/deepcalib.sh WORK [OPTION…]
# Makes a small version of the recipe `deepcalib` in WORK/data/spherical, and the same with Brown-Conrady lenses in
# WORK/data/brown-conrady. Trains the networks in WORK/models, and writes WORK/deepcalib.md and WORK/deepcalib.json after
# each. Run it again after an interruption: what is there is left alone, and training resumes. A file eval_*.json that is
# removed is made anew.
#     --minutes M     wall time of each training on --threads threads (8); the table lists the CPU minutes and epochs
#     --views N       places at each of the recipe's 14 H-FOVs, an image of each in both datasets (80)
#     --cities N      cities of both datasets (5), each on two days
#     --size WxH      of the images (299x299); networks for KITTI should learn from its shape, such as 348x128
#     --samples N     paths per master pixel (2); a pixel of a spherical image has four times as many
#     --arch NAME     network (resnet18-32)
#     --width W       width of the network's images (128)
#     --rows LIST     only these, such as deepcalib-regression,ours
#     --kitti FOLDER  also measure on KITTI raw data, not rectified
#     --threads N     threads (all)
#     --seed N        seed of the trainings (0)
#     --cps PROGRAM   (build/release/bin/cps)
# What the datasets share: seed, cities, light, places, poses, parts, H-FOVs, sensors and number of images. Their lenses
# differ, and what hangs on them: the H-FOV is what a spherical image sees along its middle row, and the label's of a
# Brown-Conrady one, which sees some degrees more or less; Brown-Conrady lenses are drawn as in the recipe `reference`,
# with a shifted principal point; and spherical images are traced ray by ray, where others are warped from a master.
# What the networks share: everything but the last layer and the loss (the preset `reference` without image size, which is
# that of the deepcalib presets) and, in the last two rows, edge orientation, measured in the images as large as they are.
set -euo pipefail
# shellcheck source=bench/trainer/rows.sh
source "$(dirname "${BASH_SOURCE[0]}")/rows.sh"
recipe=$here/../../sampler/recipes/deepcalib.cfg

# name, data, options of cps train
rows=(
  "deepcalib-regression spherical --preset deepcalib-regression"
  "deepcalib-classification spherical --preset deepcalib-classification"
  "ours brown-conrady --preset reference --size-features false --orientation false"
  "ours-orientation brown-conrady --preset reference --size-features false"
  "ours-fit brown-conrady --preset reference --size-features false --head fit"
)
# of cps generate, beside those that both have
declare -A lenses_of=(
  [spherical]=""
  [brown-conrady]="--lens_model brown_conrady --lens_draw shape_prior --real_lenses_share 0.3"
)

case ${1:---help} in -h | --help) print_help && exit ;; esac
work=$1
shift
minutes=8 views=80 cities=5 size=299x299 samples=2 arch=resnet18-32 width=128 wanted="" kitti="" threads=$(nproc) seed=0
cps=build/release/bin/cps
while [ $# -gt 0 ]; do
  [ $# -gt 1 ] || misused "$1: needs a value"
  case $1 in
    --minutes) minutes=$2 ;; --views) views=$2 ;; --cities) cities=$2 ;; --size) size=$2 ;; --samples) samples=$2 ;;
    --arch) arch=$2 ;; --width) width=$2 ;; --rows) wanted=$2 ;; --kitti) kitti=$2 ;; --threads) threads=$2 ;;
    --seed) seed=$2 ;; --cps) cps=$2 ;; *) misused "$1: unknown; --help lists the options" ;;
  esac
  shift 2
done
names=()
for row in "${rows[@]}"; do names+=("${row%% *}"); done
require_rows "${names[@]}"

# One shaded surface along a path, as in the recipe `small`, and lenses that no two views share: cheap images of many lenses.
for data in spherical brown-conrady; do
  # The options are words without spaces.
  # shellcheck disable=SC2086
  "$cps" generate --recipe "$recipe" --out "$work/data/$data" ${lenses_of[$data]} --size "$size" --views "$views" \
    --cities "$cities" --conditions_per_scene 2 --views_per_lens 1 --samples "$samples" --max_shaded_vertices 1 \
    --threads "$threads"
done

write_table() {
  "$here/model_table.py" --rays --out "$work/deepcalib" --title "Our method and DeepCalib's, ${minutes} minutes each" \
    --set "spherical test part=eval_spherical.json" --set "Brown–Conrady test part=eval_brown-conrady.json" \
    ${kitti:+--set "KITTI=eval_kitti.json"} "${models[@]}"
}

models=()
for row in "${rows[@]}"; do
  read -r name data options <<<"$row"
  is_wanted "$name" || continue
  models+=("$work/models/$name")
  # The options are words without spaces.
  # shellcheck disable=SC2086
  train_row "$name" "$work/data/$data" $options --arch "$arch" --width "$width"
  for measured in spherical brown-conrady; do
    eval_row "$name" "eval_$measured.json" --data "$work/data/$measured"
  done
  [ -z "$kitti" ] || eval_row "$name" eval_kitti.json --kitti "$kitti"
  write_table
done
