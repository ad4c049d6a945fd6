#include <particulate/reference/method.hpp>

#include <set>
#include <string>

#include "close.hpp"

namespace tests::method_test {

using namespace particulate::reference;

BOOST_AUTO_TEST_SUITE(table_named_)

BOOST_AUTO_TEST_CASE(finds_every_table_by_its_name_and_no_two_share_one) {
  std::set<std::string_view> names;
  for (const Table table : tables) {
    BOOST_TEST((table_named(name(table)) == table));
    names.insert(name(table));
  }
  BOOST_TEST(names.size() == 15U);
}

BOOST_AUTO_TEST_CASE(refuses_an_unknown_name_and_lists_the_known_ones) {
  CHECK_REFUSED(table_named("rk4"), "heun_euler_2_1_2, bogacki_shampine_4_2_3,");
  CHECK_REFUSED(table_named("rk4"), "; got 'rk4'");
  CHECK_REFUSED(table_named(""), "; got ''");
  CHECK_REFUSED(table_named("verner_8_5_6 "), "; got 'verner_8_5_6 '");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(order_)

// A name ends in stages, embedded order, order; knoth_wolke_3_3 in stages, order.
BOOST_AUTO_TEST_CASE(is_what_the_name_says) {
  for (const Table table : tables) {
    const std::string spelled(name(table));
    BOOST_TEST_CONTEXT(spelled) {
      const bool has_embedded = table != Table::knoth_wolke_3_3;
      BOOST_TEST(order(table) == spelled.back() - '0');
      BOOST_TEST(embedded_order(table) == (has_embedded ? spelled[spelled.size() - 3] - '0' : 0));
    }
  }
}

BOOST_AUTO_TEST_CASE(of_an_additive_pair_is_what_its_name_says_and_no_two_share_one) {
  std::set<std::string_view> names;
  for (const AdditiveTable table : additive_tables) {
    BOOST_TEST(order(table) == name(table).back() - '0', name(table));
    names.insert(name(table));
  }
  BOOST_TEST(names.size() == 5U);
  BOOST_TEST(name(AdditiveTable::ark548l2sab_8_4_5) == "ark548l2sab_8_4_5");
}

BOOST_AUTO_TEST_CASE(refuses_what_is_no_enumerator) {
  const auto none = static_cast<Table>(99);
  const auto words = "table must be one of the 15 enumerators, got number 99";
  CHECK_REFUSED(order(none), words);
  CHECK_REFUSED(embedded_order(none), words);
  CHECK_REFUSED(name(none), words);
  CHECK_REFUSED(validate(ExplicitRungeKutta{.table = none}), words);

  const auto no_pair = static_cast<AdditiveTable>(99);
  const auto other_words = "implicit-explicit Runge-Kutta: table must be one of the 5 enumerators, got number 99";
  CHECK_REFUSED(order(no_pair), other_words);
  CHECK_REFUSED(name(no_pair), other_words);
  CHECK_REFUSED(validate(ImplicitExplicit{.table = no_pair}), other_words);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(validate_)

BOOST_AUTO_TEST_CASE(accepts_the_defaults_and_the_limits) {
  BOOST_CHECK_NO_THROW(validate(Adams{}));
  BOOST_CHECK_NO_THROW(validate(Adams{.relative = 1e-16, .absolute = 1e-300, .max_order = 1, .max_steps = 1}));
  BOOST_CHECK_NO_THROW(validate(Adams{.anderson = 5, .first_step = 1e-3, .largest_step = 1e-3}));
  BOOST_CHECK_NO_THROW(validate(ExplicitRungeKutta{}));
  BOOST_CHECK_NO_THROW(validate(Bdf{}));
  BOOST_CHECK_NO_THROW(validate(Bdf{.relative = 1e-16, .absolute = 1e-300, .max_order = 1, .max_steps = 1}));
  BOOST_CHECK_NO_THROW(validate(Bdf{.jacobian = BandedJacobian{.lower = 0, .upper = 0}, .first_step = 1e-3}));
  BOOST_CHECK_NO_THROW(validate(ImplicitExplicit{}));
  BOOST_CHECK_NO_THROW(validate(ImplicitExplicit{.first_step = 1e-3, .largest_step = 1e-3}));
  BOOST_CHECK_NO_THROW(validate(ImplicitExplicit{.fixed_step = 1e-3}));
  BOOST_CHECK_NO_THROW(validate(ExplicitRungeKutta{.table = Table::knoth_wolke_3_3, .fixed_step = 1e-3}));
}

// What every method is refused for, in its own name.
template <class M>
void refuses_tolerances_and_steps(const std::string& who) {
  for (const double bad : {1e-17, 0.0, -1e-6, 1.0, infinity, not_a_number}) {
    BOOST_TEST_CONTEXT(who << ", relative = " << bad) {
      CHECK_REFUSED(validate(M{.relative = bad}), who + ": relative must lie in [1e-16, 1)");
    }
  }
  for (const double bad : {0.0, -1e-6, infinity, not_a_number}) {
    BOOST_TEST_CONTEXT(who << ", absolute or a step = " << bad) {
      CHECK_REFUSED(validate(M{.absolute = bad}), who + ": absolute must be positive and finite");
      CHECK_REFUSED(validate(M{.first_step = bad}), who + ": first_step must be positive and finite");
      CHECK_REFUSED(validate(M{.largest_step = bad}), who + ": largest_step must be positive and finite");
      if constexpr (requires(M method) { method.fixed_step; }) {
        CHECK_REFUSED(validate(M{.fixed_step = bad}), who + ": fixed_step must be positive and finite");
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(refuses_tolerances_that_cannot_be_met_and_steps_that_are_none) {
  refuses_tolerances_and_steps<Adams>("Adams");
  refuses_tolerances_and_steps<ExplicitRungeKutta>("explicit Runge-Kutta");
  refuses_tolerances_and_steps<Bdf>("BDF");
  refuses_tolerances_and_steps<ImplicitExplicit>("implicit-explicit Runge-Kutta");
  CHECK_REFUSED(validate(Adams{.relative = 1e-17}), "got 1e-17");
  CHECK_REFUSED(validate(Adams{.absolute = not_a_number}), "got nan");
}

BOOST_AUTO_TEST_CASE(refuses_settings_that_contradict_each_other) {
  CHECK_REFUSED(validate(Adams{.first_step = 2.0, .largest_step = 1.0}),
                "first_step must not exceed largest_step = 1 s, got 2 s");
  CHECK_REFUSED(validate(ExplicitRungeKutta{.first_step = 2.0, .largest_step = 1.0}),
                "first_step must not exceed largest_step = 1 s, got 2 s");
  CHECK_REFUSED(validate(ExplicitRungeKutta{.fixed_step = 0.1, .first_step = 0.1}),
                "got one of them with fixed_step = 0.1 s; leave one out");
  CHECK_REFUSED(validate(ExplicitRungeKutta{.fixed_step = 0.1, .largest_step = 0.1}),
                "got one of them with fixed_step = 0.1 s; leave one out");
  CHECK_REFUSED(validate(Bdf{.first_step = 2.0, .largest_step = 1.0}),
                "BDF: first_step must not exceed largest_step = 1 s, got 2 s");
  CHECK_REFUSED(validate(ImplicitExplicit{.first_step = 2.0, .largest_step = 1.0}),
                "first_step must not exceed largest_step = 1 s, got 2 s");
  CHECK_REFUSED(validate(ImplicitExplicit{.fixed_step = 0.1, .first_step = 0.1}),
                "implicit-explicit Runge-Kutta: first_step and largest_step are for steps that vary");
  CHECK_REFUSED(validate(ExplicitRungeKutta{.table = Table::knoth_wolke_3_3}),
                "knoth_wolke_3_3 has no embedded method to choose steps by; give a fixed_step");
}

BOOST_AUTO_TEST_CASE(refuses_numbers_out_of_range) {
  CHECK_REFUSED(validate(Adams{.max_order = 0}), "max_order must lie in 1 ... 12, got 0");
  CHECK_REFUSED(validate(Adams{.max_order = 13}), "1 ... 12, got 13");
  CHECK_REFUSED(validate(Adams{.anderson = -1}), "anderson must not be negative, got -1");
  CHECK_REFUSED(validate(Adams{.max_steps = 0}), "Adams: max_steps must be positive, got 0");
  for (const int bad : {0, 6}) {
    CHECK_REFUSED(validate(Bdf{.max_order = bad}), "BDF: max_order must lie in 1 ... 5, got " + std::to_string(bad));
  }
  CHECK_REFUSED(validate(Bdf{.jacobian = BandedJacobian{.lower = -1, .upper = 2}}),
                "BDF: half-bandwidths must not be negative, got lower -1 and upper 2");
  CHECK_REFUSED(validate(Bdf{.jacobian = BandedJacobian{.lower = 1, .upper = -2}}), "got lower 1 and upper -2");
  CHECK_REFUSED(validate(Bdf{.max_steps = 0}), "BDF: max_steps must be positive, got 0");
  CHECK_REFUSED(validate(ImplicitExplicit{.max_steps = 0}),
                "implicit-explicit Runge-Kutta: max_steps must be positive, got 0");
  CHECK_REFUSED(validate(ExplicitRungeKutta{.max_steps = -5}),
                "explicit Runge-Kutta: max_steps must be positive, got -5");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::method_test
