#!/usr/bin/env bash
# The thesis' ladder, small: its seven presets, each trained for the same time, measured and put into one table.
#     bench/trainer/ladder.sh WORK [OPTION…]
# Makes small versions of the recipes cps-v1, cps-v2 and cps-v3 in WORK/data, trains the presets cps-v0.1 … cps-v0.7 on the
# data that docs/models.md names for each, then v0.7 with edge orientation and with a fitted head, in WORK/models, and writes
# WORK/ladder.md and WORK/ladder.json after each. Run it again after an interruption: what is there is left alone, and
# training resumes. A file eval*.json that is removed is made anew.
#     --minutes M     wall time of each training on --threads threads (20); the table lists the CPU minutes and epochs
#     --views A,B,C   views of cps-v1, cps-v2, cps-v3 at each H-FOV (160,40,40); of 1392x512 half as many, as published
#     --cities N      cities of each dataset (10), each on two days
#     --divide N      image sides are those of the recipes divided by N (8)
#     --arch NAME     network (resnet18-16)
#     --width W       width of the network's images (174)
#     --rows LIST     only these, such as v0.1,v0.7
#     --kitti FOLDER  also measure on KITTI raw data, not rectified
#     --threads N     threads (all)
#     --seed N        seed of the trainings (0)
#     --cps PROGRAM   (build/release/bin/cps)
# What differs from the shipped recipes: sizes, numbers of views, cities and days, and that no two views share their lenses (so
# cps-v2 and cps-v3 have 200 for each size and H-FOV instead of 250). Priors of lenses, places, light and sensor are theirs.
# What the table compares. The networks learn different outputs on different data, and a loss is a mean over the outputs of
# one network in units of its training set. So no losses are compared down a column; those under corruption are compared
# along a row. Down a column one compares the errors of the H-FOV (the same in both target spaces), of k1 in raw and in
# apparent space, and the reprojection, best on the test part of cps-v3, which is the same for all. Outputs that a network
# does not learn stay at its training mean and count as they are.
# --width, and not the presets' --reduce, makes KITTI's pictures as large for the network as those it was trained on. The
# size features of v0.7 still say that they are larger, unless --divide is 1.
# Orientation is measured at the images' own size, and little is left of a lens in 174 pixels: give --divide 2 for those rows.
set -euo pipefail
# shellcheck source=bench/trainer/rows.sh
source "$(dirname "${BASH_SOURCE[0]}")/rows.sh"
recipes=$here/../../sampler/recipes

# name, data, options of cps train
rows=(
  "v0.1 cps-v1 --preset cps-v0.1"
  "v0.2 cps-v2 --preset cps-v0.2"
  "v0.3 cps-v2 --preset cps-v0.3"
  "v0.4 cps-v2 --preset cps-v0.4"
  "v0.5 cps-v2 --preset cps-v0.5"
  "v0.6 cps-v3 --preset cps-v0.6"
  "v0.7 cps-v3 --preset cps-v0.7"
  "v0.7-orientation cps-v3 --preset cps-v0.7 --orientation true"
  "v0.7-orientation-fit cps-v3 --preset cps-v0.7 --orientation true --head fit"
)

case ${1:---help} in -h | --help) print_help && exit ;; esac
work=$1
shift
minutes=20 views=160,40,40 cities=10 divide=8 arch=resnet18-16 width=174 wanted="" kitti="" threads=$(nproc) seed=0
cps=build/release/bin/cps
while [ $# -gt 0 ]; do
  [ $# -gt 1 ] || misused "$1: needs a value"
  case $1 in
    --minutes) minutes=$2 ;; --views) views=$2 ;; --cities) cities=$2 ;; --divide) divide=$2 ;; --arch) arch=$2 ;;
    --width) width=$2 ;; --rows) wanted=$2 ;; --kitti) kitti=$2 ;; --threads) threads=$2 ;; --seed) seed=$2 ;;
    --cps) cps=$2 ;; *) misused "$1: unknown; --help lists the options" ;;
  esac
  shift 2
done
[[ $views =~ ^([0-9]+),([0-9]+),([0-9]+)$ ]] || misused "--views $views: needs three numbers, as 160,40,40"
declare -A views_of=([cps-v1]=${BASH_REMATCH[1]} [cps-v2]=${BASH_REMATCH[2]} [cps-v3]=${BASH_REMATCH[3]}) is_made=()
names=()
for row in "${rows[@]}"; do names+=("${row%% *}"); done
require_rows "${names[@]}"

divided_sizes() { # RECIPE: its sizes, divided; fails where a side is not a whole number then
  awk -F' = ' -v by="$divide" '$1 == "size" {
    count = split($2, sizes, ", *")
    for (i = 1; i <= count; ++i) {
      split(sizes[i], side, "x")
      if (side[1] % by || side[2] % by) exit 1
      printf "%s%dx%d", (i > 1 ? "," : ""), side[1] / by, side[2] / by
    }
  }' "$recipes/$1.cfg"
}

scaled_views() { # RECIPE VIEWS: so many of the first size, of others in the recipe's proportion
  awk -F' = ' -v first="$2" '$1 == "views" {
    count = split($2, views, ", *")
    for (i = 1; i <= count; ++i) printf "%s%d", (i > 1 ? "," : ""), first * views[i] / views[1] + 0.5
  }' "$recipes/$1.cfg"
}

make_dataset() { # RECIPE VIEWS
  local size
  size=$(divided_sizes "$1") || misused "--divide $divide: does not divide the sizes of $1"
  "$cps" generate --recipe "$recipes/$1.cfg" --out "$work/data/$1" --size "$size" --views "$(scaled_views "$1" "$2")" \
    --cities "$cities" --conditions_per_scene 2 --views_per_lens 1 --threads "$threads"
}

write_table() {
  "$here/model_table.py" --out "$work/ladder" --title "The thesis' presets, ${minutes} minutes each" \
    --set "test part of its own data=eval.json" --set "test part of cps-v3=eval_cps-v3.json" \
    ${kitti:+--set "KITTI=eval_kitti.json"} "${models[@]}"
}

models=()
for row in "${rows[@]}"; do
  read -r name data options <<<"$row"
  is_wanted "$name" || continue
  models+=("$work/models/$name")
  for needed in "$data" cps-v3; do
    [ -n "${is_made[$needed]:-}" ] || make_dataset "$needed" "${views_of[$needed]}"
    is_made[$needed]=yes
  done
  case $options in
    *--orientation*)
      narrowest=$(narrowest_image "$work/data/$data")
      [ "${narrowest:-696}" -ge 696 ] ||
        echo "$name: measures orientation in images of $narrowest pixels; --divide 2 would make larger ones"
      ;;
  esac
  # The options are words without spaces.
  # shellcheck disable=SC2086
  train_row "$name" "$work/data/$data" $options --arch "$arch" --reduce 0 --width "$width"
  eval_row "$name" eval.json --data "$work/data/$data" --robustness
  if [ "$data" = cps-v3 ]; then
    cp "$work/models/$name/eval.json" "$work/models/$name/eval_cps-v3.json"
  else
    eval_row "$name" eval_cps-v3.json --data "$work/data/cps-v3"
  fi
  [ -z "$kitti" ] || eval_row "$name" eval_kitti.json --kitti "$kitti"
  write_table
done
