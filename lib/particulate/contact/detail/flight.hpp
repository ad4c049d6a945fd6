#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <particulate/contact/detail/event_queue.hpp>
#include <particulate/contact/detail/moving_cells.hpp>
#include <particulate/contact/hard_spheres.hpp>

namespace particulate::contact::detail {

// Two that meet, the number of i the lower one, or a body and a wall. Bodies are named by their places in memory.
struct Meeting {
  std::int32_t i, j = -1, wall = -1;  // one of the last two is negative
  Eigen::Vector3d r, n;               // along r approaches are seen; unit vector
  double overlap;
};

// The free flight of hard spheres: who meets whom, and when. Bodies are kept in an order in which those near each other
// are so in memory, which changes nothing that is told: at one time the lower number comes first.
class Flight {
 public:
  Flight(const Gas& gas, const schemes::State& state, double t_end);

  bool has_ended() const { return N_ == 0 || queue_.first_time() > end_; }
  // Lets the next event happen: if two meet, the caller has them part, and flies on with both.
  std::optional<Meeting> happen();
  void fly_on(const Meeting& after);
  // Counts time from now on, so that no digit of what is to come is lost to what has been: returns what now was.
  double renew();
  void end() { now_ = end_; }

  double now() const { return now_; }
  bool is_at_end() const { return now_ == end_; }
  schemes::State moment() const;  // of no bodies
  std::int32_t number(std::int32_t i) const { return plans_[at(i)].number; }
  Body body(std::int32_t i) const {
    return i < 0 ? Body{} : Body{.velocity = spheres_[at(i)].v, .inverse_mass = gas_.inverse_mass[number(i)]};
  }
  void push(const Meeting& who, const Eigen::Vector3d& impulse);
  // Size of the places that a gap is the difference of.
  double extent(std::int32_t i, std::int32_t j) const;
  // An approach as fast is none.
  double noise(std::int32_t i, std::int32_t j) const;
  // Writes places and velocities of now.
  void leave(schemes::State& state);

  long crossings = 0, predictions = 0;

 private:
  // What a pair is tested by: one line of the cache.
  struct alignas(64) Sphere {
    Eigen::Vector3d r, v;
    double t, b;  // of r; radius
  };
  // What a body will do next.
  struct alignas(64) Plan {
    double meets, leaves;                             // its cell
    Eigen::Vector3d image = Eigen::Vector3d::Zero();  // periods between the two, of places that are not wrapped
    std::int32_t partner;
    std::uint32_t impacts;  // of the partner, when it was planned: one more, and it is off
    std::int32_t axis = 0;
    std::int32_t number;            // of this body, for the user
    std::uint32_t own_impacts = 0;  // of this body
    double next() const { return std::min(meets, leaves); }
  };
  struct Candidate {
    std::int32_t j;
    Eigen::Vector3d image;
  };
  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

  Eigen::Vector3d place(const Sphere& of) const { return of.r + (now_ - of.t) * of.v; }
  void note(std::int32_t j, const Eigen::Vector3d& image) {
    __builtin_prefetch(&spheres_[at(j)]);
    candidates_.push_back({j, image});
  }
  double height(std::int32_t i, std::int32_t k) const;
  bool can_meet(std::int32_t i, std::int32_t j) const {
    return gas_.particles.immovable.empty() || gas_.inverse_mass[number(i)] > 0.0 || gas_.inverse_mass[number(j)] > 0.0;
  }
  double touching(std::int32_t i, std::int32_t j, double u) const;
  std::pair<std::int32_t, std::int32_t> numbers(std::int32_t i) const;
  auto ties() const;

  void sort();
  void line_up();
  void plan_all();
  void fill_queue();
  void bring(std::int32_t i);
  void plan_again(std::int32_t i);
  void plan_meeting(std::int32_t i);
  void plan_wall(std::int32_t i, std::int32_t k, Plan& plan) const;
  void plan_pairs(std::int32_t i);
  void plan_leaving(std::int32_t i);
  void cross(std::int32_t i);
  Meeting meeting(std::int32_t i);

  const Gas& gas_;
  std::int32_t N_;
  Eigen::Vector3d lengths_;  // periods; 0: there is none
  double end_ = 0.0, now_ = 0.0, edge_ = 0.0;
  schemes::State epoch_;  // from which now_ counts
  double t_end_;
  std::vector<Sphere> spheres_;
  std::vector<Plan> plans_;
  std::vector<Eigen::Vector3d> periods_;  // by which places were wrapped
  std::vector<Candidate> candidates_;
  EventQueue queue_;
  std::optional<MovingCells> cells_;  // none: no two bodies
  long renewals_ = 0;
};

}  // namespace particulate::contact::detail
