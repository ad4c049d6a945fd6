//! @page ch04_shared Chapter 4: What its pages share
//! @brief The parameters of the chapter, its cloud, and a journal of runs that can be cut short and go on.
//! @tableofcontents
//!
//! @section ch04_parameters Parameters
//!
//! Values marked 4.1 are those of the monograph's simulations, as far as they are known.

#pragma once

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <particulate/contact/friction.hpp>
#include <particulate/contact/restitution.hpp>
#include <particulate/kinematics/particles.hpp>
#include <particulate/laws/near_field.hpp>
#include <particulate/report/chapter.hpp>
#include <particulate/scenes/checkpoint.hpp>
#include <particulate/schemes/outcome.hpp>

namespace ch04 {

using namespace particulate;

using report::between;
inline constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  int& particles =
      line.field(1000, {"particles", "spheres, a fifth of them with --quick", "-", between(50, 2000), "4.1"});
  double& L = line.field(0.25, {"length_ratio", "L, the length ratio b/V^(1/3)", "-", between(0.05, 0.4), "4.1"});
  double& density = line.field(2000.0, {"density", "of the spheres", "kg/m^3", between(1.0, 1e5), "4.1"});
  double& e_o = line.field(0.5, {"e_o", "restitution of a slow impact", "-", between(0.1, 1.0), "4.1"});
  double& mu_s = line.field(0.2, {"mu_s", "static friction, at least mu_d", "-", between(0.0, 1.0), "4.1"});
  double& mu_d = line.field(0.1, {"mu_d", "dynamic friction", "-", between(0.0, 1.0), "4.1"});
  double& TOL = line.field(1e-6, {"tolerance", "of the sweeps, TOL", "-", between(1e-12, 1e-3), "4.1"});
  int& K_d = line.field(10, {"desired", "contractions a step should take, K_d", "-", between(3, 50), "4.1"});
  double& limit = line.field(0.01, {"limit", "Dt_lim, the longest step", "s", between(1e-3, 0.05), "4.1"});
  double& accuracy = line.field(1e-8, {"accuracy", "of a step with located contacts, for truncation and sweeps", "-",
                                       between(1e-12, 1e-4), ours});
  double& duration = line.field(1.0, {"duration", "of the motion", "s", between(0.1, 2.0), "4.1"});
  int& watched =
      line.field(2, {"watched", "case that is drawn and gives the snapshots, 1 to 4", "-", between(1, 4), ours});
  int& gas_side = line.field(16, {"gas_side", "spheres along an edge of a gas", "-", between(8, 30), ours});
  double& gas_fraction =
      line.field(0.1, {"gas_fraction", "of its volume that a gas fills", "-", between(0.01, 0.3), ours});
  int& picture_side = line.field(47, {"picture_side", "the same of the gas that is drawn", "-", between(8, 60), ours});
  double& picture_e = line.field(0.4, {"picture_e", "its restitution", "-", between(0.3, 0.95), ours});
  double& picture_impacts =
      line.field(25.0, {"picture_impacts", "of each of its spheres, by theory", "-", between(1.0, 60.0), ours});
  double& checkpoint =
      line.field(0.0, {"checkpoint", "a run can go on from every so many seconds of its motion; 0: it cannot", "s",
                       between(0.0, 100.0), ours});
  std::string& restart = line.field("", {"restart", "a file checkpoint.bin to go on from; empty: from the start"});
  std::string& snapshots =
      line.field("", {"snapshots", "times with blanks between them, for OVITO and ParaView; empty: none", "s"});
  mutable std::string bytes = {};  // of the file to go on from
};

//! What a run can go on from is read before anything is written, in a folder that may be the same:

void validate(const Parameters& p);

contact::Restitution restitution_of(const Parameters& p);
contact::Friction friction_of(const Parameters& p);
std::vector<double> snapshot_times(const Parameters& p);
std::vector<double> picture_times(const Parameters& p);

//! @section ch04_cases Four near fields, and three ways to follow them

struct Strength {
  const char* name;
  double alpha1, alpha2;
};

inline constexpr std::array<Strength, 4> near_fields{
    {{"(1) none", 0.0, 0.0}, {"(2) weak", 0.1, 0.05}, {"(3) medium", 0.25, 0.125}, {"(4) strong", 0.5, 0.25}}};

//! The monograph's own way is backward Euler, whose step the sweeps choose below a limit. Beside it we follow the same
//! cloud by velocity Verlet, with steps of the length of the limit. Both see a contact at the end of a step. The third
//! way is collocation at four Gauss nodes, which ends a step where a contact happens.

enum class Way { backward_euler, verlet, located };
inline constexpr std::array<const char*, 3> ways{"backward Euler", "Verlet", "located Gauss"};

struct Run {
  std::size_t near_field;  // which of the four
  Way way;
  double limit;  // the longest step; of located contacts none [s]
  bool operator==(const Run&) const = default;
};

struct Followed {
  Run run;
  std::vector<std::string> columns = {};  // of its history
  Eigen::MatrixXd history = {};
  schemes::Outcome outcome = {};
  double column(const std::string& name, Eigen::Index row) const;
  double last(const std::string& name) const { return column(name, history.rows() - 1); }
};

//! @section ch04_keeping A journal
//!
//! All runs of the program are kept in a journal. With `--checkpoint` it is saved whenever one of them has gone on by
//! so many seconds of its motion, complete: what has been followed so far, and where the present run is. Then
//! `--restart` goes on from there, and ends with the same bits.

struct Moment {
  double t;
  Eigen::VectorXd r, v;
};

class Journal {
 public:
  Journal(const Parameters& p, const report::Chapter& chapter, const kinematics::Particles& cloud);

  // Follows the cloud, or knows from a checkpoint what came of it.
  const Followed& follow(const Run& run);

  const kinematics::Particles& cloud() const { return cloud_; }
  // Of the run that is watched: at the times of pictures and snapshots.
  const std::vector<Moment>& moments() const { return moments_; }

 private:
  template <class Contact>
  void set_out(const Contact& contact, Followed& into);
  template <class Scene>
  void choose(const Scene& scene, Followed& into);
  template <class Scene, class Scheme, class Control>
  void go(const Scene& scene, Scheme scheme, Control control, Followed& into);
  bool is_watched(const Run& run) const;
  void restore_moments();
  void keep(const std::string& now, std::vector<double> memory, scenes::Checkpoint checkpoint) const;

  const Parameters& p_;
  const report::Chapter& chapter_;
  const kinematics::Particles& cloud_;
  std::string of_;  // what all runs are made of
  std::optional<scenes::Checkpoint> from_;
  std::map<std::string, std::vector<double>> done_;  // for the next checkpoint
  std::deque<Followed> followed_;
  std::vector<Moment> moments_;
};

//! A page is a function of the journal. It writes its tables and adds what it claims.

void clouds(const Parameters& p, Journal& journal, const report::Output& output, report::Checks& checks);
void steps(const Parameters& p, Journal& journal, report::Chapter& chapter, report::Checks& checks);
void gas(const Parameters& p, report::Chapter& chapter, report::Checks& checks);

}  // namespace ch04
