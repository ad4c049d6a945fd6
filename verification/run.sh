#!/usr/bin/env bash
# The verification of every chapter, from a fresh machine to a table of verdicts.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=tests/setup.sh
. "$root/tests/setup.sh"

usage() {
  cat <<END
usage: verification/run.sh [options]

Installs what is missing, builds, runs every chapter's verification program, prints one table a chapter and every
failure in full, and ends with status 1 if any claim fails. All rows stand in rows.csv.
A full run takes less than ten minutes after the build, a quick one less than two.

  --quick           smaller sizes and fewer repeats; no claim is dropped
  --chapter NAME    only this chapter, ch01 for instance; may be repeated
  --out DIR         where the results go (default: build/verification)
  --against DIR     compare with an earlier run's results in DIR: what came, went or moved; a claim that got worse or
                    is gone is a failure
$setup_help
  --help            print this
END
}

wrong() {
  echo "verification/run.sh: $1" >&2
  usage >&2
  exit 2
}

# value_of <option> <arguments left> <value>: the value, or a refusal.
value_of() {
  if [[ $2 -lt 2 || -z $3 || $3 == --* ]]; then wrong "$1 needs a value"; fi
}

run=(--full)
out=$root/build/verification
against=
chosen=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --quick) run=(--quick) ;;
    --chapter | --out | --against)
      value_of "$1" $# "${2:-}"
      case $1 in
        --chapter) chosen+=("$2") ;;
        --out) out=$2 ;;
        --against) against=$2 ;;
      esac
      shift
      ;;
    --help)
      usage
      exit
      ;;
    *) setup_option "$1" || wrong "there is no option '$1'" ;;
  esac
  shift
done

chapters=()
for folder in "$root"/verification/{ch,app}[0-9A-Z]*_*/; do
  if [[ -d $folder ]]; then
    name=$(basename "$folder")
    chapters+=("${name%%_*}")
  fi
done
for name in "${chosen[@]}"; do
  if [[ " ${chapters[*]} " != *" $name "* ]]; then
    wrong "there is no chapter '$name' to verify; there are: ${chapters[*]}"
  fi
done
if [[ ${#chosen[@]} -gt 0 ]]; then
  mapfile -t chapters < <(printf '%s\n' "${chosen[@]}" | sort -u)
fi

# Everything that could make a long run useless is asked before it starts.
mkdir -p "$out" || wrong "--out must name a folder that can be made, got '$out'"
out=$(cd "$out" && pwd)
if [[ ! -w $out ]]; then wrong "--out must name a folder that can be written, got '$out'"; fi
if [[ -n $against ]]; then
  for name in '' "${chosen[@]/#//}"; do
    if [[ ! -f $against$name/rows.csv ]]; then
      wrong "--against must name the folder of a run, yet there is no $against$name/rows.csv"
    fi
  done
  against=$(cd "$against" && pwd)
  if [[ $against == "$out" ]]; then
    wrong "--against must name another folder than --out, whose results this run replaces: '$out'"
  fi
fi

stage set-up
set_up build

stage configure
cd "$root"
# The documentation needs more than verification does: it is left out where that is missing.
docs=ON
if [[ -n $(missing_packages docs) ]]; then docs=OFF; fi
quietly cmake --preset release -DPARTICULATE_DOCS=$docs

stage build
targets=(compare_runs)
for name in "${chapters[@]}"; do targets+=("verify_$name"); done
built --target "${targets[@]}"

# joined <file>: the chapters' tables of that name under one header. A chapter that died is left out.
joined() {
  local name header='' this
  for name in "${finished[@]}"; do
    this=$(head -n 1 "$out/$name/$1") || return 1
    if [[ -z $header ]]; then
      header=$this
      echo "$header"
    elif [[ $this != "$header" ]]; then
      echo "verification/run.sh: $out/$name/$1 must have the columns of the chapters before it: $header" >&2
      return 1
    fi
    tail -n +2 "$out/$name/$1" || return 1
  done
}

# merge <file>: writes what is joined, whole.
merge() {
  if joined "$1" >"$out/$1.part"; then
    mv "$out/$1.part" "$out/$1"
  else
    rm "$out/$1.part"
    failed+=("$1 (not written)")
  fi
}

# What a run that is cut short leaves must not look like one that ended.
rm -f "$out"/{rows,work_precision,stability}.csv "$out/stamp.json"
if [[ $verbose == yes ]]; then run+=(--verbose); fi
started=$out/.started
touch "$started"
finished=()
failed=()
for name in "${chapters[@]}"; do
  stage "$name"
  status=0
  "$root/build/release/bin/verify_$name" "${run[@]}" --out "$out/$name" || status=$?
  if [[ $status -ne 0 ]]; then failed+=("$name (status $status)"); fi
  # A program that died has left no results, or those of an earlier run.
  if [[ $out/$name/rows.csv -nt $started && $out/$name/stamp.json -nt $started ]]; then
    finished+=("$name")
  elif [[ $status -eq 0 ]]; then
    failed+=("$name (no results)")
  fi
done
rm "$started"

if [[ ${#finished[@]} -gt 0 ]]; then
  for file in rows.csv work_precision.csv stability.csv; do merge "$file"; done
fi
if [[ ${#finished[@]} -eq ${#chapters[@]} ]]; then
  cp "$out/${finished[0]}/stamp.json" "$out/stamp.json.part"
  mv "$out/stamp.json.part" "$out/stamp.json"
fi

# compare [<chapter>]: a row that got worse or is gone counts as a failure.
compare() {
  "$root/build/release/bin/compare_runs" "$against${1:+/$1}" "$out${1:+/$1}" || failed+=("comparison (status $?)")
}

if [[ -n $against ]]; then
  stage compare
  if [[ ${#chosen[@]} -eq 0 ]]; then
    compare
  else
    for name in "${finished[@]}"; do compare "$name"; done
  fi
fi

print_stages
printf '\nResults: %s\n' "$out"
if [[ ${#failed[@]} -gt 0 ]]; then
  printf 'Verification FAILED:'
  printf ' %s' "${failed[@]}"
  printf '\n'
  exit 1
fi
echo "Verification passed: every claim of ${chapters[*]} holds."
