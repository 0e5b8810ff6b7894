#!/usr/bin/env bash
# What single choices are worth: networks that differ from a base in one thing, trained for the same time with the same seed.
#     bench/trainer/ablation.sh WORK --data DATASET [--data DATASET_WITH_HALF_THE_NOISE] [OPTION…] [-- TRAIN_OPTION…]
# The base is the preset `reference` on the first dataset: orientation, the direct head, resnet18-32, 174 pixels of width, all
# places. Each other row changes one of these, or the sensor noise of the training images, and all are measured on the test
# part of the first dataset. Networks are in WORK/models, the table in WORK/ablation.md and WORK/ablation.json, written after
# each row. Run it again after an interruption: what is there is left alone, and training resumes.
#     --data FOLDER     a dataset with images of at least 696 pixels (narrower ones are never enlarged)
#     --data FOLDER     a second one of the same recipe and seed with half the noise; without it there is no row noise-half
#     --minutes M       wall time of each training on --threads threads (30); the table lists the CPU minutes and epochs
#     --rows LIST       only these, such as base,width-348
#     --kitti FOLDER    also measure on KITTI raw data, not rectified
#     --threads N       threads (all)
#     --seed N          seed of the trainings (0)
#     --cps PROGRAM     (build/release/bin/cps)
#     -- TRAIN_OPTION…  further options of cps train for all rows, such as --online-lenses true; none that a row sets
# Half the noise at the same light, with `--key value` of cps generate, from a recipe that leaves these keys at their defaults:
# four times the electrons, and twice the electrons of read noise, which is half as much of a white pixel:
#     --full_well_min_e 8000 --full_well_max_e 48000 --read_noise_min_e 4 --read_noise_max_e 16
# That is the sensor's noise; four times the recipe's `samples` halves that of the renders, too.
# A row that sees fewer images in its time (wide images, wide networks) is compared at equal cost, not at equal images. Give
# enough minutes for several epochs of the slowest row.
set -euo pipefail
# shellcheck source=bench/trainer/rows.sh
source "$(dirname "${BASH_SOURCE[0]}")/rows.sh"

# name, options of cps train
rows=(
  "base"
  "no-orientation --orientation false"
  "width-348 --width 348"
  "width-696 --width 696"
  "noise-half"
  "resnet18-16 --arch resnet18-16"
  "resnet18 --arch resnet18"
  "places-half --places-share .5"
  "places-quarter --places-share .25"
  "head-fit --head fit"
)

case ${1:---help} in -h | --help) print_help && exit ;; esac
work=$1
shift
minutes=30 wanted="" kitti="" threads=$(nproc) seed=0 cps=build/release/bin/cps datasets=()
while [ $# -gt 0 ]; do
  if [ "$1" = -- ]; then
    further=("${@:2}")
    break
  fi
  [ $# -gt 1 ] || misused "$1: needs a value"
  case $1 in
    --data) datasets+=("$2") ;; --minutes) minutes=$2 ;; --rows) wanted=$2 ;; --kitti) kitti=$2 ;;
    --threads) threads=$2 ;; --seed) seed=$2 ;; --cps) cps=$2 ;; *) misused "$1: unknown; --help lists the options" ;;
  esac
  shift 2
done
[ ${#datasets[@]} -gt 0 ] || misused "--data: name a dataset"
[ ${#datasets[@]} -le 2 ] || misused "--data: at most two: the dataset, and one with half the noise"
names=()
for row in "${rows[@]}"; do names+=("${row%% *}"); done
require_rows "${names[@]}"
data=${datasets[0]} half_noise=${datasets[1]:-}
recipe_but_noise() { # DATASET: what its images are drawn from
  sed -n '/"recipe"/,/}/p' "$1/dataset.json" | grep -vE '"(name|samples|(full_well|read_noise)_m(in|ax)_e)"'
}
# Otherwise it might train on streets of the other's test part.
[ -z "$half_noise" ] || cmp -s <(recipe_but_noise "$data") <(recipe_but_noise "$half_noise") ||
  misused "--data $half_noise: its recipe differs from that of $data in more than noise: see dataset.json in both"
narrowest=$(narrowest_image "$data")
[ "${narrowest:-696}" -ge 696 ] || echo "$data: has images of $narrowest pixels: rows of a larger width see no more than those"

write_table() {
  "$here/model_table.py" --out "$work/ablation" --title "Single choices, ${minutes} minutes each" \
    --set "test part=eval.json" ${kitti:+--set "KITTI=eval_kitti.json"} "${models[@]}"
}

models=()
for row in "${rows[@]}"; do
  read -r name options <<<"$row"
  is_wanted "$name" || continue
  trained_on=$data
  if [ "$name" = noise-half ]; then
    [ -n "$half_noise" ] || continue
    trained_on=$half_noise
  fi
  models+=("$work/models/$name")
  # The options are words without spaces.
  # shellcheck disable=SC2086
  train_row "$name" "$trained_on" --preset reference $options
  eval_row "$name" eval.json --data "$data" --robustness
  [ -z "$kitti" ] || eval_row "$name" eval_kitti.json --kitti "$kitti"
  write_table
done
