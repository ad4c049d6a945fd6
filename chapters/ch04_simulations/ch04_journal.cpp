//! @page ch04_journal Chapter 4: Runs that can be cut short
//! @brief A journal of runs, saved as they go on, from which a restarted program ends with the same bits.
//! @tableofcontents
//!
//! A run of hours must not be lost. What it needs to go on is little: the state with its time, the step to make next,
//! and what has been written so far. Schemes also remember the last steps, to guess the next ones; so that none of that
//! has to go to disk, scheme and control forget it wherever the run is saved, whether it is then cut short or not.
//!
//! @section ch04_journal_program The program

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <particulate/contact/contact.hpp>
#include <particulate/contact/located_contact.hpp>
#include <particulate/report/files.hpp>
#include <particulate/report/progress.hpp>
#include <particulate/scenes/history.hpp>
#include <particulate/scenes/scene.hpp>
#include <particulate/schemes/collocation.hpp>
#include <particulate/schemes/error_control.hpp>
#include <particulate/schemes/fixed_step.hpp>
#include <particulate/schemes/legs.hpp>
#include <particulate/schemes/phi_control.hpp>
#include <particulate/schemes/phi_family.hpp>
#include <particulate/schemes/sampling.hpp>
#include <particulate/schemes/verlet.hpp>

#include "ch04_simulations.hpp"

namespace ch04 {

contact::Restitution restitution_of(const Parameters& p) {
  return {.e_o = p.e_o, .v_star = 10.0, .e_minus = 0.1};  // 4.1
}

contact::Friction friction_of(const Parameters& p) { return {.mu_s = p.mu_s, .mu_d = p.mu_d}; }

void validate(const Parameters& p) {
  validate(restitution_of(p));
  validate(friction_of(p));
  snapshot_times(p);
  if (!p.restart.empty()) p.bytes = report::read_whole(p.restart);
}

std::vector<double> snapshot_times(const Parameters& p) {
  std::istringstream words(p.snapshots);
  std::vector<double> times;
  for (std::string word; words >> word;) {
    std::size_t read = 0;
    double t = -1.0;
    try {
      t = std::stod(word, &read);
    } catch (const std::exception&) {}
    if (read != word.size() || !(t >= 0.0 && t <= p.duration) || (!times.empty() && t <= times.back())) {
      throw std::invalid_argument(fmt::format(
          "--snapshots must be times from 0 to the duration, {} s, each later than the one before, got \"{}\": write "
          "them as in --snapshots \"0 0.5 1\"",
          p.duration, p.snapshots));
    }
    times.push_back(t);
  }
  return times;
}

std::vector<double> evenly(int parts, double duration) {
  std::vector<double> times;
  for (int k = 0; k <= parts; ++k) times.push_back(k * duration / parts);
  return times;
}

std::vector<double> picture_times(const Parameters& p) { return evenly(40, p.duration); }

//! What all runs are made of is the file of parameters, but for what may change from one part to the next.

std::string made_of(const Parameters& p) {
  std::istringstream lines(p.line.parameters_toml());
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    const bool may_change =
        line.empty() || line.starts_with("#") || line.starts_with("restart") || line.starts_with("threads");
    if (!may_change) kept += line.substr(0, line.find('#')) + '\n';
  }
  return kept;
}

double Followed::column(const std::string& name, Eigen::Index row) const {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].starts_with(name)) return history(row, static_cast<Eigen::Index>(k));
  }
  throw std::logic_error("a history has no column " + name);
}

//! @section ch04_journal_runs One run
//!
//! A history writes a row every hundredth of the duration; of the run that is watched, places are kept as well, for
//! pictures and snapshots. None of these cuts a step.

Journal::Journal(const Parameters& p, const report::Chapter& chapter, const kinematics::Particles& cloud)
    : p_(p), chapter_(chapter), cloud_(cloud), of_(made_of(p)) {
  if (p.restart.empty()) return;
  from_ = scenes::checkpoint_from(p.bytes, p.restart, of_, cloud.size());
  restore_moments();
}

const Followed& Journal::follow(const Run& run) {
  for (const Followed& known : followed_) {
    if (known.run == run) return known;
  }
  followed_.push_back({.run = run});
  Followed& into = followed_.back();
  const contact::Restitution restitution = restitution_of(p_);
  const contact::Friction friction = friction_of(p_);
  if (run.way == Way::located) {
    set_out(contact::LocatedContact<contact::Restitution, contact::Friction>{restitution, friction}, into);
  } else {
    set_out(contact::Contact<contact::Restitution, contact::Friction>{restitution, friction, 0.01}, into);  // 4.1
  }
  return into;
}

//! A law that a scene leaves out costs nothing, so the first case has no near field rather than one of strength zero.

template <class Contact>
void Journal::set_out(const Contact& contact, Followed& into) {
  const Strength& strength = near_fields[into.run.near_field];
  const laws::NearField near_field{.alpha1 = strength.alpha1, .alpha2 = strength.alpha2};
  if (into.run.near_field == 0) {
    choose(scenes::Scene(cloud_, kinematics::Space{}, contact), into);
  } else {
    choose(scenes::Scene(cloud_, kinematics::Space{}, near_field, contact), into);
  }
}

template <class Scene>
void Journal::choose(const Scene& scene, Followed& into) {
  if constexpr (schemes::LocatesJumps<Scene>) {
    go(scene, schemes::Collocation<schemes::Gauss<4>>(),
       schemes::ErrorControl{.TOL = p_.accuracy, .sweep_TOL = p_.accuracy}, into);
  } else if (into.run.way == Way::backward_euler) {
    go(scene, schemes::BackwardEuler(),
       schemes::PhiControl{.TOL = p_.TOL, .K_d = p_.K_d, .step = into.run.limit, .limit = into.run.limit}, into);
  } else {
    go(scene, schemes::VelocityVerlet(), schemes::FixedStep{.step = into.run.limit}, into);
  }
}

namespace {

// What a table needs of an outcome.
std::vector<double> counts_of(const schemes::Outcome& of) {
  return {static_cast<double>(of.evaluations), static_cast<double>(of.impacts), static_cast<double>(of.steps),
          of.overlap, of.energy_change};
}

schemes::Outcome outcome_of(const std::vector<double>& counts) {
  schemes::Outcome of;
  of.evaluations = static_cast<long>(counts.at(0)), of.impacts = static_cast<long>(counts.at(1));
  of.steps = static_cast<long>(counts.at(2)), of.overlap = counts.at(3), of.energy_change = counts.at(4);
  return of;
}

// Hands steps and jumps on, and shows how far the run is.
struct Shown {
  scenes::History& history;
  report::Progress& progress;
  template <class S>
  bool operator()(const schemes::State& from, const schemes::State& to, double dt, const S& scheme) {
    progress.at(to.t);
    return history(from, to, dt, scheme);
  }
  void jumped(const schemes::State& after, const schemes::Jump& jump) { history.jumped(after, jump); }
};

}  // namespace

template <class Scene, class Scheme, class Control>
void Journal::go(const Scene& scene, Scheme scheme, Control control, Followed& into) {
  const std::string number = std::to_string(followed_.size());
  scenes::History history(scene, evenly(100, p_.duration));
  const auto known = [&](const std::string& name) { return from_ && from_->more.contains(name + number); };
  if (known("done")) {
    history.remember(from_->more.at("done" + number));
    into.outcome = outcome_of(from_->more.at("counts" + number));
  } else {
    schemes::State state = scenes::start(scene);
    if (known("now")) {
      state = from_->state, control.step = from_->step, into.outcome = from_->outcome;
      history.remember(from_->more.at("now" + number));
    }
    report::Progress progress(
        fmt::format("{}, {}", near_fields[into.run.near_field].name, ways[static_cast<std::size_t>(into.run.way)]),
        p_.duration);
    Shown shown{history, progress};
    const auto save = [&](const schemes::State& at, const Control& now, const schemes::Outcome& so_far) {
      keep(number, history.memory(), {.scene = of_, .state = at, .step = now.step, .outcome = so_far});
    };
    const auto run = [&](auto&& observer) {
      return p_.checkpoint > 0.0 ? schemes::integrate_in_legs(scene, state, p_.duration, scheme, control, p_.checkpoint,
                                                              save, observer, into.outcome)
                                 : schemes::integrate(scene, state, p_.duration, scheme, control, observer);
    };
    if (is_watched(into.run)) {
      std::vector<double> times;  // still to come
      const std::vector<double> pictures = picture_times(p_), snapshots = snapshot_times(p_);
      std::set_union(pictures.begin(), pictures.end(), snapshots.begin(), snapshots.end(), std::back_inserter(times));
      if (known("now")) std::erase_if(times, [&](double t) { return t <= state.t; });
      const auto receive = [&](const schemes::State& at) { moments_.push_back({at.t, at.r, at.v}); };
      into.outcome = run(schemes::Sampling(times, receive, shown));
    } else {
      into.outcome = run(shown);
    }
    if (into.outcome.status != schemes::Status::reached) throw std::runtime_error(describe(into.outcome));
  }
  done_["done" + number] = history.memory();
  done_["counts" + number] = counts_of(into.outcome);
  into.columns = history.columns();
  into.history = history.rows();
}

//! @section ch04_journal_file What is saved
//!
//! A checkpoint is one file, which is replaced whole. It holds the runs that are over, the one that is not, and the
//! places of the run that is watched.

bool Journal::is_watched(const Run& run) const {
  return run.way == Way::located && run.near_field + 1 == static_cast<std::size_t>(p_.watched);
}

void Journal::keep(const std::string& now, std::vector<double> memory, scenes::Checkpoint checkpoint) const {
  checkpoint.more = done_;
  checkpoint.more["now" + now] = std::move(memory);
  std::vector<double>& moments = checkpoint.more["moments"];
  for (const Moment& at : moments_) {
    moments.push_back(at.t);
    moments.insert(moments.end(), at.r.begin(), at.r.end());
    moments.insert(moments.end(), at.v.begin(), at.v.end());
  }
  report::write_whole(chapter_.output().folder() / "checkpoint.bin", scenes::to_bytes(checkpoint));
}

void Journal::restore_moments() {
  const std::vector<double>& all = from_->more.at("moments");
  const Eigen::Index length = 3 * cloud_.size();
  for (std::size_t at = 0; at < all.size(); at += static_cast<std::size_t>(1 + 2 * length)) {
    const double* const numbers = all.data() + at;
    moments_.push_back({numbers[0], Eigen::Map<const Eigen::VectorXd>(numbers + 1, length),
                        Eigen::Map<const Eigen::VectorXd>(numbers + 1 + length, length)});
  }
}

}  // namespace ch04
