#!/usr/bin/env bash
# handout.sh <cmake> <archive> <chNN> <scratch folder>
# Unpacks what students get, looks for what they must not, and runs the commands of the brief there.
set -euo pipefail

cmake=$1 archive=$2 chapter=$3 scratch=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

fail() {
  echo "handout.sh: $1" >&2
  exit 1
}

rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"
"$cmake" -E tar xf "$archive"
[[ $(ls) == "particulate_$chapter" ]] || fail "the archive must hold one folder, holds $(ls)"
cd "particulate_$chapter"
LC_ALL=C ls | paste -sd " " | grep -qx "LICENSE README.md REVISION chapters lib" || fail "it must hold what is needed, no more"
folders=(chapters/*)
[[ ${folders[*]} =~ ^chapters/assignments" "chapters/${chapter}_[a-z_]+$ ]] || fail "one assignment belongs into it"
head=$(git -C "$here" rev-parse HEAD 2>/dev/null || echo unknown)
[[ $(<REVISION) == *$head* ]] || fail "REVISION must name $head, says $(<REVISION)"
for solution in "$here/$chapter"/*; do
  found=$(find . -name "$(basename "$solution")")
  [[ -z $found ]] || fail "students must not get $found"
done

# The brief's commands, on the source with holes, where it lies and elsewhere.
headers=(chapters/"$chapter"_*/assignment/*.hpp)
folder=$(dirname "${headers[0]}")
source=$(basename "${headers[0]}" .hpp).cpp
mkdir -p path/to
cp "$folder/$source" path/to
mapfile -t commands < <(grep -o '\./chapters/assignments/check\.sh [^`]*' "$folder/README.md")
((${#commands[@]} == 2)) || fail "the brief must hold two commands, holds ${#commands[@]}"
for command in "${commands[@]}"; do
  status=0
  bash -c "${command/YOUR-ID/anna}" >table || status=$?
  if ((status != 1)) || ! grep -q ' 0 of 20 *in all' table; then
    fail "'$command' must end with status 1 and no points, ended with $status: $(<table)"
  fi
done
