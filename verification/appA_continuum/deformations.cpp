// Deformation: a flow whose motion is known, and bodies with corners whose areas and volumes are counted anew.

#include <cmath>

#include <Eigen/Geometry>

#include <harness/case.hpp>
#include <harness/uniform.hpp>
#include <particulate/continuum/deformation.hpp>

#include "complex_step.hpp"

namespace verification::continuum_deformations {

using namespace particulate::continuum;

// In axes turned by Q the velocity is (y0^2, -y0 y1, y0 y2), which takes Y to (Y0/s, Y1 s, Y2/s), s = 1 - t Y0. Volumes
// grow as J = 1/s^2, at the rate div v = 2 y0.
const Tensor<double> Q = rotation(0.7);

Vector<Complex> turned(const Tensor<double>& by, const Vector<Complex>& x) { return by.cast<Complex>() * x; }

Vector<Complex> velocity(const Vector<Complex>& x) {
  const Vector<Complex> y = turned(Q.transpose(), x);
  return turned(Q, {y[0] * y[0], -y[0] * y[1], y[0] * y[2]});
}
Vector<Complex> place(const Vector<Complex>& X, double t) {
  const Vector<Complex> Y = turned(Q.transpose(), X);
  const Complex s = 1.0 - t * Y[0];
  return turned(Q, {Y[0] / s, Y[1] * s, Y[2] / s});
}
// F, differentiated by hand.
Tensor<Complex> deformation(const Vector<Complex>& X, Complex t) {
  const Vector<Complex> Y = turned(Q.transpose(), X);
  const Complex s = 1.0 - t * Y[0];
  Tensor<Complex> F = Tensor<Complex>::Zero();
  F.diagonal() << 1.0 / (s * s), s, 1.0 / s;
  F(1, 0) = -t * Y[1];
  F(2, 0) = t * Y[2] / (s * s);
  const Tensor<Complex> turn = Q.cast<Complex>();
  return turn * F * turn.transpose();
}

// A time below 1/2 and a point of the matter that is not at infinity by then, drawn at random.
struct Moment {
  Vector<double> X;
  double t;

  template <class Draw>
  explicit Moment(Draw& uniform) : X(random_tensor(uniform).col(0)), t(0.5 * uniform()) {}
  double first() const { return Q.col(0).dot(X); }  // Y0
  Tensor<double> F() const { return deformation(X.cast<Complex>(), t).real(); }
  Tensor<double> F_rate() const {
    return derivative([this](Complex at) { return deformation(X.cast<Complex>(), at); }, t);
  }
  Tensor<double> L() const { return gradient(velocity, place(X.cast<Complex>(), t).real()); }
};

// The largest of errors that are each relative to a size.
struct Worst {
  double error = 0.0;
  template <class A, class B>
  void add(const A& computed, const B& expected, double size) {
    keep_larger(error, (computed - expected).norm(), size);
  }
  void add(double computed, double expected, double size) { keep_larger(error, computed - expected, size); }
};
void to_rounding(Rows& rows, const char* what, const Worst& worst, double tolerance) {
  rows.compare(what, {.expected = 0.0,
                      .computed = worst.error,
                      .tolerance = absolute(tolerance),
                      .because = "rounding of some ten operations, relative to the largest of the terms"});
}

const Case jacobian_rates{
    {.name = "jacobian_rate",
     .claim = "along a flow whose motion is known, J grows as J div v, and F as L F",
     .equation = "D A.2",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      Uniform uniform(rows.case_seed());
      Worst F_off, L_off, J_off, rate_off, by_motion_off;
      for (int k = 0; k < 200; ++k) {
        const Moment at(uniform);
        const Tensor<double> F = at.F(), L = at.L();
        const double s = 1.0 - at.t * at.first(), J = 1.0 / (s * s), rate = 2.0 * at.first() * J / s;
        const double size = F.norm() * F.norm() * F.norm();
        F_off.add(gradient([&](const Vector<Complex>& X) { return place(X, at.t); }, at.X), F, F.norm());
        L_off.add(velocity_gradient(F, at.F_rate()), L, at.F_rate().norm() * F.norm() * F.norm() / J);
        J_off.add(jacobian(F), J, size);
        rate_off.add(jacobian_rate(F, L), rate, size * L.norm());
        const auto J_at = [&](Complex t) { return jacobian(deformation(at.X.cast<Complex>(), t)); };
        by_motion_off.add(derivative(J_at, at.t), rate, size * L.norm());
      }
      to_rounding(rows, "F of the motion", F_off, 4e-15);
      to_rounding(rows, "J", J_off, 4e-15);
      to_rounding(rows, "rate of J, of the velocity", rate_off, 1e-14);
      to_rounding(rows, "rate of J, of the motion", by_motion_off, 1e-14);
      to_rounding(rows, "gradient of the velocity, of the motion", L_off, 1e-14);
    }};

Vector<double> area_of(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c) {
  return 0.5 * (b - a).cross(c - a);
}

const Case maps{
    {.name = "nanson",
     .claim = "triangles and tetrahedra, deformed corner by corner, have the areas and volumes that F makes of them",
     .equation = "D A.1",
     .reference = Reference::closed_form},
    [](Rows& rows) {
      Uniform uniform(rows.case_seed());
      Worst line_off, area_off, volume_off, squares_off;
      for (int k = 0; k < 200; ++k) {
        const Tensor<double> F = Tensor<double>::Identity() + 0.8 * random_tensor(uniform);
        const Tensor<double> corners = random_tensor(uniform), moved = F * corners;  // of a tetrahedron, and the origin
        const Vector<double> a = corners.col(0), b = corners.col(1), c = corners.col(2);
        const double size = F.norm();
        line_off.add(deformed_line<double>(F, b - a), moved.col(1) - moved.col(0), size);
        area_off.add(deformed_area(F, area_of(a, b, c)), area_of(moved.col(0), moved.col(1), moved.col(2)),
                     size * size);
        volume_off.add(deformed_volume(F, a.dot(b.cross(c)) / 6.0),
                       moved.col(0).dot(moved.col(1).cross(moved.col(2))) / 6.0, size * size * size);
        squares_off.add(2.0 * a.dot(green_lagrange(F) * a), moved.col(0).squaredNorm() - a.squaredNorm(), size * size);
      }
      to_rounding(rows, "edges", line_off, 2e-15);
      to_rounding(rows, "area times normal of a face", area_off, 4e-15);
      to_rounding(rows, "volume", volume_off, 4e-15);
      to_rounding(rows, "square of an edge, less what it was", squares_off, 4e-15);
    }};

const Case area_identities{
    {.name = "area_rates",
     .claim = "deformed areas close up around every body, and change as a flow has them change",
     .equation = "D A.1",
     .reference = Reference::identity},
    [](Rows& rows) {
      Uniform uniform(rows.case_seed());
      Worst closed_off, area_rate_off, strain_rate_off, line_rate_off, turned_off;
      for (int k = 0; k < 200; ++k) {
        const Moment at(uniform);
        const Tensor<double> F = at.F(), L = at.L(), D = rate_of_deformation(L);
        const Vector<double> N_dA = random_tensor(uniform).col(0), area = deformed_area(F, N_dA);
        const auto of_time = [&](auto what) {
          return derivative([&](Complex t) { return what(deformation(at.X.cast<Complex>(), t)); }, at.t);
        };
        // Piola: cof F has no divergence.
        Vector<double> divergence = Vector<double>::Zero();
        for (int j = 0; j < 3; ++j) {
          divergence += derivative(
              [&](Complex along) {
                Vector<Complex> X = at.X.cast<Complex>();
                X[j] = along;
                return Vector<Complex>(cofactor(deformation(X, at.t)).col(j));
              },
              at.X[j]);
        }
        const double size = F.norm() * F.norm();
        closed_off.add(divergence, Vector<double>::Zero(), size * size);
        const auto area_at = [&](const auto& F_t) { return deformed_area(F_t, Vector<Complex>(N_dA.cast<Complex>())); };
        area_rate_off.add(of_time(area_at), L.trace() * area - L.transpose() * area, size * L.norm());
        strain_rate_off.add(of_time([](const auto& F_t) { return green_lagrange(F_t); }), F.transpose() * D * F,
                            size * L.norm());
        // A line turns at W and stretches at D.
        const Vector<double> dx = deformed_line(F, N_dA), rate = D * dx + spin(L) * dx;
        const auto line_at = [&](const auto& F_t) { return deformed_line(F_t, Vector<Complex>(N_dA.cast<Complex>())); };
        line_rate_off.add(of_time(line_at), rate, F.norm() * L.norm());
        turned_off.add(green_lagrange<double>(Q * F), green_lagrange(F), size);
      }
      to_rounding(rows, "divergence of cof F: areas of closed surfaces", closed_off, 1e-14);
      to_rounding(rows, "rate of an area, (tr L - L^T) n da", area_rate_off, 1e-14);
      to_rounding(rows, "rate of a line, (D + W) dx", line_rate_off, 1e-14);
      to_rounding(rows, "rate of strain, F^T D F", strain_rate_off, 1e-14);
      to_rounding(rows, "strain after a rotation", turned_off, 4e-15);
    }};

}  // namespace verification::continuum_deformations
