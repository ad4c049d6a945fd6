#include <harness/case.hpp>

#include <filesystem>
#include <utility>

#include <harness/registry.hpp>

namespace verification {

std::string_view name_of(Reference reference) {
  switch (reference) {
    case Reference::closed_form:
      return "closed form";
    case Reference::identity:
      return "identity";
    case Reference::sundials:
      return "SUNDIALS";
    case Reference::published:
      return "published";
    case Reference::independent_method:
      return "independent method";
    case Reference::convergence:
      return "convergence";
    case Reference::statistics:
      return "statistics";
    case Reference::design:
      return "design";
  }
  return "unknown";
}

// Cases are constants in many files: the list must exist before the first of them, whatever the order of the files.
std::vector<const Case*>& registry() {
  static std::vector<const Case*> cases;
  return cases;
}

Case::Case(Claim claim, std::function<void(Rows&)> proof, std::source_location where)
    : claim_(std::move(claim)), proof_(std::move(proof)) {
  const std::filesystem::path file = where.file_name();
  source_ = (file.parent_path().filename() / file.filename()).generic_string();
  registry().push_back(this);
}

}  // namespace verification
