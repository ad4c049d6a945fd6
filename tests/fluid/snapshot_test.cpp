#include <particulate/fluid/snapshot.hpp>

#include <sstream>
#include <string>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "says.hpp"

namespace tests::fluid_snapshot_test {

using namespace particulate;
using namespace particulate::fluid;

// Numbers that need all of their digits.
template <int Dim>
Local<Dim> uneven(const Vector<Dim>& x) {
  return {.rho = 1000.0 + x.sum() / 3.0, .v = x / 7.0, .theta = 300.0 + x[0] / 9.0};
}

template <int Dim>
Grid<Dim> box() {
  Grid<Dim> grid{.lengths = Vector<Dim>::Constant(0.3), .corner = Vector<Dim>::Constant(0.1)};
  for (std::size_t a = 0; a < Dim; ++a) grid.cells[a] = 4 + static_cast<Eigen::Index>(a);
  return grid;
}

template <class F>
std::string written(const F& flow, const schemes::State& state) {
  std::ostringstream out;
  write_vtk(out, flow, state);
  return out.str();
}

// The numbers between the tags of the array of that name.
std::vector<double> values(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("Name=\"" + name + "\"");
  if (at == std::string::npos) return {};
  const std::size_t from = text.find('>', at) + 1;
  std::istringstream numbers(text.substr(from, text.find("</DataArray>", from) - from));
  std::vector<double> all;
  for (double x = 0.0; numbers >> x;) all.push_back(x);
  return all;
}

BOOST_AUTO_TEST_SUITE(write_vtk_)

BOOST_AUTO_TEST_CASE(gives_back_every_number_to_the_bit) {
  const LiquidFlow<3> flow(box<3>(), {}, {});
  schemes::State state = flow.start(uneven<3>);
  state.t = 0.1 + 0.2;
  const std::string text = written(flow, state);
  const std::vector<double> rho = values(text, "rho"), v = values(text, "velocity"), P = values(text, "pressure"),
                            theta = values(text, "temperature");
  BOOST_TEST_REQUIRE(rho.size() == 4 * 5 * 6);
  BOOST_TEST_REQUIRE(v.size() == 3 * rho.size());
  BOOST_TEST_REQUIRE(P.size() == rho.size());
  BOOST_TEST_REQUIRE(theta.size() == rho.size());
  for (std::size_t n = 0; n < rho.size(); ++n) {
    const Local<3> here = flow.local(state, static_cast<Eigen::Index>(n));
    BOOST_TEST(rho[n] == here.rho);
    BOOST_TEST(Eigen::Vector3d(v[3 * n], v[3 * n + 1], v[3 * n + 2]) == here.v);
    BOOST_TEST(P[n] == pressure(flow.fluid().state, here.rho, here.theta));
    BOOST_TEST(theta[n] == here.theta);
  }
  BOOST_TEST(values(text, "TimeValue") == std::vector<double>{state.t}, boost::test_tools::per_element());
  BOOST_TEST(text.find("WholeExtent=\"0 4 0 5 0 6\" Origin=\"0.1 0.1 0.1\"") != std::string::npos);
}

// Second cell along x: by hand, from where its middle is.
BOOST_AUTO_TEST_CASE(counts_cells_along_x_first) {
  const BarotropicFlow<2> flow(box<2>(), {}, {});
  const std::string text = written(flow, flow.start([](const Vector<2>& x) {
    return Local<2>{.rho = 1.0 + (x[0] > 0.175 && x[0] < 0.25 && x[1] < 0.16 ? 1.0 : 0.0)};
  }));
  const std::vector<double> rho = values(text, "rho");
  BOOST_TEST_REQUIRE(rho.size() == 20);
  for (std::size_t n = 0; n < rho.size(); ++n) BOOST_TEST(rho[n] == (n == 1 ? 2.0 : 1.0));
  BOOST_TEST(text.find("WholeExtent=\"0 4 0 5 0 0\"") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(fills_up_what_a_line_of_a_barotropic_fluid_does_not_have) {
  const BarotropicFlow<1> flow(box<1>(), {.state = {.P_R = 1e5}}, {});
  const std::string text =
      written(flow, flow.start([](const Vector<1>&) { return Local<1>{.rho = 1000.0, .v = Vector<1>(0.25)}; }));
  const std::vector<double> once{0.25, 0.0, 0.0, 0.25, 0.0, 0.0, 0.25, 0.0, 0.0, 0.25, 0.0, 0.0};
  BOOST_TEST(values(text, "velocity") == once, boost::test_tools::per_element());
  BOOST_TEST(values(text, "pressure") == std::vector<double>(4, 1e5), boost::test_tools::per_element());
  BOOST_TEST(values(text, "temperature").empty());
  BOOST_TEST(text.find("WholeExtent=\"0 4 0 0 0 0\" Origin=\"0.1 0 0\" Spacing=\"0.075 1 1\"") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(refuses_a_state_of_another_flow) {
  const GasFlow<2> flow(box<2>(), {}, {});
  BOOST_CHECK_EXCEPTION(written(flow, {.y = Eigen::VectorXd::Ones(60)}), std::invalid_argument,
                        says("a state of 20 cells must hold 80 numbers, 4 a cell, got 60"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::fluid_snapshot_test
