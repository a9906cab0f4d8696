// What a probe should show: the truth that a study measures errors against. A run has no use for it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/scene/table/choices.hpp"

namespace sluice {

/// Whether curves are compared point by point.
constexpr bool is_pointwise(Measure measure) {
    switch (measure) {
        case Measure::rms:
        case Measure::max:
            return true;
        case Measure::peak:
        case Measure::peak_time:
        case Measure::period:
        case Measure::final:
        case Measure::mean:
            break;
    }
    return false;
}

/// At most one of formula, table and number is given; with none, the finest runs of a study stand in.
struct Reference {
    std::string name;
    std::string column;  ///< of probes.csv, without its unit: "free_end.x"
    Measure measure = Measure::rms;
    std::string formula;                ///< in t
    std::vector<double> time, value;    ///< the table
    std::optional<double> number;       ///< what the measure should give
    std::string table_file;             ///< as the scene states it
    double from = 0;                    ///< what is before is not compared [s]
    std::optional<double> to;           ///< nor what comes after; none = the end [s]
    std::optional<double> scale;        ///< that relative errors refer to; none = the reference's own size
    std::optional<double> uncertainty;  ///< of the reference, in the unit of the error
    std::string source;                 ///< where it was published

    bool is_stated() const { return !formula.empty() || !time.empty() || number.has_value(); }
};

}  // namespace sluice
