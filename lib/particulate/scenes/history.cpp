#include <particulate/scenes/history.hpp>

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <particulate/kinematics/energy.hpp>
#include <particulate/kinematics/momentum.hpp>

namespace particulate::scenes {

namespace {

// What memory() writes before the rows.
constexpr std::size_t counts = 5;

}  // namespace

History::History(const kinematics::Particles& particles, std::vector<double> times)
    : particles_(&particles), all_times_(times), times_(std::move(times)) {}

void History::name_columns() {
  columns_ = {"time [s]", "bulk [J/kg]", "relative [J/kg]"};
  if (potential_) columns_.emplace_back("potential [J/kg]");
  for (const char* further :
       {"lost [J/kg]", "momentum x [kg m/s]", "momentum y [kg m/s]", "momentum z [kg m/s]", "impacts", "overlap [m]"}) {
    columns_.emplace_back(further);
  }
  if (!has_temperatures_) return;
  for (const char* further : {"heat [J/kg]", "released [J/kg]", "temperature [K]"}) columns_.emplace_back(further);
}

void History::add_row(const schemes::State& at) {
  const bool empty = particles_->size() == 0;
  const double mass = empty ? 1.0 : particles_->mass.sum();
  const schemes::VectorsOf v = velocities(at);
  const kinematics::KineticEnergy kinetic =
      empty ? kinematics::KineticEnergy{} : kinematics::split_kinetic_energy(particles_->mass, v);
  const Eigen::Vector3d momentum = kinematics::linear_momentum(particles_->mass, v);
  values_.insert(values_.end(), {at.t, kinetic.bulk, kinetic.relative});
  if (potential_) values_.push_back(potential_(at) / mass);
  values_.insert(values_.end(), {lost_ / mass, momentum[0], momentum[1], momentum[2], impacts_, overlap_});
  if (has_temperatures_) { values_.insert(values_.end(), {heat_ / mass, released_ / mass, empty ? 0.0 : at.y.mean()}); }
}

void History::jumped(const schemes::State& after, const schemes::Jump& jump) {
  impacts_ += static_cast<double>(jump.impacts);
  lost_ -= jump.energy_change;
  overlap_ = std::max(overlap_, jump.overlap);
  heat_ += jump.heat;
  released_ += jump.released;
  // The row of the state before it.
  if (values_.empty() || rows()(rows().rows() - 1, 0) != after.t) return;
  values_.resize(values_.size() - columns_.size());
  add_row(after);
}

History::Rows History::rows() const {
  const auto width = static_cast<Eigen::Index>(columns_.size());
  return {values_.data(), static_cast<Eigen::Index>(values_.size()) / width, width};
}

std::vector<double> History::memory() const {
  std::vector<double> all = {impacts_, lost_, overlap_, heat_, released_};
  all.insert(all.end(), values_.begin(), values_.end());
  return all;
}

void History::remember(const std::vector<double>& memory) {
  const std::size_t width = columns_.size(), values = memory.size() < counts ? 1 : memory.size() - counts;
  bool fits = values % width == 0 && values / width <= all_times_.size();
  for (std::size_t row = 0; fits && row < values / width; ++row) fits = memory[counts + row * width] == all_times_[row];
  if (!fits) {
    throw std::invalid_argument(fmt::format(
        "history: what it goes on from must be of the same scene and the same times, {} columns a row and {} rows at "
        "most, got {} numbers: go on with the times of the run that was cut short",
        width, all_times_.size(), memory.size()));
  }
  impacts_ = memory[0];
  lost_ = memory[1];
  overlap_ = memory[2];
  heat_ = memory[3];
  released_ = memory[4];
  const auto begin = memory.begin() + counts;
  values_.assign(begin, memory.end());
  const auto left = all_times_.begin() + static_cast<std::ptrdiff_t>(values / width);
  times_ = schemes::detail::SampleTimes({left, all_times_.end()});
}

}  // namespace particulate::scenes
