#include "driver.hpp"

#include "rebound.hpp"

namespace {

using Numbers = std::vector<double>;

Eigen::Vector3d vector_at(const Numbers& x, std::size_t k) { return {x[k], x[k + 1], x[k + 2]}; }

Body body_i(const Numbers& x) { return {.m = x[0], .v = vector_at(x, 1)}; }
Body body_j(const Numbers& x) { return {.m = x[4], .v = vector_at(x, 5)}; }
Eigen::Vector3d normal_in(const Numbers& x) { return vector_at(x, 8); }
Surface surface(const Numbers& x) { return {.e = x[11], .mu_s = x[12], .mu_d = x[13]}; }

Numbers numbers(const Eigen::Vector3d& a) { return {a.x(), a.y(), a.z()}; }

}  // namespace

int main(int argc, char** argv) {
  return driver::answer(
      argc, argv,
      {{"normal", [](const Numbers& x) -> Numbers { return numbers(normal(x[0])); }},
       {"normal_impulse",
        [](const Numbers& x) -> Numbers { return {normal_impulse(body_i(x), body_j(x), normal_in(x), x[11])}; }},
       {"friction_impulse",
        [](const Numbers& x) -> Numbers {
          return numbers(friction_impulse(body_i(x), body_j(x), normal_in(x), surface(x)));
        }},
       {"impact", [](const Numbers& x) -> Numbers {
          const Velocities after = impact(body_i(x), body_j(x), normal_in(x), surface(x));
          return {after.i.x(), after.i.y(), after.i.z(), after.j.x(), after.j.y(), after.j.z()};
        }}});
}
