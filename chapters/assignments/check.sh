#!/usr/bin/env bash
# Grades one file: builds the check, builds the submission, asks it, prints the table of scores.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

usage() {
  cat <<END
usage: chapters/assignments/check.sh chNN [FILE] [options]

Grades FILE, or without it the source with holes in chapters/chNN_*/assignment. Needs cmake, a C++20 compiler, Eigen and
fmt. Ends with status 0 for full marks, 1 for less, 2 if nothing could be graded.

  --student ID     whose numbers to draw; the ID also chooses the variant
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

chapter='' file='' build='' options=()
while (($# > 0)); do
  case $1 in
    --help)
      usage
      exit
      ;;
    --student | --variant | --json | --seconds | --build)
      (($# > 1)) || refuse "a value must follow $1"
      if [[ $1 == --build ]]; then build=$2; else options+=("$1" "$2"); fi
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
[[ -n $chapter ]] || refuse "name the assignment by its chapter, such as ch01; --help says more"
if [[ -n $file ]]; then
  [[ -f $file ]] || refuse "the submission must be a file, got '$file'"
  file=$(cd "$(dirname "$file")" && pwd)/$(basename "$file")
fi
build=${build:-$root/build/assignments/$chapter}

# Programs are run by the user nobody where root grades; compilers speak plain ASCII.
umask 022
export LC_ALL=C
if [[ -z ${CMAKE_GENERATOR:-} ]] && command -v ninja >/dev/null; then export CMAKE_GENERATOR=Ninja; fi
mkdir -p "$build"
build=$(cd "$build" && pwd)
quietly() {
  "$@" >"$build/log" 2>&1 </dev/null && return
  cat "$build/log" >&2
  refuse "the check itself could not be made (see above)"
}
quietly cmake -S "$root/chapters/assignments" -B "$build" -DASSIGNMENT="$chapter" -DSUBMISSION="$file"
quietly cmake --build "$build" --target check --parallel "$(getconf _NPROCESSORS_ONLN)"

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
if ((status == 0)); then
  options+=(--program "$submission")
  grep -A 3 'warning:' "$build/submission.log" || true
else
  options+=(--log "$build/submission.log")
  echo "The submission does not compile; all the compiler says stands in $build/submission.log"
fi
"$build/check_$chapter" "${options[@]}"
