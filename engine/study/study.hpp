// A study: one scene run over a matrix of settings; what each run cost, and how far it was from the truth.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/scene/table/word.hpp"

namespace sluice {

/// The key whose values make up a line of the diagram; all other varied keys make up a method.
inline constexpr const char* spacing_key_name = "method.spacing";

/// A key that is varied, and its values as `--set` takes them.
struct Axis {
    std::string key;
    std::vector<std::string> values;
};

enum class PointState { missing, done, failed };
template <>
inline constexpr std::array words_of<PointState>{
    Word{PointState::missing, "missing"},
    Word{PointState::done, "done"},
    Word{PointState::failed, "failed"},
};

/// One setting of the matrix.
struct StudyPoint {
    std::vector<std::string> values;  ///< one per axis
    std::size_t method = 0;           ///< index into Study::methods
    double spacing = 0;               ///< [m]
    PointState state = PointState::missing;
    std::string reason;                        ///< why it failed, in one line
    std::vector<double> cpu, wall;             ///< of each repeat [s]
    std::vector<std::optional<double>> error;  ///< one per quantity, relative; none = could not be measured

    double cpu_seconds() const;   ///< median [s]
    double wall_seconds() const;  ///< median [s]
};

/// One measure of error.
struct Quantity {
    std::string name;
    std::string meaning;                ///< what is compared with what
    double scale = 1;                   ///< what an error of 100 % is, in the probe's unit
    std::string unit;                   ///< of the error; "m"
    std::optional<double> uncertainty;  ///< of the truth, relative
    bool extrapolated = false;          ///< whether the truth is the finest runs' own
    std::string note;                   ///< what has to be known about the truth
};

struct Machine {
    std::string processor;
    int processors = 0;
    std::string instruction_set;
    double load = 0;  ///< average over a minute, when the study began
};

struct Study {
    std::string title, scene;  ///< of the scene; name of its file
    std::string fingerprint;   ///< of the scene without what is varied
    std::string version, date;
    Machine machine;
    int dimension = 2;
    int threads = 1;
    int repeats = 1;
    std::vector<Axis> axes;
    std::vector<std::string> settings;  ///< changes that all runs share: key=value
    std::vector<std::string> methods;
    std::vector<Quantity> quantities;
    std::vector<StudyPoint> points;

    bool is_complete() const;
};

/// Points of a method that are done and have this quantity, coarse to fine.
std::vector<const StudyPoint*> points_of(const Study& study, std::size_t method, std::size_t quantity);

/// 0 without values.
double median(std::vector<double> values);

}  // namespace sluice
