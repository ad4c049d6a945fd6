#include <particulate/report/files.hpp>

#include <stdexcept>
#include <vector>

#include <sys/stat.h>

#include "report/full_disk.hpp"
#include "says.hpp"
#include "scratch_folder.hpp"

namespace tests::files_test {

using namespace particulate::report;

BOOST_AUTO_TEST_SUITE(write_whole_)

BOOST_AUTO_TEST_CASE(replaces_the_old_content_and_leaves_nothing_else) {
  const ScratchFolder folder;
  const std::string binary("new\0\r\n", 6);
  write_whole(folder.path() / "rows.csv", "old and longer");
  write_whole(folder.path() / "rows.csv", binary);
  BOOST_TEST(read_whole(folder.path() / "rows.csv") == binary);
  BOOST_TEST(folder.files() == std::vector<std::string>{"rows.csv"}, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(gives_the_file_the_usual_permissions) {
  const ScratchFolder folder;
  const mode_t mask = ::umask(022);
  write_whole(folder.path() / "rows.csv", "x");
  ::umask(mask);
  struct stat status {};
  ::stat((folder.path() / "rows.csv").c_str(), &status);
  BOOST_TEST((status.st_mode & 0777U) == 0644U);
}

BOOST_AUTO_TEST_CASE(a_write_that_fails_half_way_leaves_the_old_file_and_no_temporary_one) {
  const ScratchFolder folder;
  const std::filesystem::path path = folder.path() / "rows.csv";
  write_whole(path, "old");
  {
    const FullDisk full(1000);
    BOOST_CHECK_EXCEPTION(write_whole(path, std::string(5000, 'x')), std::runtime_error,
                          says("rows.csv cannot be written: File too large. Name a folder"));
  }
  BOOST_TEST(read_whole(path) == "old");
  BOOST_TEST(folder.files().size() == 1U);
}

BOOST_AUTO_TEST_CASE(names_the_path_and_the_reason) {
  const ScratchFolder folder;
  BOOST_CHECK_EXCEPTION(write_whole(folder.path() / "none" / "rows.csv", "x"), std::runtime_error,
                        says("none/rows.csv cannot be written: No such file or directory"));
  std::filesystem::create_directory(folder.path() / "taken");
  BOOST_CHECK_EXCEPTION(write_whole(folder.path() / "taken", "x"), std::runtime_error, says("Is a directory"));
  BOOST_TEST(folder.files().size() == 1U);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(read_whole_)

BOOST_AUTO_TEST_CASE(names_a_file_that_is_not_there) {
  BOOST_CHECK_EXCEPTION(read_whole("no/such.toml"), std::runtime_error,
                        says("no/such.toml cannot be read: No such file or directory"));
  BOOST_CHECK_EXCEPTION(read_whole("/"), std::runtime_error, says("/ cannot be read: Is a directory"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(prepare_folder_)

BOOST_AUTO_TEST_CASE(makes_the_folder_and_those_above_it_and_leaves_it_empty) {
  const ScratchFolder folder;
  prepare_folder(folder.path() / "a" / "b");
  BOOST_TEST(std::filesystem::is_empty(folder.path() / "a" / "b"));
}

BOOST_AUTO_TEST_CASE(refuses_a_place_where_no_folder_can_be) {
  const ScratchFolder folder;
  write_whole(folder.path() / "file", "x");
  BOOST_CHECK_EXCEPTION(prepare_folder(folder.path() / "file" / "below"), std::runtime_error,
                        says("Not a directory. Name another folder."));
  BOOST_CHECK_THROW(prepare_folder(folder.path() / "file"), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(refuses_a_folder_that_takes_no_bytes) {
  const ScratchFolder folder;
  const FullDisk full(0);
  BOOST_CHECK_EXCEPTION(prepare_folder(folder.path()), std::runtime_error, says("cannot be written: File too large"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace tests::files_test
