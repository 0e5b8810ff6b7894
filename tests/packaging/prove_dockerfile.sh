#!/usr/bin/env bash
# Proves the Dockerfile without Docker: carries out its instructions, stage by stage, in bare Debian 12 roots made by debootstrap,
# and uses what comes out, as root and as ordinary users. Needs root, debootstrap, the net and 10 GB in TMPDIR; takes as long as a
# build of everything. Exit status 77: cannot run here.
#   CPS_MIRROR   Debian mirror; CPS_KEEP=1 keeps the roots
#   CPS_CCACHE   folder in which compiled objects are kept from one proof to the next
set -euo pipefail

source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if [ "$(id -u)" != 0 ] || ! command -v debootstrap >/dev/null; then
  echo "prove_dockerfile.sh: needs root and debootstrap; skipped"
  exit 77
fi
work=$(mktemp -d "${TMPDIR:-/var/tmp}/cps_dockerfile_XXXXXX")
[ -n "${CPS_KEEP:-}" ] || trap 'rm -rf --one-file-system "$work"' EXIT
say() { printf '\n== %s\n' "$*"; }
fail() {
  echo "prove_dockerfile.sh: $*" >&2
  exit 1
}

# in_root ROOT USER FOLDER COMMAND: as a container runs it. The mounts go with the process.
in_root() {
  # shellcheck disable=SC2016
  CPS_CCACHE=${CPS_CCACHE:-} unshare --mount --fork sh -euc '
    mount --bind /dev "$1/dev"
    mount -t proc proc "$1/proc" 2>/dev/null || mount --rbind /proc "$1/proc"
    [ -z "$CPS_CCACHE" ] || { mkdir -p "$CPS_CCACHE" "$1/root/.cache/ccache" && mount --bind "$CPS_CCACHE" "$1/root/.cache/ccache"; }
    exec chroot --userspec="$2" "$1" env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      sh -c "cd \"\$0\" && $4" "$3"' sh "$1" "$2" "$3" "$4"
}

say "A bare Debian 12"
debootstrap --variant=minbase bookworm "$work/debian" "${CPS_MIRROR:-http://deb.debian.org/debian}" >"$work/debootstrap.log" ||
  { tail -20 "$work/debootstrap.log"; fail "debootstrap failed"; }
cp -L /etc/resolv.conf "$work/debian/etc/resolv.conf"
echo 'APT::Sandbox::User "root";' >"$work/debian/etc/apt/apt.conf.d/sandbox"  # its user may not open sockets in some containers

# The working tree as `COPY . FOLDER` takes it: with .git, without what .dockerignore names.
copy_sources() {
  git clone -q --no-hardlinks "$source" "$1"
  (cd "$source" && git ls-files -z | xargs -0 cp -a --parents -t "$1")
}

root='' user=root folder=/ command=''
while read -r instruction rest; do
  say "$instruction $rest"
  case $instruction in
    FROM)
      read -r image _ stage <<<"$rest"
      case $image in debian:12 | debian:12-slim) from=debian user=root folder=/ ;; *) from=$image ;; esac
      root=$work/$stage
      cp -a "$work/$from" "$root" ;;
    COPY)
      case $rest in
        --from=*)
          read -r option file target <<<"$rest"
          mkdir -p "$root$target"
          # shellcheck disable=SC2086
          cp -a "$work/${option#--from=}"$file "$root$target" ;;
        ". "*) copy_sources "$root${rest#. }" ;;
        *) fail "COPY $rest: is not understood" ;;
      esac ;;
    WORKDIR) folder=$rest && mkdir -p "$root$rest" ;;
    USER) user=$rest ;;
    RUN) in_root "$root" "$user" "$folder" "$rest" </dev/null >"$work/run.log" 2>&1 || { tail -40 "$work/run.log"; fail "RUN failed"; } ;;
    CMD) command=$(tr -d '[],"' <<<"$rest") ;;
    *) fail "$instruction: is not understood" ;;
  esac
done < <(sed -e ':a' -e '/\\$/{N;s/ *\\\n */ /;ta' -e '}' -e '/^#/d' -e '/^$/d' "$source/Dockerfile")

for stage in render train; do
  root=$work/$stage
  say "$stage: the default command"
  in_root "$root" cps /data "$command" | grep -q '^Usage: cps VERB' || fail "$command: printed no usage"
  in_root "$root" cps /data "cps --version" | grep -E '^cps [0-9.]+ \(commit [0-9a-f]{10}' || fail "the version names no commit"
  [ "$(in_root "$root" cps /data "id -u")" = 1000 ] || fail "cps is not user 1000"
  for who in cps root 4321:4321; do
    say "$stage: a dataset, as $who"
    # A user of the host writes into a folder that is his, mounted in the container.
    install -d -m 777 "$root/data"
    in_root "$root" "$who" /data "cps generate --recipe demo --scale 0.05 --size 96x54 --samples 2 --out made && cps verify made && \
      cps contact-sheet made -o made/sheet.png && rm -r made" || fail "no dataset as $who"
  done
  for file in man/man1/cps.1.gz man/man1/cps-generate.1.gz man/man1/cps-slurm.1.gz bash-completion/completions/cps \
    zsh/vendor-completions/_cps cps/slurm/cps-array.sbatch cps/kubernetes/cps-generate.yaml cps/aws-batch/generate.json \
    cps/recipes/demo.cfg doc/cps/copyright; do
    [ -s "$root/usr/share/$file" ] || fail "$stage: /usr/share/$file is missing"
  done
done

say "The trainer"
in_root "$work/train" cps /data "cps generate --recipe demo --scale 0.05 --size 96x54 --samples 2 --out made && \
  cps train --data made --out model --arch resnet18 --epochs 1 --width 96 && cps predict --model model made/\$(head -n 1 made/splits/test.txt)" ||
  fail "cps train failed"
[ ! -e "$work/render/usr/bin/cps-train" ] || fail "the render node has cps-train"

say "Removing the packages leaves nothing"
installed=$(in_root "$work/train" root / "dpkg -L cps cps-train")
in_root "$work/train" root / "apt-get purge -y cps cps-train" >/dev/null
for file in $installed; do
  path=$work/train$file
  case $file in *cps*) [ ! -e "$path" ] && [ ! -L "$path" ] || fail "$file is left" ;; esac
done
say "Proved: $(du -sh --apparent-size "$work/render" | cut -f1) with cps, $(du -sh --apparent-size "$work/train" | cut -f1) with cps-train before that"
