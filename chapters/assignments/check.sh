#!/usr/bin/env bash
# Grades one file: builds the check, builds the submission, asks it, prints the table of scores.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

usage() {
  cat <<END
usage: chapters/assignments/check.sh chNN [FILE] [options]

Grades FILE, or without it the source with holes in chapters/chNN_*/assignment. Needs cmake, a C++20 compiler, Eigen and
fmt. Ends with status 0 for full marks, 1 for less, 2 if nothing could be graded.

  --student ID     whose numbers to draw, required; the ID also chooses the variant. Capital letters of ASCII and blanks
                   at the ends do not matter
  --variant N      the problem's variant, whatever the ID says
  --json FILE      also write the scores as Gradescope reads them
  --seconds N      processor time of a line of the table (default 2)
  --build FOLDER   where to build (default build/assignments/chNN)
  --help           print this
END
}

refuse() {
  echo "check.sh: $1" >&2
  exit 2
}

chapter='' file='' build='' student='' json='' options=()
while (($# > 0)); do
  case $1 in
    --*=*)
      set -- "${1%%=*}" "${1#*=}" "${@:2}"
      continue
      ;;
    --help)
      usage
      exit
      ;;
    --student | --variant | --json | --seconds | --build)
      (($# > 1)) || refuse "a value must follow $1"
      [[ -n $2 && $2 != -* ]] || refuse "a value must follow $1, not empty and not beginning with '-', got '$2'"
      case $1 in
        --build) build=$2 ;;
        --student) student=$2 ;;
        --json) json=$2 ;;
        *) options+=("$1" "$2") ;;
      esac
      shift
      ;;
    -*) refuse "there is no option '$1'; --help lists them" ;;
    *)
      if [[ -z $chapter ]]; then
        chapter=$1
      elif [[ -z $file ]]; then
        file=$1
      else
        refuse "one file is graded at a time, got '$file' and '$1'"
      fi
      ;;
  esac
  shift
done
chapters=()
for folder in "$root"/chapters/ch*_*/assignment; do
  name=$(basename "$(dirname "$folder")")
  chapters+=("${name%%_*}")
done
[[ -n $chapter && " ${chapters[*]} " == *" $chapter "* ]] ||
  refuse "name the assignment by its chapter, one of: ${chapters[*]}; got '$chapter'. --help says more"
[[ -n ${student//[[:space:]]/} ]] ||
  refuse "name the student, --student ID: the ID draws the numbers and chooses the variant"
options+=(--student "$student")
if [[ -n $json ]]; then
  [[ -d $(dirname "$json") && -w $(dirname "$json") && ! -d $json ]] ||
    refuse "$json cannot be written: name a file in a folder that exists and can be written to"
  rm -f "$json" # the scores of another submission: a check that dies must not leave them as its own
  options+=(--json "$json")
fi
if [[ -n $file ]]; then
  [[ -f $file ]] || refuse "the submission must be a file, got '$file'"
  file=$(cd "$(dirname "$file")" && pwd)/$(basename "$file")
fi
build=${build:-$root/build/assignments/$chapter}
headers=("$root/chapters/${chapter}"_*/assignment/*.hpp)
source=$(basename "${headers[0]}" .hpp).cpp
shown=${file:-${headers[0]%.hpp}.cpp}

# Programs are run by the user nobody where root grades; compilers speak plain ASCII.
umask 022
export LC_ALL=C
if [[ -z ${CMAKE_GENERATOR:-} ]] && command -v ninja >/dev/null; then export CMAKE_GENERATOR=Ninja; fi
mkdir -p "$build" || refuse "$build cannot be made: name another folder with --build"
build=$(cd "$build" && pwd)
quietly() {
  "$@" >"$build/log" 2>&1 </dev/null && return
  cat "$build/log" >&2
  refuse "the check itself could not be made (see above)"
}
[[ -x $build/check_$chapter ]] || echo "Building the check, which is done once: about half a minute" >&2
quietly cmake -S "$root/chapters/assignments" -B "$build" -DASSIGNMENT="$chapter" -DSUBMISSION="$file"
quietly cmake --build "$build" --target check --parallel "$(getconf _NPROCESSORS_ONLN)"

# A copy is compiled: what the compiler says of it is said of the file that was given.
name_the_file() {
  local log
  log=$(<"$build/submission.log")
  log=${log//"$build/submission/$source"/"$shown"}
  log=${log//" submission/$source"/" $shown"}
  log=${log//$'\n'"submission/$source"/$'\n'"$shown"}
  printf '%s\n' "$log" >"$build/submission.log"
}

# What is handed in may also hang the compiler, or eat memory there.
submission=$build/bin/submission
rm -f "$submission"
compile() (
  ulimit -t 120
  ulimit -v 4000000 2>/dev/null || true # macOS has no such limit
  exec cmake --build "$build" --target submission
)
status=0
compile >"$build/submission.log" 2>&1 </dev/null || status=$?
name_the_file
if ((status == 0)); then
  options+=(--program "$submission")
  grep -A 3 'warning:' "$build/submission.log" || true
else
  options+=(--log "$build/submission.log")
  echo "The submission does not compile; all the compiler says stands in $build/submission.log"
fi
"$build/check_$chapter" "${options[@]}"
