#pragma once

#include <cstdint>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

namespace verification {

/// Numbers evenly distributed in [0, 1), the same everywhere.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return uniform_(engine_); }

 private:
  boost::random::mt19937_64 engine_;
  boost::random::uniform_01<double> uniform_;
};

}  // namespace verification
