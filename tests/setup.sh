# Shared by tests/run.sh, verification/run.sh and .ci/run: finds out what is missing on this machine and installs it.
# Sourced, not run:
#
#   setup_option --yes       takes --yes, --no-install and --verbose; false for any other word
#   set_up build docs lint   makes these sets of tools and libraries present, or ends the script
#
# shellcheck shell=bash

setup_answer=unasked # yes: install without asking, no: never install
verbose=no

# Printed by the --help of those who source this.
# shellcheck disable=SC2034
setup_help='  --yes             install missing packages without asking
  --no-install      install nothing: list what is missing, and fail if something is
  --verbose         print all that happens, not failures and summaries alone'

setup_option() {
  case $1 in
    --yes) setup_answer=yes ;;
    --no-install) setup_answer=no ;;
    --verbose) verbose=yes ;;
    *) return 1 ;;
  esac
}

# One line a package: its set, its Debian name, and what shows that it is there: a command (any of several) or a file
# below a prefix. It is looked for itself, not in dpkg, so that what came from elsewhere counts too.
setup_table='
build g++                   command g++ c++
build cmake                 command cmake
build ninja-build           command ninja
build libeigen3-dev         file include/eigen3/Eigen/Core
build libfmt-dev            file include/fmt/format.h
build libsundials-dev       file include/arkode/arkode_arkstep.h
build libboost-dev          file include/boost/math/tools/config.hpp
build libboost-test-dev     file lib*/libboost_unit_test_framework.so lib/*/libboost_unit_test_framework.so
build libcli11-dev          file include/CLI/CLI.hpp
build nlohmann-json3-dev    file include/nlohmann/json.hpp
build libtomlplusplus-dev   file include/toml++/toml.h
build valgrind              command valgrind
docs  doxygen               command doxygen
docs  gnuplot-nox           command gnuplot
docs  libjs-mathjax         file share/javascript/mathjax/MathJax.js
docs  fonts-mathjax         file share/javascript/mathjax/fonts
docs  texlive-binaries      command bibtex
docs  chromium              command chromium chromium-browser google-chrome
lint  clang-format          command clang-format
lint  clang-tidy            command clang-tidy
clang clang-19              command clang++-19
clang libclang-rt-19-dev    file lib/llvm-19/lib/clang/19/lib/*/libclang_rt.asan*.a
'

# is_there command <names>...    is_there file <patterns below a prefix>...
is_there() {
  local kind=$1 name prefix prefixes
  shift
  IFS=: read -r -a prefixes <<<"/usr:/usr/local:${CMAKE_PREFIX_PATH:-}"
  for name in "$@"; do
    if [[ $kind == command ]]; then
      if command -v "$name" >/dev/null; then return 0; fi
      continue
    fi
    for prefix in "${prefixes[@]}"; do
      if [[ -n $prefix ]] && compgen -G "$prefix/$name" >/dev/null; then return 0; fi
    done
  done
  return 1
}

# missing_packages <sets>...: their names, one a line.
missing_packages() {
  local set package probe
  while read -r set package probe; do
    # shellcheck disable=SC2086 # the probe is several words, and its patterns belong to compgen
    if [[ " $* " == *" $set "* ]] && ! (set -f && set -- $probe && set +f && is_there "$@"); then
      echo "$package"
    fi
  done <<<"$setup_table"
}

# Prints what installing these packages would fetch and take, with everything they pull in.
list_sizes() {
  local plan
  apt-cache show --no-all-versions "$@" 2>/dev/null | awk '
    /^Package: / { name = $2 }
    /^Installed-Size: / { installed[name] = $2 / 1024 }
    /^Size: / { printf "  %-22s %7.1f MB to fetch, %7.1f MB on disk\n", name, $2 / 1048576, installed[name] }'
  # A simulation names every package; their sizes stand in the package lists.
  plan=$(apt-get --simulate --no-install-recommends install "$@" 2>/dev/null | awk '/^Inst / { print $2 }') || plan=
  if [[ -z $plan ]]; then
    echo "  (sizes unknown: the package lists are empty or do not hold them all; run apt-get update)"
    return
  fi
  # shellcheck disable=SC2086 # one word a package
  apt-cache show --no-all-versions $plan | awk '
    /^Installed-Size: / { installed += $2 / 1024 }
    /^Size: / { size += $2 / 1048576; packages += 1 }
    END { printf "  with all they need: %d packages, %.0f MB to fetch, %.0f MB on disk\n", packages, size, installed }'
}

# Whether a person can be asked, and agrees.
agreed() {
  local answer
  if [[ $setup_answer == yes ]]; then return 0; fi
  if [[ ! -t 0 || ! -t 1 ]]; then
    echo "Not on a terminal, so nobody is asked: installing them (--no-install forbids it)."
    return 0
  fi
  read -r -p "Install them now? [Y/n] " answer || return 1
  [[ ${answer:-y} == [yY]* ]]
}

apt() {
  "${setup_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600 "$@"
}

# refuse <why> <packages>...
refuse() {
  echo "$1 Install them yourself, then run this again:" >&2
  echo "  Debian 12+, Ubuntu 24.04+:  apt-get install --no-install-recommends ${*:2}" >&2
  echo "  elsewhere: the same tools and libraries under your system's names; set CMAKE_PREFIX_PATH if they live" >&2
  echo "  outside /usr and /usr/local" >&2
  exit 1
}

# Where Ubuntu has no package of that name, its own one.
here_called() {
  if [[ $1 == chromium && -z $(apt-cache madison chromium 2>/dev/null) ]]; then
    echo chromium-browser
  else
    echo "$1"
  fi
}

set_up() {
  local missing=() name i
  mapfile -t missing < <(missing_packages "$@")
  if [[ ${#missing[@]} -eq 0 ]]; then
    return
  fi

  echo "Missing on this machine: ${missing[*]}"
  if ! command -v apt-get >/dev/null; then
    refuse "This system has no apt-get." "${missing[@]}"
  fi
  setup_root=()
  if [[ $setup_answer == no ]]; then
    list_sizes "${missing[@]}"
    refuse "--no-install was given." "${missing[@]}"
  fi
  if [[ $EUID -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      refuse "Installing needs root, and there is no sudo." "${missing[@]}"
    fi
    setup_root=(sudo)
  fi

  apt update -q >/dev/null || refuse "apt-get update failed (see above)." "${missing[@]}"
  for i in "${!missing[@]}"; do
    missing[i]=$(here_called "${missing[i]}")
  done
  list_sizes "${missing[@]}"
  if ! agreed; then
    refuse "Nothing was installed." "${missing[@]}"
  fi
  apt install -y -q --no-install-recommends "${missing[@]}" ||
    refuse "apt-get could not install them (see above)." "${missing[@]}"

  mapfile -t missing < <(missing_packages "$@")
  if [[ ${#missing[@]} -ne 0 ]]; then
    refuse "apt-get ended well, yet these are still not found." "${missing[@]}"
  fi
}

# quietly <command>...: what it prints is shown if it fails, and with --verbose.
quietly() {
  local said status=0
  if [[ $verbose == yes ]]; then
    "$@"
    return
  fi
  said=$("$@" 2>&1) || status=$?
  if [[ $status -ne 0 ]]; then printf '%s\n' "$said" >&2; fi
  return "$status"
}

# built <arguments>...: builds the release preset. On a terminal its progress is one line that overwrites itself.
built() {
  if [[ -t 1 ]]; then
    cmake --build --preset release "$@"
  else
    quietly cmake --build --preset release "$@"
  fi
}

# Seconds by stage. `stage <name>` starts one and ends the one before it; `print_stages` shows them all: what the clock
# says, and what the processors did for this script and for all that it started and waited for.
stage_names=()
stage_starts=()
stage_used=()

# Sets `used` to the hundredths of a processor second so far, nought where there is no /proc. Not by way of $(...): that
# would be another process.
count_processors() {
  local line fields
  used=0
  if [[ ! -r /proc/$$/stat ]]; then return; fi
  read -r line <"/proc/$$/stat"
  # After the command's name, which may hold anything: user and system time of the script, then of what it waited for.
  read -r -a fields <<<"${line##*) }"
  used=$(((fields[11] + fields[12] + fields[13] + fields[14]) * 100 / $(getconf CLK_TCK)))
}

mark_time() {
  local used
  count_processors
  stage_starts+=("$SECONDS")
  stage_used+=("$used")
}

stage() {
  stage_names+=("$1")
  mark_time
  printf '\n==> %s\n' "$1"
}

print_stages() {
  local i
  mark_time
  printf '\n%-16s %8s %12s\n' stage seconds 'CPU seconds'
  for i in "${!stage_names[@]}"; do
    print_stage "${stage_names[i]}" "$i" $((i + 1))
  done
  print_stage total 0 ${#stage_names[@]}
}

# print_stage <name> <index of its start> <index of its end>
print_stage() {
  local used=$((stage_used[$3] - stage_used[$2]))
  printf '%-16s %8d %10d.%d\n' "$1" $((stage_starts[$3] - stage_starts[$2])) $((used / 100)) $((used % 100 / 10))
}
