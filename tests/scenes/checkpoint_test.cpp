#include <particulate/scenes/checkpoint.hpp>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <boost/random/mersenne_twister.hpp>

#include <particulate/contact/contact.hpp>
#include <particulate/contact/friction.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/scenes/history.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/euler.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/fixed_sweeps.hpp>
#include <particulate/schemes/legs.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/runge_kutta.hpp>
#include <particulate/schemes/symplectic_euler.hpp>
#include <particulate/schemes/verlet.hpp>
#include <particulate/thermo/cooling.hpp>
#include <particulate/thermo/impact_heat.hpp>

#include "close.hpp"

namespace tests::checkpoint_test {

using namespace particulate::contact;
using namespace particulate::kinematics;
using namespace particulate::laws;
using namespace particulate::scenes;
using namespace particulate::schemes;
using particulate::thermo::Cooling;
using particulate::thermo::ImpactHeat;

// Eight spheres at the corners of a cube, each on its way to the middle and past it, which takes a second: they hit
// each other in every leg.
Particles implosion() {
  std::vector<Particle> list;
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d corner((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2 & 1) - 0.5);
    const Eigen::Vector3d askew(0.1 * k, 0.3 - 0.05 * k, 0.02 * k * k);
    list.push_back({.position = 0.5 * corner, .velocity = askew - 1.5 * corner, .mass = 1.0 + 0.1 * k, .radius = 0.1});
  }
  return particles(list);
}

const NearField field{.alpha1 = 0.05, .alpha2 = 0.02};
const Friction friction{.mu_s = 0.2, .mu_d = 0.1};

// A scene as the runs below see it.
struct Cloud {
  Problem problem;
  State at_start;
  std::function<History()> history;
};
template <class S>
Cloud cloud_of(const S& scene) {
  return {scene, start(scene), [&scene] { return History(scene, multiples(0.07, 0.0, 1.0)); }};
}

constexpr double period = 0.2, t_end = 1.0;
const std::string made_of = "[cloud]\nrestitution = 0.5\nradius = 0.1\n";

// What a run leaves: at the ends of its legs, and at its end.
struct Left {
  std::vector<std::string> marks;
  std::string end;
  Outcome outcome;
};

// An observer that draws random numbers, one a step, and has a history.
struct Drawing {
  History& history;
  std::mt19937_64& engine;
  template <class S>
  bool operator()(const State& from, const State& to, double dt, const S& scheme) {
    (void)engine();
    return history(from, to, dt, scheme);
  }
  void jumped(const State& after, const Jump& jump) { history.jumped(after, jump); }
};

// A run on its way. What makes its steps is all that has a type of its own.
struct Run {
  Problem problem;
  State state;
  Drawing observer;
  std::function<void(const State&, double step, const Outcome&)> save = {};
  double step = 0.0;  // of the control; 0: its own
  Outcome outcome = {};
};
using Advance = std::function<void(Run&)>;

// With a scheme and a control that know nothing.
template <class S, class C>
Advance by(const S& scheme, const C& control) {
  return [scheme, control](Run& run) {
    S fresh = scheme;
    C its = control;
    if (run.step > 0.0) its.step = run.step;
    const auto save = [&](const State& at, const C& now, const Outcome& done) { run.save(at, now.step, done); };
    run.outcome = integrate_in_legs(run.problem, run.state, t_end, fresh, its, period, save, run.observer, run.outcome);
    run.step = its.step;
  };
}

// From the start, or from a mark.
Left go(const Cloud& cloud, const Advance& advance, const std::string& mark = "") {
  History history = cloud.history();
  std::mt19937_64 engine(5);
  Run run{.problem = cloud.problem, .state = cloud.at_start, .observer = {history, engine}};
  if (!mark.empty()) {
    const Checkpoint from = checkpoint_from(mark, "mark", made_of, 8);
    run.state = from.state;
    run.step = from.step;
    run.outcome = from.outcome;
    set_engine(from.engine, engine);
    history.remember(from.more.at("history"));
  }
  const auto bytes = [&](const State& at, double step, const Outcome& done) {
    return to_bytes({.scene = made_of,
                     .state = at,
                     .step = step,
                     .engine = text_of(engine),
                     .outcome = done,
                     .more = {{"history", history.memory()}}});
  };
  Left left;
  run.save = [&](const State& at, double step, const Outcome& done) { left.marks.push_back(bytes(at, step, done)); };
  advance(run);
  left.end = bytes(run.state, run.step, run.outcome);
  left.outcome = run.outcome;
  return left;
}

void same_bits(const Cloud& cloud, const std::string& which, const Advance& advance) {
  const Left whole = go(cloud, advance);
  BOOST_TEST_INFO_SCOPE(which << ": " << describe(whole.outcome));
  BOOST_TEST((whole.outcome.status == Status::reached));
  BOOST_TEST_REQUIRE(whole.marks.size() == 5U);
  BOOST_TEST(whole.outcome.impacts > 3);
  const Left rest = go(cloud, advance, whole.marks[2]);
  BOOST_TEST((rest.end == whole.end));
  BOOST_TEST(rest.marks.size() == 2U);
  BOOST_TEST((rest.marks.front() == whole.marks[3]));
}

template <class S>
void same_bits(const Cloud& cloud, const std::string& which, const S& scheme) {
  if constexpr (Iterative<S>) {
    same_bits(cloud, which + ", fixed step", by(scheme, FixedStep{.step = 0.019, .TOL = 1e-8}));
    same_bits(cloud, which + ", Phi_K", by(scheme, PhiControl{.TOL = 1e-8, .K_d = 5, .limit = 0.02}));
  } else {
    same_bits(cloud, which + ", fixed step", by(scheme, FixedStep{.step = 0.019}));
  }
  if constexpr (EstimatesTruncation<S>) {
    same_bits(cloud, which + ", error control",
              by(scheme, ErrorControl{.TOL = 1e-5, .sweep_TOL = 1e-7, .limit = 0.04}));
  }
}

void same_bits(const Cloud& cloud) {
  same_bits(cloud, "forward Euler", ForwardEuler());
  same_bits(cloud, "Verlet", VelocityVerlet());
  same_bits(cloud, "RK4", RungeKutta4());
  same_bits(cloud, "backward Euler", BackwardEuler());
  same_bits(cloud, "trapezoidal, Anderson", PhiFamily<Anderson>(0.5));
  same_bits(cloud, "Gauss 4", Collocation<Gauss<4>>());
  same_bits(cloud, "Radau 2, compensated, Picard", Collocation<Radau<2>, Picard>({.compensated = true}));
  same_bits(cloud, "Gauss 4, Anderson", Collocation<Gauss<4>, Anderson>());
  same_bits(cloud, "sweeps that are cut off", by(Collocation<Gauss<2>>(), FixedSweeps{.step = 0.019}));
}

BOOST_AUTO_TEST_SUITE(run_that_goes_on)

BOOST_AUTO_TEST_CASE(has_the_same_bits_with_stepped_contacts) {
  const Scene scene(
      implosion(), Space{}, field,
      Contact<Restitution, Friction>{
          .restitution = {.e_o = 0.5, .v_star = 10.0, .e_minus = 0.1}, .friction = friction, .gamma = 0.01});
  same_bits(cloud_of(scene));
}

// Temperatures that impacts raise and surroundings lower: by every kind of scheme that carries their rate, and by
// Verlet where impacts alone change them.
BOOST_AUTO_TEST_CASE(has_the_same_bits_with_heat) {
  Particles warm = implosion();
  warm.temperature = Eigen::VectorXd::LinSpaced(8, 300.0, 400.0);
  warm.heat_capacity = Eigen::VectorXd::Constant(8, 0.01);
  const Contact<ConstantRestitution, Friction> hits{.restitution = {0.5}, .friction = friction};
  const ImpactHeat heat{.kappa = 0.1, .J_star = 0.1};
  same_bits(cloud_of(Scene(warm, Space{}, hits, heat)), "heat of impacts", VelocityVerlet());
  const Scene scene(warm, Space{}, hits, heat, Cooling{.h_c = 0.1});
  const Cloud cloud = cloud_of(scene);
  same_bits(cloud, "symplectic Euler", SymplecticEuler());
  same_bits(cloud, "RK4", RungeKutta4());
  same_bits(cloud, "trapezoidal", PhiFamily(0.5));
  same_bits(cloud, "Gauss 3", Collocation<Gauss<3>>());
  same_bits(cloud, "Radau 3", Collocation<Radau<3>>());
}

BOOST_AUTO_TEST_CASE(has_the_same_bits_with_located_contacts) {
  const Scene scene(implosion(), Space{}, field,
                    LocatedContact<ConstantRestitution, Friction>{.restitution = {0.8}, .friction = friction});
  same_bits(cloud_of(scene));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(checkpoint_from_)

Checkpoint small() {
  return {.scene = made_of,
          .state = {.t = 0.1,
                    .r = Eigen::Vector3d(1.0, -0.0, 0x1.fffffffffffffp-3),
                    .v = Eigen::Vector3d(1e-310, 1e300, 0.1),
                    .y = Eigen::VectorXd::Constant(1, 300.0),
                    .t_carry = 1e-18},
          .step = 0.01,
          .engine = "5 6\n7",
          .outcome = {.t = 0.1,
                      .steps = 1,
                      .rejections = 2,
                      .sweeps = 3,
                      .evaluations = 4'000'000'000'000,
                      .impacts = 5,
                      .contraction = 0.5,
                      .overlap = 0.25,
                      .overlap_at_start = 0.125,
                      .penetration = 0.25,
                      .travel = 2.0,
                      .energy_change = -1.0,
                      .heat = 1.5,
                      .released = 0.5,
                      .jumps_by_law = {{.impacts = 3, .energy_change = -2.0}, {.impacts = 2, .energy_change = 1.0}},
                      .ruled = "spring"},
          .more = {{"empty", {}}, {"rows", {1.0, 2.0, not_a_number}}}};
}

Checkpoint back(std::string_view bytes, std::string_view scene = made_of, Eigen::Index N = 1) {
  return checkpoint_from(bytes, "old.checkpoint", scene, N);
}

// Every number of it: the same bytes are written again.
BOOST_AUTO_TEST_CASE(gives_back_every_bit) {
  const std::string bytes = to_bytes(small());
  const Checkpoint again = back(bytes);
  BOOST_TEST((to_bytes(again) == bytes));
  BOOST_TEST(again.state.t == 0.1);
  BOOST_TEST(again.state.t_carry == 1e-18);
  BOOST_TEST(again.state.r == small().state.r);
  BOOST_TEST(std::signbit(again.state.r[1]));
  BOOST_TEST(again.state.v == small().state.v);
  BOOST_TEST(again.state.y == small().state.y);
  BOOST_TEST(again.step == 0.01);
  BOOST_TEST(again.engine == "5 6\n7");
  BOOST_TEST(describe(again.outcome) == describe(small().outcome));
  BOOST_TEST(again.outcome.jumps_by_law[1].energy_change == 1.0);
  BOOST_TEST(again.more.at("empty").empty());
  BOOST_TEST(again.more.at("rows")[1] == 2.0);
}

BOOST_AUTO_TEST_CASE(holds_a_scene_of_nothing) {
  const std::string bytes = to_bytes({});
  BOOST_TEST((to_bytes(back(bytes, "", 0)) == bytes));
}

#define CHECK_DAMAGED(expression, words) \
  BOOST_CHECK_EXCEPTION((void)(expression), std::runtime_error, ::tests::says(words))

BOOST_AUTO_TEST_CASE(refuses_a_file_cut_short_anywhere) {
  const std::string bytes = to_bytes(small());
  const std::size_t line = bytes.find('\n');
  for (std::size_t length = line + 1; length < bytes.size(); ++length) {
    CHECK_DAMAGED(
        back(std::string_view(bytes).substr(0, length)),
        "old.checkpoint: must end with a line with its checksum, and does not: it was cut short; take the one "
        "before, or start anew");
  }
  for (std::size_t length = 0; length <= line; ++length) {
    CHECK_DAMAGED(back(std::string_view(bytes).substr(0, length)), "old.checkpoint: must ");
  }
}

// Each byte, each changed by one bit: whatever is said, nothing is read.
BOOST_AUTO_TEST_CASE(refuses_a_file_of_which_any_byte_was_altered) {
  const std::string bytes = to_bytes(small());
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    std::string other = bytes;
    other[k] = static_cast<char>(other[k] ^ (1 << k % 8));
    CHECK_DAMAGED(back(other), "old.checkpoint: must ");
  }
  std::string other = bytes;
  other[bytes.find("spring")] = 'S';
  CHECK_DAMAGED(back(other), "it was altered; take another one, or start anew");
  CHECK_DAMAGED(back(bytes + "x"), "must end with a line with its checksum");
}

BOOST_AUTO_TEST_CASE(refuses_other_files_versions_and_byte_orders) {
  std::string bytes = to_bytes(small());
  CHECK_DAMAGED(back("x,y,z\n1,2,3\n"),
                "old.checkpoint: must begin with \"particulate checkpoint, version 1, little endian\", got \"x,y,z\": "
                "name a file that a run wrote as its checkpoint");
  CHECK_DAMAGED(back(""), "must begin with");
  const std::string first = bytes.substr(0, bytes.find('\n'));
  const auto with = [&](const std::string& line) { return line + bytes.substr(first.size()); };
  CHECK_DAMAGED(back(with("particulate checkpoint, version 2, little endian")),
                "must be a checkpoint of version 1, got version 2: go on with the program that wrote it");
  CHECK_DAMAGED(back(with("particulate checkpoint, version 1, big endian")),
                "must have the byte order of this machine, \"little endian\", got \"big endian\": go on where it was");
}

BOOST_AUTO_TEST_CASE(refuses_another_scene_and_says_where_it_differs) {
  const std::string bytes = to_bytes(small());
  CHECK_REFUSED(back(bytes, "[cloud]\nrestitution = 0.4\nradius = 0.1\n"),
                "old.checkpoint: must be of the same scene, got another one: line 2 of what it is made of is "
                "\"restitution = 0.5\" there and \"restitution = 0.4\" here. Give this run what that one had");
  CHECK_REFUSED(back(bytes, made_of + "more = 1\n"),
                "line 4 of what it is made of is \"\" there and \"more = 1\" here");
  CHECK_REFUSED(back(bytes, made_of, 2), "must be of 2 particles, got one of 3 numbers for places");
}

BOOST_AUTO_TEST_CASE(sets_an_engine_of_boost_to_where_another_was) {
  boost::random::mt19937_64 one(5), other;
  one.discard(1000);
  set_engine(text_of(one), other);
  BOOST_TEST(one() == other());
}

BOOST_AUTO_TEST_CASE(refuses_names_with_blanks_and_other_engines) {
  CHECK_REFUSED(to_bytes({.more = {{"two words", {}}}}), "must be words without blanks, got \"two words\": write _");
  CHECK_REFUSED(to_bytes({.more = {{"", {}}}}), "got \"\"");
  std::mt19937_64 engine;
  CHECK_REFUSED(set_engine("no engine", engine), "must be one of the type that wrote the text");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::checkpoint_test
