#!/usr/bin/env bash
# Gradescope runs this once, when it makes the image: compiler and libraries, and the check, so that grading is quick.
set -euo pipefail

autograder=${AUTOGRADER:-/autograder}

wants=()
command -v g++ >/dev/null || wants+=(g++)
command -v cmake >/dev/null || wants+=(cmake)
command -v make >/dev/null || command -v ninja >/dev/null || wants+=(make)
[[ -f /usr/include/eigen3/Eigen/Core ]] || wants+=(libeigen3-dev)
[[ -f /usr/include/fmt/format.h ]] || wants+=(libfmt-dev)
if ((${#wants[@]} > 0)); then
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -q
  apt-get install -y -q --no-install-recommends "${wants[@]}"
fi

version=$(cmake --version | sed -n '1s/[^0-9]*\([0-9.]*\).*/\1/p')
if [[ $(printf '%s\n' 3.25 "$version" | sort -V | head -n 1) != 3.25 ]]; then
  echo "setup.sh: CMake must be 3.25 or newer, found $version: choose an image of Ubuntu 24.04 or Debian 12" >&2
  exit 1
fi

shopt -s nullglob
folders=("$autograder"/source/chapters/ch*_*/assignment)
if ((${#folders[@]} != 1)); then
  echo "setup.sh: $autograder/source must hold one assignment, found ${#folders[@]}; unpack the zip there" >&2
  exit 1
fi
chapter=$(basename "$(dirname "${folders[0]}")")
chapter=${chapter%%_*}

# The source with holes is graded, which builds the check: fewer than full marks must come of it.
status=0
"$autograder/source/chapters/assignments/check.sh" "$chapter" --student setup || status=$?
if ((status != 1)); then
  echo "setup.sh: grading the source with holes must end with status 1, got $status: see above for why" >&2
  exit 1
fi
