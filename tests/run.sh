#!/usr/bin/env bash
# Every test of the project, from a fresh machine to one verdict.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source=tests/setup.sh
. "$root/tests/setup.sh"

usage() {
  cat <<END
usage: tests/run.sh [options]

Installs what is missing, builds everything, and runs the unit tests, every chapter's program and its verification as
quick runs, the documentation with its check, and a small project that uses the library. Only failures and summaries are
printed. Ends with status 0 if all pass.
What takes long and seldom fails, the tests under the label ci, is left to .ci/run.

$setup_help
  --help            print this
END
}

for word in "$@"; do
  if [[ $word == --help ]]; then
    usage
    exit
  elif ! setup_option "$word"; then
    echo "tests/run.sh: there is no option '$word'" >&2
    usage >&2
    exit 2
  fi
done

stage set-up
set_up build docs

stage configure
cd "$root"
quietly cmake --preset release

stage build
built

# What comes after a failure still runs: one run shows all that is wrong. The documentation is made of quick runs of every
# chapter and its verification, and fails with them: the tests need not run them again.
stage documentation
status=0
left_out='ci'
if built --target docs; then
  left_out+='|chapters|verification'
else
  status=1
fi

# Of tests that pass nothing is printed; on a terminal one line says how far they are.
failures() {
  if [[ $verbose == yes ]]; then
    ctest "$@"
  elif [[ -t 1 ]]; then
    ctest --progress --no-label-summary "$@"
  else
    ctest --no-label-summary "$@" | grep -vE '^ +Start +[0-9]+: | Passed +[0-9.]+ sec$'
  fi
}
stage tests
failures --preset release --parallel "$(nproc)" --label-exclude "^($left_out)\$" || status=$?

print_stages
exit "$status"
