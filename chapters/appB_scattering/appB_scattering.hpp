//! @page appB_shared Appendix B: What its pages share
//! @brief The parameters of the appendix, its blood cells and their beam.
//! @tableofcontents
//!
//! @section appB_parameters Parameters
//!
//! Captions of the monograph tell the number of rays, \f$ \hat n \f$ and the largest number of cells. The box, and with
//! it how dense cells are, is our choice.

#pragma once

#include <cstdint>
#include <functional>

#include <particulate/report/chapter.hpp>
#include <particulate/report/spread.hpp>
#include <particulate/scattering/beam.hpp>
#include <particulate/scattering/placement.hpp>
#include <particulate/scattering/trace.hpp>

namespace appB {

using namespace particulate;
using namespace particulate::scattering;
using kinematics::uniform_from;

using report::between;
inline constexpr const char* ours = "our choice";

struct Parameters {
  report::CommandLine& line;
  int& cells =
      line.field(8000, {"cells", "the largest of four numbers of blood cells", "-", between(4000, 8000), "B.6"});
  int& rays = line.field(1000, {"rays", "of a beam", "-", between(500, 4000), "B.5"});
  double& n_hat = line.field(
      1.075, {"n_hat", "ratio of refractive indices of cells and plasma, n^", "-", between(1.01, 1.5), "B.5"});
  double& edge = line.field(360e-6, {"edge", "of the cube with the cells", "m", between(340e-6, 500e-6), ours});
  int& realizations = line.field(40, {"realizations", "clouds that an answer is averaged over, a quarter with --quick",
                                      "-", between(32, 80), ours});
};

//! @section appB_beam Cells and their beam
//!
//! As in @ref ch09_beam "chapter 9": cells wholly within a cube, a square beam of half its edge.

inline kinematics::Box box_of(const Parameters& p) { return {.lengths = Eigen::Vector3d::Constant(p.edge)}; }
inline Beam beam_of(const Parameters& p) {
  return {.centre = {0.0, 0.5 * p.edge, 0.5 * p.edge}, .width = 0.5 * p.edge};
}
inline Cloud<RedCell> cells_in(const Parameters& p, Eigen::Index n, const std::function<double()>& uniform) {
  return {place_red_cells(n, {}, {.box = box_of(p), .inside = kinematics::Inside::spheres}, uniform).bodies, box_of(p)};
}

//! A page is a function. It writes its tables and adds what it claims.

void reflectances(report::Chapter& chapter);
void cells(const Parameters& p, report::Chapter& chapter);
void sound(report::Chapter& chapter);

}  // namespace appB
