#!/bin/sh
# check_readme.sh <README.md> <program.cpp>
# Fails unless the C++ listing of the page is the program, line for line.
set -eu
awk '/^```/ { on = !on && $0 == "```cpp"; next } on' "$1" | diff - "$2" || {
  echo "check_readme.sh: the C++ listing in $1 must be $2, line for line; copy the program into it" >&2
  exit 1
}
