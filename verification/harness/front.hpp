#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <harness/rows.hpp>

/// @file
/// Two parties in a diagram of error against run time: what the best of either costs at the same attained error.

namespace verification {

/// A point of a front: the least that any setting of a party costs for an error.
struct FrontPoint {
  double error = missing;   ///< largest error over the output times
  double cost = missing;    ///< evaluations, or seconds
  std::string method = {};  ///< whose it is
};

/// The methods of one party.
struct Party {
  std::string name;                  ///< as in the table: "collocation, adaptive"
  std::vector<std::string> methods;  ///< names of competitors
};

/// What a method costs at an error, from its points.
///
/// The front of a method is its points of which no cheaper one has a smaller error. Between two of them the cost is
/// interpolated, both axes logarithmic. Where the cheapest point is already better than asked, it is the cost.
///
/// @param points   of any methods and problems
/// @param problem  which of them
/// @param party    whose
/// @param error    to be attained, > 0
/// @param cost     of a point
/// @return the least cost over the methods; none if no method gets there
std::optional<FrontPoint> front(const std::vector<WorkPrecisionPoint>& points, const std::string& problem,
                                const Party& party, double error,
                                const std::function<double(const WorkPrecisionPoint&)>& cost);

/// The same of one method over that of another.
///
/// @param points   of any methods and problems
/// @param problem  which of them
/// @param method   whose
/// @param ruler    over whose
/// @param error    to be attained, > 0
/// @param cost     of a point
/// @return ratio; no number where one of them does not get there [-]
double cost_over(const std::vector<WorkPrecisionPoint>& points, const std::string& problem, const std::string& method,
                 const std::string& ruler, double error, const std::function<double(const WorkPrecisionPoint&)>& cost);

/// How many times fewer evaluations are claimed of a party, at 1e-4, 1e-6, 1e-8 and 1e-10: fewer than SUNDIALS before
/// 7.2 needs. A later one chooses longer steps; of it the same rows are left out.
struct FrontClaim {
  Party party;                   ///< who is better
  std::vector<double> at_least;  ///< one ratio for each error; 0: reported, not claimed
  std::string because;           ///< why no more is claimed
};

/// The errors at which parties are compared.
inline constexpr double front_errors[] = {1e-4, 1e-6, 1e-8, 1e-10};

/// Compares parties with SUNDIALS on a problem that has been measured: rows for the evaluations, which repeat bit for
/// bit, and a table `front_<problem>.csv` of evaluations, seconds and overhead, in which seconds are reported and never
/// claimed.
///
/// @param rows     where the points are, and where rows and table go
/// @param problem  its name
/// @param sundials methods of SUNDIALS
/// @param claims   one for each party
void compare_fronts(Rows& rows, const std::string& problem, const Party& sundials,
                    const std::vector<FrontClaim>& claims);

}  // namespace verification
