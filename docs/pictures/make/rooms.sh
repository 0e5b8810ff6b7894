#!/usr/bin/env bash
# Makes docs/pictures/rooms.svg from the link lists of the rooms' CMakeLists.txt. Run it in the repository's root:
#   docs/pictures/make/rooms.sh > docs/pictures/rooms.svg
# Needs Debian's graphviz. An arrow runs from a room to one that uses it; arrows that follow from others are left out.
#   docs/pictures/make/rooms.sh --arrows    lists all arrows, "used user" a line
set -euo pipefail

rooms="numbers random files distortion sensor scenes renderer sampler dataset production trainer apps"

arrows() {
  local room used
  for room in $rooms; do
    find "$room" -name CMakeLists.txt -exec cat {} + | sed 's/#.*//' | grep -oE 'cps_[a-z]+' | sed 's/^cps_//; s/^city$/scenes/' | sort -u |
      while read -r used; do
        case " $rooms " in *" $used "*) [ "$used" = "$room" ] || echo "$used $room" ;; esac
      done
  done
}

node() { printf '  %s [label=<<b>%s/</b><br/><font point-size="11" color="#444444">%s</font>>]\n' "$1" "$1" "$2"; }

if [ "${1:-}" = --arrows ]; then
  arrows
  exit
fi
{
  echo 'digraph rooms {'
  echo '  rankdir=BT; ranksep=0.32; nodesep=0.28; bgcolor=white;'
  echo '  node [shape=box, style="rounded,filled", fillcolor="#eef3f8", color="#5b7c99", fontname="DejaVu Sans", fontsize=13, margin="0.14,0.07"];'
  echo '  edge [color="#5b7c99", arrowsize=0.7];'
  node numbers "angles, intervals, sRGB, CPU time"
  node random "the hash behind every drawn number"
  node files "read, write, lock, plot"
  node distortion "lens, certificate, crop, warp"
  node sensor "master to pixels"
  node scenes "glTF, procedural city, rig, routes"
  node renderer "path tracer"
  node sampler "recipe to plan"
  node dataset "labels, journal, checks, formats"
  node production "views rendered, images made"
  node trainer "networks, training, evaluation"
  node apps "cps, cps-train: one file a verb"
  echo '  { rank=same; numbers; random; files }'
  arrows | sed 's/\(.*\) \(.*\)/  \1 -> \2/'
  echo '}'
} | tred | dot -Tsvg | perl -0pe 's/<!--.*?-->\n//gs; s/<!DOCTYPE.*?>\n//s'
