#!/usr/bin/env bash
# autograder.sh <cmake> <zip> <chNN> <source with holes> <folder of submissions> <scratch folder>
# Unpacks the zip below a root of its own as Gradescope does, and grades there: the source with holes, the
# reference, a source that does not compile, and none at all. Reads the scores out of results.json with CMake's parser.
set -euo pipefail

cmake=$1 zip=$2 chapter=$3 stub=$4 submissions=$5 scratch=$6
export AUTOGRADER=$scratch/autograder

fail() {
  echo "autograder.sh: $1" >&2
  exit 1
}

rm -rf "$scratch"
mkdir -p "$AUTOGRADER"/{source,submission,results}
(cd "$AUTOGRADER/source" && "$cmake" -E tar xf "$zip")
cp "$AUTOGRADER/source/run_autograder" "$AUTOGRADER/run_autograder"
[[ -x $AUTOGRADER/run_autograder && -x $AUTOGRADER/source/setup.sh ]] || fail "the scripts in the zip must be executable"
(cd "$AUTOGRADER/source" && ls) | diff - <(printf '%s\n' LICENSE REVISION chapters lib run_autograder setup.sh) ||
  fail "the zip must hold what the check needs and nothing else"
folders=$(cd "$AUTOGRADER/source/chapters" && echo *)
[[ $folders =~ ^assignments" "${chapter}_[a-z_]+$ ]] || fail "one assignment belongs in the zip"
"$AUTOGRADER/source/setup.sh"

cat >"$AUTOGRADER/submission_metadata.json" <<'END'
{"id": 1, "assignment": {"title": "Emails"}, "users": [{"email": "anna@school.edu", "id": 7, "name": "Anna"}]}
END

# grade <what> <points, or all> <text that the results must hold> [<source>]
grade() {
  rm -f "$AUTOGRADER/submission"/* "$AUTOGRADER/results"/*
  if (($# > 3)); then cp "$4" "$AUTOGRADER/submission/$(basename "$stub")"; fi
  "$AUTOGRADER/run_autograder" || fail "run_autograder must end well whatever is handed in, given $1"
  "$cmake" "-DPOINTS=$2" "-DSAYS=$3" "-DRESULTS=$AUTOGRADER/results/results.json" -P "$scratch/read.cmake"
}
cat >"$scratch/read.cmake" <<'END'
file(READ "${RESULTS}" results)
string(JSON points GET "${results}" score)
if(POINTS STREQUAL "all")
  string(JSON lines LENGTH "${results}" tests)
  set(POINTS 0)
  math(EXPR last "${lines} - 1")
  foreach(line RANGE ${last})
    string(JSON possible GET "${results}" tests ${line} max_score)
    math(EXPR POINTS "${POINTS} + ${possible}")
  endforeach()
endif()
string(FIND "${results}" "${SAYS}" at)
if(NOT points EQUAL POINTS OR at EQUAL -1)
  message(FATAL_ERROR "must hold ${POINTS} points and say '${SAYS}', got ${points} in ${results}")
endif()
END

grade "the source with holes" 0 "is this still the stub" "$stub"

# The reference calls the library, which is hidden from submissions otherwise. The ID chooses the variant, and a variant
# may have a reference of its own: the first that gets full marks will do.
"$cmake" -DSEES_LIBRARY=ON "$AUTOGRADER/source/build/assignments/$chapter" >/dev/null
is_full=false
for reference in "$submissions"/reference*.cpp; do
  $is_full || ! grade "$(basename "$reference")" all passed "$reference" >>"$scratch/references" 2>&1 || is_full=true
done
if ! $is_full; then
  cat "$scratch/references"
  fail "no reference gets full marks"
fi
"$cmake" -DSEES_LIBRARY=OFF "$AUTOGRADER/source/build/assignments/$chapter" >/dev/null

printf 'double broken( { return "quote \\ backslash"; }\n' >"$scratch/broken.cpp"
grade "a source that does not compile" 0 "error:" "$scratch/broken.cpp"
grade "nothing" 0 "Hand in $(basename "${stub%.cpp}").cpp"
