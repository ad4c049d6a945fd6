#include <particulate/scattering/interface.hpp>

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/scattering/detail/quadrature.hpp>
#include <particulate/scattering/detail/twice.hpp>

namespace particulate::scattering {

namespace {

using detail::Twice, detail::exact_product;

void require_positive(const char* what, double given) {
  if (given > 0.0 && std::isfinite(given)) return;
  throw std::invalid_argument(fmt::format("interface: {} must be positive and finite, got {}", what, given));
}

// a^2 - b^2.
double squares_apart(double a, double b) { return (a - b) * (a + b); }

// (a - b)/(a + b).
double contrast(const Twice& a, const Twice& b) { return ((a - b) / (a + b)).value(); }

// The same interface from behind: it reflects as much of a ray that comes along the refracted one.
Fresnel from_behind(const Fresnel& law) { return {1.0 / law.n_hat, 1.0 / law.mu_hat}; }
FluidFluid from_behind(const FluidFluid& law) { return {1.0 / law.Z_hat, 1.0 / law.c_hat}; }

// Of R times a weight of cos theta, over cos theta. Where rays are reflected totally up to an edge, R leaves 1 there
// like a square root, of a difference that has lost its digits: over the cosine u of the refracted ray it is smooth.
template <class Law, class Weight>
double weighted(const Law& law, double n_hat, const Weight& weight) {
  validate(law);
  if (n_hat >= 1.0) return detail::integral([&](double c) { return reflectance(law, c) * weight(c); }, 0.0, 1.0);
  const double edge = std::sqrt(squares_apart(1.0, n_hat));
  const Law behind = from_behind(law);
  const auto refracted = [&](double u) {
    const double c = std::hypot(edge, n_hat * u);
    return reflectance(behind, u) * weight(c) * n_hat * n_hat * u / c;
  };
  return detail::integral(weight, 0.0, edge) + detail::integral(refracted, 0.0, 1.0);
}

// Walsh and Duntley's closed form of the sphere's reflectance.
double walsh(double n) {
  const double n2 = n * n, n4 = n2 * n2;
  return 0.5 + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * (n + 1.0) * (n + 1.0)) +
         n2 * (n2 - 1.0) * (n2 - 1.0) / ((n2 + 1.0) * (n2 + 1.0) * (n2 + 1.0)) * std::log((n - 1.0) / (n + 1.0)) -
         2.0 * n2 * n * (n2 + 2.0 * n - 1.0) / ((n2 + 1.0) * (n4 - 1.0)) +
         8.0 * n4 * (n4 + 1.0) / ((n2 + 1.0) * (n4 - 1.0) * (n4 - 1.0)) * std::log(n);
}

}  // namespace

void validate(const Fresnel& law) {
  require_positive("n_hat", law.n_hat);
  require_positive("mu_hat", law.mu_hat);
}

void validate(const FluidFluid& law) {
  require_positive("Z_hat", law.Z_hat);
  require_positive("c_hat", law.c_hat);
}

void validate(const FluidSolid& law) {
  for (const auto& [what, given] :
       {std::pair{"rho_f", law.rho_f}, {"c_f", law.c_f}, {"rho_s", law.rho_s}, {"c_l", law.c_l}, {"c_s", law.c_s}}) {
    require_positive(what, given);
  }
  if (3.0 * law.c_l * law.c_l > 4.0 * law.c_s * law.c_s) return;
  throw std::invalid_argument(
      fmt::format("interface: a solid resists compression, c_l > c_s sqrt(4/3), got c_l = {} m/s and c_s = {} m/s",
                  law.c_l, law.c_s));
}

namespace {

// What both amplitudes are formed of: the root s, and n^2/mu; false under total reflection.
bool refracted(const Fresnel& law, double cosine, Twice& s) {
  const Twice square = (exact_product(law.n_hat, law.n_hat) - Twice{1.0}) + exact_product(cosine, cosine);
  s = root(square);
  return square.hi > 0.0;
}
double parallel(const Fresnel& law, double cosine, const Twice& s) {
  const Twice square = exact_product(law.n_hat, law.n_hat);
  return contrast((law.mu_hat == 1.0 ? square : square / Twice{law.mu_hat}) * Twice{cosine}, s);
}
double perpendicular(const Fresnel& law, double cosine, const Twice& s) {
  return contrast(exact_product(law.mu_hat, cosine), s);
}

}  // namespace

double r_parallel(const Fresnel& law, double cos_incidence) {
  Twice s;
  return refracted(law, cos_incidence, s) ? parallel(law, cos_incidence, s) : 1.0;
}

double r_perpendicular(const Fresnel& law, double cos_incidence) {
  Twice s;
  return refracted(law, cos_incidence, s) ? perpendicular(law, cos_incidence, s) : 1.0;
}

double reflectance(const Fresnel& law, double cos_incidence) {
  Twice s;
  if (!refracted(law, cos_incidence, s)) return 1.0;
  const double along = parallel(law, cos_incidence, s), across = perpendicular(law, cos_incidence, s);
  return 0.5 * (along * along + across * across);
}

double brewster_angle(double n_hat) { return std::atan(n_hat); }

double critical_angle(double n_hat) {
  if (!(n_hat > 0.0 && n_hat < 1.0)) {
    throw std::invalid_argument(fmt::format(
        "interface: total reflection needs a ratio between 0 and 1, got {}: nothing is reflected totally", n_hat));
  }
  return std::asin(n_hat);
}

double dip_coefficient(const Fresnel& law) {
  const double n = law.n_hat, mu = law.mu_hat, apart = squares_apart(n, 1.0), sum = n + mu;
  return -mu * apart * apart * (n * n - 4.0 * mu * n + mu * mu) / (2.0 * n * n * n * sum * sum * sum * sum);
}

double sphere_reflectance(const Fresnel& law) {
  validate(law);
  if (law.mu_hat == 1.0 && law.n_hat >= 1.5 && law.n_hat <= 1e3) return walsh(law.n_hat);
  return weighted(law, law.n_hat, [](double c) { return 2.0 * c; });
}

double planar_reflectance(const Fresnel& law) {
  validate(law);
  if (law.n_hat < 1.0) return 1.0 - law.n_hat + law.n_hat * planar_reflectance(from_behind(law));
  const auto over_angle = [&](double theta) { return reflectance(law, std::cos(theta)) * std::cos(theta); };
  return detail::integral(over_angle, 0.0, 0.5 * std::numbers::pi);
}

double sphere_x_irradiance(const Fresnel& law) {
  return weighted(law, law.n_hat, [](double c) { return -2.0 * c * (2.0 * c * c - 1.0); });
}

double stepping_slope(const Fresnel& law) {
  return weighted(law, law.n_hat, [](double c) { return (2.0 * c * c - 1.0) * (3.0 * c * c - 1.0); });
}

double r_pressure(const FluidFluid& law, double cos_incidence) {
  const Twice c2 = exact_product(law.c_hat, law.c_hat);
  const Twice t2 = (Twice{1.0} - c2) + c2 * exact_product(cos_incidence, cos_incidence);
  if (!(t2.hi > 0.0)) return 1.0;
  return contrast(exact_product(law.Z_hat, cos_incidence), root(t2));
}

double reflectance(const FluidFluid& law, double cos_incidence) {
  const double r = r_pressure(law, cos_incidence);
  return r * r;
}

double sphere_reflectance(const FluidFluid& law) {
  return weighted(law, 1.0 / law.c_hat, [](double c) { return 2.0 * c; });
}

SolidShares shares(const FluidSolid& law, double cos_incidence) {
  // With the digits that the machine has beyond a double, which the sums of three terms lose.
  using Long = long double;
  using Complex = std::complex<Long>;
  const Long c = cos_incidence, S = (1 - c) * (1 + c);
  const auto cosine = [&](Long speed) {
    const Long ratio = speed / law.c_f, square = 1 - ratio * ratio * S;
    return square >= 0 ? Complex(std::sqrt(square), 0) : Complex(0, std::sqrt(-square));
  };
  const Long shear_ratio = static_cast<Long>(law.c_s) / law.c_f, sin2_s = shear_ratio * shear_ratio * S;
  const Long cos_2s = 1 - 2 * sin2_s;
  const Complex cos_l = cosine(law.c_l), cos_s = cosine(law.c_s);
  // All impedances times the three cosines, of which one may be zero.
  const Complex along = static_cast<Long>(law.rho_s) * law.c_l * cos_2s * cos_2s * c * cos_s;
  const Complex across = static_cast<Long>(law.rho_s) * law.c_s * 4 * sin2_s * c * cos_s * cos_s * cos_l;
  const Complex fluid = static_cast<Long>(law.rho_f) * law.c_f * cos_l * cos_s;
  const Long size = std::norm(along + across + fluid);
  if (size == 0) return {.reflected = 1.0};
  const auto share = [&](Long part) { return static_cast<double>(part / size); };
  return {.reflected = share(std::norm(along + across - fluid)),
          .longitudinal = share(4 * std::real(along * std::conj(fluid))),
          .shear = share(4 * std::real(across * std::conj(fluid)))};
}

double reflectance(const FluidSolid& law, double cos_incidence) { return shares(law, cos_incidence).reflected; }

}  // namespace particulate::scattering
