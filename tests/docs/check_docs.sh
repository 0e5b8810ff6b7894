#!/usr/bin/env bash
# Checks the documentation against the repository; run in its root. Prints one line for each fault, and exits with 1 if there is one.
#   - every relative link leads to a file, every #anchor to a heading;
#   - every path in `backticks` that begins with a folder of the repository exists;
#   - pictures carry no metadata (EXIF, comments, folders of the machine that made them);
#   - the arrows of docs/pictures/rooms.svg are the link lists of the CMakeLists.txt.
set -euo pipefail
export LC_ALL=C
faults=$(mktemp)
trap 'rm -f "$faults"' EXIT
fault() { echo "$*" | tee -a "$faults"; }

anchors() {  # the anchors of a page's headings, as GitHub makes them
  sed -n 's/^#\{1,6\} //p' "$1" | tr 'A-Z' 'a-z' | sed 's/[^a-z0-9 _-]//g; s/ /-/g'
}

pages=$(git ls-files '*.md')
rooms="numbers random files distortion sensor scenes renderer sampler dataset production trainer apps"
# shellcheck disable=SC2086
folders="$(echo $rooms tests bench docs cmake python .github | tr ' ' '|')"

for page in $pages; do
  here=$(dirname "$page")
  { grep -oE '\]\([^)[:space:]]+\)' "$page" || true; } | sed 's/^](//; s/)$//' | while read -r link; do
    case $link in http://* | https://* | mailto:*) continue ;; esac
    file=${link%%#*} anchor=""
    case $link in *#*) anchor=${link#*#} ;; esac
    target=$page
    [ -z "$file" ] || target=$here/$file
    if [ ! -e "$target" ]; then
      fault "$page: the link $link leads nowhere"
    elif [ -n "$anchor" ] && ! anchors "$target" | grep -qxF -- "$anchor"; then
      fault "$page: the link $link names a heading that $target lacks"
    fi
  done
  [ "$page" = CHANGELOG.md ] && continue  # it names what was
  { grep -oE "\`($folders)/[A-Za-z0-9_./-]*\`" "$page" || true; } | tr -d '`' | sort -u | while read -r path; do
    [ -e "$path" ] || fault "$page: $path does not exist"
  done
done

for picture in $(git ls-files docs/pictures); do
  case $picture in
    *.jpg)  # after the JFIF header (20 bytes) come the tables of the picture: FFDB, FFC0 … FFC4
      marker=$(od -An -tx1 -j20 -N2 "$picture" | tr -d ' ')
      case $marker in ffdb | ffc[0-4]) ;; *) fault "$picture: has metadata (strip it: jpegtran -copy none)" ;; esac ;;
    *.png) if grep -qaE 'tEXt|iTXt|zTXt|eXIf|tIME' "$picture"; then fault "$picture: has metadata (strip it: exiftool -all=)"; fi ;;
    *.svg) if grep -qE '<metadata|/(root|home|work|tmp)/' "$picture"; then fault "$picture: has metadata"; fi ;;
  esac
done

# Arrows "a b" (b uses a): in the picture, and in the link lists.
drawn=$(sed -n 's/.*<title>\([a-z]*\)&#45;&gt;\([a-z]*\)<\/title>.*/\1 \2/p' docs/pictures/rooms.svg)
linked=$(docs/pictures/make/rooms.sh --arrows)
awk -v drawn="$drawn" -v linked="$linked" '
  BEGIN {
    n = split(drawn, words); for (i = 1; i < n; i += 2) { picture[words[i], words[i + 1]] = reach[words[i], words[i + 1]] = 1; room[words[i]]; room[words[i + 1]] }
    n = split(linked, words); for (i = 1; i < n; i += 2) { list[words[i], words[i + 1]] = 1; room[words[i]]; room[words[i + 1]] }
    for (k in room) for (i in room) for (j in room) if (((i, k) in reach) && ((k, j) in reach)) reach[i, j] = 1
    for (i in room) {
      if ((i, i) in reach) print "docs/pictures/rooms.svg: a circle through " i
      for (j in room) {
        if (((i, j) in picture) && !((i, j) in list)) print "docs/pictures/rooms.svg: draws " i " -> " j ", which no link list has; make it anew"
        if (((i, j) in list) && !((i, j) in reach)) print "docs/pictures/rooms.svg: lacks " i " -> " j "; make it anew"
      }
    }
  }' | while read -r line; do fault "$line"; done

[ ! -s "$faults" ]
