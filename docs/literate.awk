#!/usr/bin/awk -f
# Literate C++ -> one Doxygen comment, line for line, so that Doxygen's warnings name the right lines.
# Lines whose first ink is "//!" are prose; anything else is program text. Where the two meet there must be a blank
# line: it becomes the fence. Inside a listing blank lines are kept. @verbatim would keep the //! of its lines, so it is
# turned into a listing without colours. Exit status 2: a file that is no chapter; Doxygen would not notice, a test does.

function stop(what) { print FILENAME ":" FNR ": literate: " what > "/dev/stderr"; bad = 1; exit 2 }
function keep()     { if (held) print "//!"; held = 0 }

/^[ \t]*\/\/!/ {
  if (incode) {
    if (!held) stop("blank line needed before prose")
    print "//! @endcode"
    incode = held = 0
  } else keep()
  sub(/^[ \t]+/, "")
  sub(/[@\\]verbatim/, "@code{.unparsed}")
  sub(/[@\\]endverbatim/, "@endcode")
  if (/[@\\]page /) ++pages
  print
  next
}

/^[ \t]*$/ { keep(); held = 1; next }

{
  if (incode) keep()
  else {
    if (!held) stop("blank line needed before code")
    print "//! @code{.cpp}"
    incode = 1
    held = 0
  }
  if (/@endcode|\\endcode/) stop("a listing cannot hold the command that ends it")
  print "//! " $0
}

END {
  if (!bad) {
    if (incode) print "//! @endcode"
    else keep()
    if (!pages) stop("no @page: a chapter names its page in its first line")
  }
  exit bad ? 2 : 0
}
