// A run that goes on from a checkpoint, in bytes, with the same bits as one that was never cut.

#include <string>
#include <vector>

#include <fmt/format.h>

#include <harness/case.hpp>
#include <harness/motions.hpp>
#include <particulate/contact/friction.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/scenes/checkpoint.hpp>
#include <particulate/scenes/history.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/legs.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/verlet.hpp>

#include "clouds.hpp"

namespace verification::continued_clouds {

using namespace particulate;

constexpr double leg = 0.1, t_end = 0.4;
constexpr Eigen::Index N = 150;

// What a run leaves: a checkpoint at the end of each leg.
struct Left {
  std::vector<std::string> marks;
  schemes::Outcome outcome;
};

// From the start, or from a mark: a scene, a scheme and a control of its own, which know nothing of the other's lists.
template <class Law, class S, class C>
Left go(const Law& law, S scheme, C control, const std::string& mark = {}) {
  const laws::NearField field{.alpha1 = 0.1, .alpha2 = 0.01, .cutoff = 0.3, .taper = 0.1};
  const kinematics::Space periods{.lengths = Eigen::Vector3d::Ones()};
  scenes::Scene scene(book_cloud(N, 1, periods), periods, field, law);
  scenes::History history(scene, schemes::multiples(0.013, 0.0, t_end));
  schemes::State state = scenes::start(scene);
  Left left;
  if (!mark.empty()) {
    const scenes::Checkpoint from = scenes::checkpoint_from(mark, "mark", "cloud", N);
    state = from.state;
    control.step = from.step;
    left.outcome = from.outcome;
    history.remember(from.more.at("history"));
  }
  const auto save = [&](const schemes::State& at, const C& now, const schemes::Outcome& so_far) {
    left.marks.push_back(scenes::to_bytes(
        {.scene = "cloud", .state = at, .step = now.step, .outcome = so_far, .more = {{"history", history.memory()}}}));
  };
  left.outcome = schemes::integrate_in_legs(scene, state, t_end, scheme, control, leg, save, history, left.outcome);
  require_reached(left.outcome);
  return left;
}

template <class Law, class S, class C>
void compare(Rows& rows, const char* name, const Law& law, const S& scheme, const C& control) {
  const Left whole = go(law, scheme, control);
  rows.equal(fmt::format("legs, {}", name),
             {.expected = 4, .computed = whole.marks.size(), .because = "the last ends with the run"});
  rows.at_least(fmt::format("impacts, {}", name), {.limit = 20.0,
                                                   .computed = static_cast<double>(whole.outcome.impacts),
                                                   .because = "else little could go astray"});
  for (const std::size_t mark : {0U, 2U}) {
    const Left rest = go(law, scheme, control, whole.marks[mark]);
    rows.none(fmt::format("bytes that differ at the end, from leg {}, {}", mark, name),
              static_cast<long>(rest.marks.back() != whole.marks.back()),
              "state, time, step, counts and every row of the history; the lists of the two runs are not of one age");
  }
}

const Case from_bytes{
    {.name = "clouds_continued",
     .claim =
         "a cloud that goes on from the bytes of a checkpoint ends with the same bits, whatever the age of its lists",
     .equation = "R 4.2",
     .reference = Reference::identity},
    [](Rows& rows) {
      const contact::Friction friction{.mu_s = 0.2, .mu_d = 0.1};
      const contact::Contact<contact::Restitution, contact::Friction> stepped{
          .restitution = {.e_o = 0.5, .v_star = 10.0, .e_minus = 0.1}, .friction = friction, .gamma = 0.01};
      const contact::LocatedContact<contact::Restitution, contact::Friction> located{.restitution = stepped.restitution,
                                                                                     .friction = friction};
      compare(rows, "Verlet, stepped", stepped, schemes::VelocityVerlet(), schemes::FixedStep{.step = 0.003});
      compare(rows, "backward Euler, stepped", stepped, schemes::BackwardEuler(),
              schemes::PhiControl{.TOL = 1e-6, .K_d = 10, .limit = 0.01});
      compare(rows, "Gauss 4, located", located, schemes::Collocation<schemes::Gauss<4>>(),
              schemes::ErrorControl{.TOL = 1e-8, .sweep_TOL = 1e-9, .limit = 0.05});
    }};

}  // namespace verification::continued_clouds
