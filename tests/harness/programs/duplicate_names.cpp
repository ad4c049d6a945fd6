// Two cases of one name, both true: the program must not run.

#include <harness/case.hpp>

namespace {

using namespace verification;

void hold(Rows& rows) { rows.equal("x", {.expected = 1, .computed = 1, .because = "b"}); }

const Case first{{.name = "twin", .claim = "one is one", .equation = "M 1.1"}, hold};
const Case second{{.name = "twin", .claim = "one is one", .equation = "M 1.1"}, hold};

}  // namespace
