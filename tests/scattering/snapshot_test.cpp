#include <particulate/scattering/snapshot.hpp>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include <boost/test/unit_test.hpp>

namespace tests::ray_snapshot_test {

using namespace particulate::scattering;

// What stands between the tags of the array of that name.
std::string values(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("Name=\"" + name + "\""), from = text.find(">\n", at) + 2;
  return at == std::string::npos ? "" : text.substr(from, text.find("</DataArray>", from) - from);
}
template <class What>
std::string written(const std::vector<What>& what) {
  std::ostringstream out;
  write_vtk(out, what);
  return out.str();
}

BOOST_AUTO_TEST_SUITE(write_vtk_)

BOOST_AUTO_TEST_CASE(makes_a_line_of_every_ray) {
  const std::string text = written<PathPoint>({{0, {0.0, 0.0, 0.0}, 0.0, 2.0, -1},
                                               {0, {1.0, 0.0, 0.0}, 1.0, 0.5, 3},
                                               {0, {1.0, 3.0, 0.0}, 4.0, 0.5, -1},
                                               {1, {0.0, 0.1, 0.0}, 0.0, 2.0, -1},
                                               {1, {5.0, 0.1, 0.0}, 5.0, 2.0, -1}});
  BOOST_TEST(text.find("NumberOfPoints=\"5\" NumberOfVerts=\"0\" NumberOfLines=\"2\"") != std::string::npos);
  BOOST_TEST(values(text, "places") == "0 0 0\n1 0 0\n1 3 0\n0 0.1 0\n5 0.1 0\n");
  BOOST_TEST(values(text, "offsets") == "3\n5\n");
  BOOST_TEST(values(text, "power") == "2\n0.5\n0.5\n2\n2\n");
  BOOST_TEST(values(text, "length") == "0\n1\n4\n0\n5\n");
}

BOOST_AUTO_TEST_CASE(makes_a_point_of_every_body_with_its_axis_and_radii) {
  const std::string text = written<Spheroid>(
      {{.centre = {1.0, 2.0, 3.0}, .axis = {0.0, 0.0, 1.0}, .equatorial = 4.0, .polar = 1.0}, {.axis = {1, 0, 0}}});
  BOOST_TEST(values(text, "places") == "1 2 3\n0 0 0\n");
  BOOST_TEST(values(text, "axis") == "0 0 1\n1 0 0\n");
  BOOST_TEST(values(text, "radii") == "1 4 4\n1 1 1\n");
  BOOST_TEST(values(text, "offsets") == "1\n2\n");
  BOOST_TEST(values(written<Sphere>({{.radius = 0.5}}), "radii") == "0.5 0.5 0.5\n");
}

// The cell of the monograph is 2.5656737 um thick at most.
BOOST_AUTO_TEST_CASE(makes_a_spheroid_as_thick_as_the_cell) {
  const double half = std::stod(values(written<RedCell>({{}}), "radii"));
  BOOST_TEST(half == 0.5 * 2.5656737e-6, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(writes_files_of_nothing) {
  BOOST_TEST(written<PathPoint>({}).find("NumberOfPoints=\"0\"") != std::string::npos);
  BOOST_TEST(written<Sphere>({}).find("NumberOfPoints=\"0\"") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::ray_snapshot_test
