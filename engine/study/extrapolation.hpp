// The limit of runs at ever smaller spacing, where nothing better is known: Richardson's extrapolation.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sluice {

/// A result at one spacing: one number, or a curve at times that all results share.
struct SpacedResult {
    double spacing = 0;  ///< [m]
    std::vector<double> value;
};

struct Extrapolation {
    std::vector<double> value;    ///< at spacing 0, or of the finest run if that is not to be had
    double uncertainty = 0;       ///< root of the mean square over the values
    std::optional<double> order;  ///< observed; none if no order fits
    bool is_credible = false;
    std::string note;  ///< for people: order and uncertainty, or why there is none
};

/// From results f(d) = f0 + C d^p at the three finest spacings d1 < d2 < d3 of any ratios [Roache, J. Fluids Eng. 116
/// (1994) 405-413]; p from the norms of the differences,
///   |f3 − f2| / |f2 − f1| = (d3^p − d2^p) / (d2^p − d1^p)
///   f0 = f1 + (f1 − f2) d1^p / (d2^p − d1^p),   uncertainty 1.25 |f1 − f0|
/// Credible if both differences point the same way and p lies within 0.5 to 4. Otherwise the finest result stands, its
/// uncertainty the largest difference among the three. `results`: two or more, in any order. Throws std::logic_error
/// for fewer.
Extrapolation extrapolate(std::vector<SpacedResult> results);

}  // namespace sluice
