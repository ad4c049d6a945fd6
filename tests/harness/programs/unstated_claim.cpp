// A case that does not say what it claims: the program must not run.

#include <harness/case.hpp>

namespace {

using namespace verification;

const Case silent{{.name = "silent", .claim = " ", .equation = "M 1.1"},
                  [](Rows& rows) { rows.equal("x", {.expected = 1, .computed = 1, .because = "b"}); }};

}  // namespace
