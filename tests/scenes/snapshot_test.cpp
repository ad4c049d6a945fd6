#include <particulate/scenes/snapshot.hpp>

#include <sstream>
#include <string>
#include <vector>

#include <particulate/laws/gravity.hpp>
#include <particulate/scenes/scene.hpp>

#include "close.hpp"

namespace tests::snapshot_test {

using namespace particulate::kinematics;
using namespace particulate::laws;
using namespace particulate::scenes;
using namespace particulate::schemes;

// Two of them out of the first period in x; numbers that need all their digits.
Particles three() {
  return particles({{.position = {2.25, 0.1, -3.0}, .velocity = {1.0 / 3.0, 0.0, 0.0}, .mass = 0.1, .radius = 0.05},
                    {.position = {-0.25, 0.5, 1.0}, .mass = 2.0, .radius = 0.1, .immovable = true},
                    {.position = {0.5, 1.0, 2.0}, .velocity = {0.0, -1e-300, 0.0}, .mass = 3.0, .radius = 0.2}});
}

State moment() {
  const Particles all = three();
  return {.t = 0.3, .r = all.position.reshaped(), .v = all.velocity.reshaped()};
}

Space repeating_in_x() {
  Space space;
  space.lengths[0] = 2.0;
  return space;
}

std::string xyz(const Space& space) {
  std::ostringstream text;
  write_xyz(text, three(), space, moment());
  return text.str();
}

std::string vtk(const Space& space) {
  std::ostringstream text;
  write_vtk(text, three(), space, moment());
  return text.str();
}

// The numbers in a text, from the first place after some words.
std::vector<double> numbers(const std::string& text, const std::string& after, int n) {
  const std::size_t at = text.find(after);
  BOOST_TEST_REQUIRE(at != std::string::npos);
  std::istringstream rest(text.substr(at + after.size()));
  std::vector<double> all(static_cast<std::size_t>(n));
  for (double& x : all) {
    std::string word;  // a stream reads no subnormal number, nor 1e-300 on every platform
    rest >> word;
    x = std::stod(word);
  }
  return all;
}

BOOST_AUTO_TEST_SUITE(write_xyz_)

BOOST_AUTO_TEST_CASE(writes_a_frame_that_reads_back_to_the_bit) {
  std::istringstream frame(xyz({}));
  std::string N, about;
  std::getline(frame, N);
  std::getline(frame, about);
  BOOST_TEST(N == "3");
  BOOST_TEST(about ==
             "pbc=\"F F F\" Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1:immovable:I:1 Time=0.3");
  const Particles all = three();
  for (Eigen::Index i = 0; i < 3; ++i) {
    std::string line, species;
    BOOST_TEST_REQUIRE(static_cast<bool>(std::getline(frame, line)));
    BOOST_TEST(line.substr(0, 2) == "X ");
    const std::vector<double> x = numbers(line, " ", 10);
    BOOST_TEST(Eigen::Vector3d(x[0], x[1], x[2]) == vector(all.position, i));
    BOOST_TEST(Eigen::Vector3d(x[3], x[4], x[5]) == vector(all.velocity, i));
    BOOST_TEST(x[6] == all.radius[i]);
    BOOST_TEST(x[7] == all.mass[i]);
    BOOST_TEST(x[8] == static_cast<double>(i));
    BOOST_TEST(x[9] == (i == 1 ? 1.0 : 0.0));
  }
  BOOST_TEST((frame.peek() == std::char_traits<char>::eof()));
}

// In y and z the cell spans the spheres: from 0.05 to 1.2, from -3.05 to 2.2.
BOOST_AUTO_TEST_CASE(wraps_places_into_the_cell_that_repeats_itself) {
  const std::string text = xyz(repeating_in_x());
  const std::vector<double> cell = numbers(text, "Lattice=\"", 8), corner = numbers(text, "Origin=\"", 2);
  BOOST_TEST(cell[0] == 2.0);
  BOOST_TEST(cell[4] == 1.15, tolerance(1e-14));
  BOOST_TEST(contains(text, "\" pbc=\"T F F\" "));
  BOOST_TEST(corner[0] == 0.0);
  BOOST_TEST(corner[1] == 0.05, tolerance(1e-14));
  const std::size_t first = text.find("\nX ") + 1, second = text.find('\n', first) + 1;
  BOOST_TEST(numbers(text.substr(first), "X ", 1)[0] == 0.25);
  BOOST_TEST(numbers(text.substr(second), "X ", 1)[0] == 1.75);
}

BOOST_AUTO_TEST_CASE(writes_a_scene_and_one_of_nothing) {
  const Scene scene(three(), repeating_in_x(), Gravity{});
  std::ostringstream text, nothing;
  write_xyz(text, scene, moment());
  BOOST_TEST(text.str() == xyz(repeating_in_x()));
  write_xyz(nothing, Scene(particles({}), repeating_in_x(), Gravity{}), State{});
  BOOST_TEST(contains(nothing.str(), "0\nLattice=\"2 0 0 0 1 0 0 0 1\" Origin=\"0 0 0\" pbc=\"T F F\" "));
}

BOOST_AUTO_TEST_CASE(refuses_a_state_of_others) {
  std::ostringstream text;
  CHECK_REFUSED(write_xyz(text, three(), {}, State{}), "a state of 3 particles must hold 9 places");
  CHECK_REFUSED(write_vtk(text, three(), {}, State{}), "got 0 and 0");
  BOOST_TEST(text.str().empty());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(write_vtk_)

BOOST_AUTO_TEST_CASE(writes_points_with_what_belongs_to_them) {
  const std::string text = vtk(repeating_in_x());
  const auto array = [&](const std::string& name, int n) {
    const std::size_t at = text.find("Name=\"" + name + "\"");
    BOOST_TEST_REQUIRE(at != std::string::npos);
    return numbers(text.substr(at), ">", n);
  };
  BOOST_TEST(contains(text, "<Piece NumberOfPoints=\"3\" NumberOfVerts=\"3\">"));
  BOOST_TEST(numbers(text.substr(text.find("TimeValue")), ">", 1)[0] == 0.3);
  BOOST_TEST(array("Points", 9) == std::vector<double>({0.25, 0.1, -3.0, 1.75, 0.5, 1.0, 0.5, 1.0, 2.0}),
             boost::test_tools::per_element());
  BOOST_TEST(array("velocity", 9) == std::vector<double>({1.0 / 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1e-300, 0.0}),
             boost::test_tools::per_element());
  BOOST_TEST(array("radius", 3) == std::vector<double>({0.05, 0.1, 0.2}), boost::test_tools::per_element());
  BOOST_TEST(array("mass", 3) == std::vector<double>({0.1, 2.0, 3.0}), boost::test_tools::per_element());
  BOOST_TEST(array("id", 3) == std::vector<double>({0.0, 1.0, 2.0}), boost::test_tools::per_element());
  BOOST_TEST(array("offsets", 3) == std::vector<double>({1.0, 2.0, 3.0}), boost::test_tools::per_element());
}

// Every element that opens closes, in the right order: what a reader of XML needs.
BOOST_AUTO_TEST_CASE(closes_what_it_opens) {
  const std::string text = vtk({});
  std::vector<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    if (text[at + 1] == '?') continue;
    const bool closes = text[at + 1] == '/';
    const std::size_t begin = at + (closes ? 2 : 1);
    const std::string name = text.substr(begin, text.find_first_of(" >", begin) - begin);
    if (!closes) {
      open.push_back(name);
      continue;
    }
    BOOST_TEST_REQUIRE(!open.empty());
    BOOST_TEST(open.back() == name);
    open.pop_back();
  }
  BOOST_TEST(open.empty());
}

// Temperatures are those of the state, not of the start.
BOOST_AUTO_TEST_CASE(writes_temperatures_where_there_are_any) {
  Particles warm = three();
  warm.temperature = Eigen::Vector3d::Constant(300.0);
  warm.heat_capacity = Eigen::Vector3d::Ones();
  State at = moment();
  at.y = Eigen::Vector3d(310.0, 0.1, 1e5);
  std::ostringstream points, frame, cold;
  write_vtk(points, warm, {}, at);
  write_xyz(frame, warm, {}, at);
  write_xyz(cold, three(), {}, moment());
  const std::size_t column = points.str().find("Name=\"temperature\"");
  BOOST_TEST_REQUIRE(column != std::string::npos);
  BOOST_TEST(numbers(points.str().substr(column), ">", 3) == std::vector<double>({310.0, 0.1, 1e5}),
             boost::test_tools::per_element());
  BOOST_TEST(contains(frame.str(), ":temperature:R:1"));
  BOOST_TEST(contains(frame.str(), " 310\n"));
  BOOST_TEST(!contains(cold.str(), "temperature"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::snapshot_test
