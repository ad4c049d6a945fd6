#pragma once

/// @file
/// What a smooth interface reflects of a plane wave: light after Fresnel, sound between fluids and against a solid.
/// Each interface is a value; all share `reflectance(law, cos_incidence)`, with the cosine of the angle between the ray
/// and the normal, 0 at grazing and 1 at normal incidence. Cosines instead of angles, because a tracer has those, and
/// because both ends of the range then keep their digits.

namespace particulate::scattering {

/// An interface for light, between media that do not absorb: n^ = n_t/n_i, mu^ = mu_t/mu_i, t behind it, i before it.
///
/// @equation{D 9.2.4}
struct Fresnel {
  double n_hat = 1.5;   ///< ratio of refractive indices, > 0 and finite [-]
  double mu_hat = 1.0;  ///< ratio of magnetic permeabilities, > 0 and finite [-]
};

/// An interface for sound between two fluids.
///
/// @equation{D B.3}
struct FluidFluid {
  double Z_hat = 1.0;  ///< ratio of impedances rho c, behind it over before it, > 0 and finite [-]
  double c_hat = 1.0;  ///< ratio of speeds of sound, likewise, > 0 and finite [-]
};

/// An interface for sound between a fluid, before it, and an elastic solid.
///
/// @equation{D B.3}
struct FluidSolid {
  double rho_f = 1000.0;  ///< density of the fluid, > 0 [kg/m^3]
  double c_f = 1480.0;    ///< speed of sound in it, > 0 [m/s]
  double rho_s = 7800.0;  ///< density of the solid, > 0 [kg/m^3]
  double c_l = 5900.0;    ///< speed of its longitudinal waves, above c_s sqrt(4/3) [m/s]
  double c_s = 3200.0;    ///< speed of its shear waves, > 0 [m/s]
};

/// Refuses constants that are no interface. Called once, where a law enters.
///
/// @param law  the constants
/// @throws std::invalid_argument naming the constant, what must hold and what was given
void validate(const Fresnel& law);
/// @copydoc validate(const Fresnel&)
void validate(const FluidFluid& law);
/// @copydoc validate(const Fresnel&)
void validate(const FluidSolid& law);

/// Amplitude of the reflected wave whose electric field lies in the plane of incidence.
///
/// \f[ r_\parallel = \frac{(\hat n^2/\hat\mu) \cos\theta - s}{(\hat n^2/\hat\mu) \cos\theta + s}, \qquad
///     s = \sqrt{\hat n^2 - \sin^2 \theta} = \sqrt{(\hat n - 1)(\hat n + 1) + \cos^2 \theta} \f]
///
/// @equation{D 9.2.4} Below total reflection, sin theta < n^, and there positive at normal incidence for n^ > mu^.
/// @param law            constants that validate() accepts
/// @param cos_incidence  cos theta, 0 to 1 [-]
/// @return r, -1 to 1; 1 under total reflection, of which only the size is told [-]
double r_parallel(const Fresnel& law, double cos_incidence);

/// Amplitude of the reflected wave whose electric field lies across the plane of incidence.
///
/// \f[ r_\perp = \frac{\cos\theta - s/\hat\mu}{\cos\theta + s/\hat\mu} \f]
///
/// @equation{D 9.2.4}
/// @param law            constants that validate() accepts
/// @param cos_incidence  cos theta, 0 to 1 [-]
/// @return r, -1 to 1; 1 under total reflection, of which only the size is told [-]
double r_perpendicular(const Fresnel& law, double cos_incidence);

/// Share of unpolarized light that is reflected.
///
/// \f[ R = \tfrac12 \left(r_\parallel^2 + r_\perp^2\right), \qquad R = 1 \text{ for } \sin\theta \ge \hat n \f]
///
/// @equation{D 9.2.4} Formed with twice the digits of a double, so that it has all of them near n^ = 1, at grazing and
/// at normal incidence, and at the edge of total reflection.
/// @param law            constants that validate() accepts
/// @param cos_incidence  cos theta, 0 to 1 [-]
/// @return R, 0 to 1 [-]
double reflectance(const Fresnel& law, double cos_incidence);

/// The angle at which light that is polarized in the plane of incidence is not reflected.
///
/// \f[ \tan\theta_B = \hat n \f]
///
/// @equation{D 9.2.4} For mu^ = 1.
/// @param n_hat  ratio of refractive indices, > 0 [-]
/// @return theta_B [rad]
double brewster_angle(double n_hat);

/// The angle of incidence beyond which all is reflected, \f$ \sin\theta_c = \hat n \f$; so for sound with 1/c^.
///
/// @equation{D 9.2.4}
/// @param n_hat  ratio of refractive indices, 0 < n^ < 1 [-]
/// @return theta_c [rad]
/// @throws std::invalid_argument if nothing is ever reflected totally
double critical_angle(double n_hat);

/// How reflectance begins to change away from normal incidence, \f$ R = R(0) + c_4 \sin^4\theta + \dots \f$
///
/// \f[ c_4 = -\frac{\hat\mu\, (\hat n^2 - 1)^2\, (\hat n^2 - 4 \hat\mu \hat n + \hat\mu^2)}
///                 {2\, \hat n^3\, (\hat n + \hat\mu)^4} \f]
///
/// @equation{D B.1} Negative, so that R dips first, if and only if n^/mu^ lies outside of 2 +- sqrt(3), or R(0) > 1/3.
/// @param law  constants that validate() accepts
/// @return c4 [-]
double dip_coefficient(const Fresnel& law);

/// Reflectance of a sphere in a uniform beam: the share of the light it intercepts that it reflects at first.
///
/// \f[ F = 2 \int_0^{\pi/2} R(\theta) \sin\theta \cos\theta\, d\theta \f]
///
/// @equation{D 9.3.2} For mu^ = 1 and n^ from 1.5 to 1000 in closed form (Walsh, Duntley), which loses digits near
/// n^ = 1; else by quadrature, to some 1e-14.
/// @param law  constants that validate() accepts
/// @return F, 0 to 1 [-]
double sphere_reflectance(const Fresnel& law);

/// Integrated reflectance of a planar quarter of a scatterer, the other reading of the monograph's figure.
///
/// \f[ \int_0^{\pi/2} R(\theta) \cos\theta\, d\theta \f]
///
/// @equation{D 9.3.2} By quadrature, to some 1e-14.
/// @param law  constants that validate() accepts
/// @return integral, 0 to 1 [-]
double planar_reflectance(const Fresnel& law);

/// What a lone sphere leaves of the x component of the light that it intercepts from a uniform beam along x.
///
/// \f[ \frac{I_x}{I} = -2 \int_0^{\pi/2} R \cos 2\theta \sin\theta \cos\theta\, d\theta \f]
///
/// @equation{D 9.3} By quadrature, to some 1e-14.
/// @param law  constants that validate() accepts
/// @return signed share, -F to F [-]
double sphere_x_irradiance(const Fresnel& law);

/// How that changes with the step of a tracer that finds a hit only inside of a body.
///
/// \f[ S = \int_0^{\pi/2} R \cos 2\theta \sin\theta\, (2 \cos^2\theta - \sin^2\theta)\, d\theta, \qquad
///     I_x(\xi) - I_x(0) \to \xi S \f]
///
/// @equation{D 9.3} Steps of xi radii, at a random phase. By quadrature, to some 1e-14.
/// @param law  constants that validate() accepts
/// @return S [-]
double stepping_slope(const Fresnel& law);

/// Pressure of the reflected wave between two fluids over that of the incident one.
///
/// \f[ r = \frac{\hat Z \cos\theta - \cos\theta_t}{\hat Z \cos\theta + \cos\theta_t}, \qquad
///     \sin\theta_t = \hat c \sin\theta \f]
///
/// @equation{D B.3}
/// @param law            constants that validate() accepts
/// @param cos_incidence  cos theta, 0 to 1 [-]
/// @return r, -1 to 1; 1 under total reflection, of which only the size is told [-]
double r_pressure(const FluidFluid& law, double cos_incidence);

/// Share of the energy that two fluids reflect, r^2.
///
/// @equation{D B.3}
/// @param law            constants that validate() accepts
/// @param cos_incidence  cos theta, 0 to 1 [-]
/// @return R, 0 to 1 [-]
double reflectance(const FluidFluid& law, double cos_incidence);

/// Reflectance for sound of a sphere in a uniform beam, \f$ F = 2 \int_0^{\pi/2} r^2 \sin\theta \cos\theta\, d\theta
/// \f$.
///
/// @equation{D B.3} By quadrature, to some 1e-14.
/// @param law  constants that validate() accepts
/// @return F, 0 to 1 [-]
double sphere_reflectance(const FluidFluid& law);

/// Where the energy of a sound wave goes that meets a solid; the three add up to 1.
struct SolidShares {
  double reflected = 0.0;     ///< |r|^2, back into the fluid [-]
  double longitudinal = 0.0;  ///< W_l, into longitudinal waves of the solid; 0 beyond their critical angle [-]
  double shear = 0.0;         ///< W_s, into its shear waves; 0 beyond theirs [-]
};

/// Shares of the energy of a wave from a fluid.
///
/// \f[ r = \frac{N - Z_f}{N + Z_f}, \qquad N = Z_l \cos^2 2\theta_s + Z_s \sin^2 2\theta_s, \qquad
///     Z_l = \frac{\rho_s c_l}{\cos\theta_l},\; Z_s = \frac{\rho_s c_s}{\cos\theta_s},\;
///     Z_f = \frac{\rho_f c_f}{\cos\theta} \f]
/// \f[ W_l = \frac{4 Z_f \operatorname{Re}(Z_l \cos^2 2\theta_s)}{|N + Z_f|^2}, \qquad
///     W_s = \frac{4 Z_f \operatorname{Re}(Z_s \sin^2 2\theta_s)}{|N + Z_f|^2} \f]
///
/// with \f$ \sin\theta_{l,s} = (c_{l,s}/c_f) \sin\theta \f$, and beyond a critical angle
/// \f$ \cos\theta_{l,s} = i \sqrt{\sin^2 \theta_{l,s} - 1} \f$ for waves as exp(-i w t).
///
/// @equation{D B.3} Brekhovskikh.
/// @param law            constants that validate() accepts
/// @param cos_incidence  cos theta, 0 to 1 [-]
/// @return the shares
SolidShares shares(const FluidSolid& law, double cos_incidence);

/// Share of the energy that comes back from a solid.
///
/// @equation{D B.3}
/// @param law            constants that validate() accepts
/// @param cos_incidence  cos theta, 0 to 1 [-]
/// @return |r|^2, 0 to 1 [-]
double reflectance(const FluidSolid& law, double cos_incidence);

}  // namespace particulate::scattering
