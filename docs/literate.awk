#!/usr/bin/awk -f
# Literate C++ -> one Doxygen comment, line for line, so that Doxygen's warnings name the right lines.
# Lines whose first ink is "//!" are prose; anything else is program text. Where the two meet there must be a blank
# line: it becomes the fence. Inside a listing blank lines are kept. @verbatim would keep the //! of its lines, so it is
# turned into a listing without colours. A listing that begins with #include is folded down to its first other line. At
# the end stands what comes next, which chapters.awk gathered. Exit status 2: a file that is no chapter; Doxygen would not notice, a test does.

function stop(what) { print FILENAME ":" FNR ": literate: " what > "/dev/stderr"; bad = 1; exit 2 }
function keep()     { if (held) print "//!"; held = 0 }
function html(text) { return " @htmlonly[block]" text "@endhtmlonly" }
function close_listing() { print "//! @endcode" (folded ? html("</details>") : ""); folded = 0 }

/^[ \t]*\/\/!/ {
  if (incode) {
    if (!held) stop("blank line needed before prose")
    close_listing()
    incode = held = 0
  } else keep()
  sub(/^[ \t]+/, "")
  sub(/[@\\]verbatim/, "@code{.unparsed}")
  sub(/[@\\]endverbatim/, "@endcode")
  if (/[@\\]page /) { ++pages; page = $3 }
  print
  next
}

/^[ \t]*$/ { keep(); held = 1; next }

{
  if (incode && folded && held && !/^#/) {
    print "//! @endcode" html("</details>") " @code{.cpp}"
    folded = held = 0
  }
  if (incode) keep()
  else {
    if (!held) stop("blank line needed before code")
    folded = /^#(include|pragma once)/
    print "//!" (folded ? html("<details><summary>What it includes</summary>") : "") " @code{.cpp}"
    incode = 1
    held = 0
  }
  if (/@endcode|\\endcode/) stop("a listing cannot hold the command that ends it")
  print "//! " $0
}

END {
  if (!bad) {
    if (incode) close_listing()
    else keep()
    if (!pages) stop("no @page: a chapter names its page in its first line")
    print "//!\n//! @htmlinclude " page "_onward.html"
  }
  exit bad ? 2 : 0
}
