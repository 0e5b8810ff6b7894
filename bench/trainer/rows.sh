# Functions of ladder.sh, ablation.sh and deepcalib.sh, which source this file. A row of their tables is a network in
# $work/models/NAME. They read the variables cps, work, threads, minutes, seed and wanted, and the array further: options of cps train
# that the user adds to all rows.
# shellcheck shell=bash disable=SC2034,SC2154
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
further=()
export LC_ALL=C.UTF-8 # a point in the numbers of `time`
TIMEFORMAT='%U %S'

complain() { echo "${0##*/}: $*" >&2; }

misused() {
  complain "$@"
  exit 2
}

fail() {
  complain "$@"
  exit 1
}

# The comment at the head of the script, which is its help.
print_help() { sed -n '2,/^[^#]/{s/^# \{0,1\}//p}' "$0"; }

is_wanted() { # NAME: whether it is among $wanted, names between commas; empty: all
  case ",$wanted," in ,, | *",$1,"*) ;; *) return 1 ;; esac
}

require_rows() { # NAME…: every name in $wanted is one of these
  local name
  for name in ${wanted//,/ }; do
    case " $* " in *" $name "*) ;; *) misused "--rows $name: unknown: choose from $*" ;; esac
  done
}

narrowest_image() { # DATASET: the least width of its images, from the names of its sets
  find "$1" -maxdepth 1 -type d -name '[0-9]*x[0-9]*_*' -printf '%f\n' | sed 's/x.*//' | sort -n | sed -n 1p
}

# Trains a network for the budget of a row, or goes on with it, unless it is ready. More epochs than the budget allows, so
# that all rows use it up. Each run adds its CPU seconds, user and system, to the file
# cpu_seconds; a run that is killed together with the script is missing there.
train_row() { # NAME DATASET OPTION…
  local model=$work/models/$1 data=$2
  shift 2
  local options=("$@" --epochs 100000 --minutes "$minutes" --threads "$threads" --seed "$seed" "${further[@]}")
  local command="${data##*/}: ${options[*]}"
  mkdir -p "$model"
  if [ -e "$model/command" ] && [ "$(<"$model/command")" != "$command" ]; then
    misused "$model: was trained with other options, see the file 'command' there: remove it or choose another folder"
  fi
  echo "$command" >"$model/command"
  [ ! -e "$model/trained" ] || return 0
  echo "training ${model##*/}"
  if [ -e "$model/state.pt" ]; then
    options=(--resume)
  else
    rm -f "$model/model.json" # of a run that ended before its first epoch did
  fi
  { time "$cps" train --data "$data" --out "$model" "${options[@]}" >>"$model/log" 2>&1; } 2>>"$model/cpu_seconds" ||
    fail "cps train failed: $model/log says why"
  touch "$model/trained"
}

# Measures a network unless the file, in its folder, is there.
eval_row() { # NAME FILE OPTION…
  local model=$work/models/$1 file=$work/models/$1/$2
  shift 2
  [ ! -e "$file" ] || return 0
  echo "measuring ${model##*/}: ${file##*/}"
  "$cps" eval --model "$model" --threads "$threads" --out "$file" "$@" >>"$model/log" 2>&1 ||
    fail "cps eval failed: $model/log says why"
}
