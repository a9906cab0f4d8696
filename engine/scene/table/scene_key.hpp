// What the table of scene keys says of each key: its type, unit, range, default, and what it means.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/effects/effect_table.hpp"
#include "engine/scene/table/choices.hpp"

namespace sluice {

/// Ends belong to the range unless they are open.
struct NumberRange {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool open_low = false, open_high = false;

    constexpr bool holds(double v) const {
        return (open_low ? v > low : v >= low) && (open_high ? v < high : v <= high);
    }
    /// "a number > 0", "a number in (0, 1]".
    std::string text() const;
};

enum class KeyType {
    text,
    number,
    whole,     ///< a number without fraction
    word,      ///< one of a few
    vector,    ///< as many numbers as the scene has dimensions
    formula,   ///< or a number
    formulas,  ///< as many as the scene has dimensions
    station,   ///< x in 2D, [x, z] in 3D; or a whole vector
    sides,     ///< [low, high]
    shape,
    shapes,
    vertices,  ///< pairs of numbers
    rows,      ///< of a motion: time, then a vector
    texts,
    table,  ///< of keys that the table of keys lists
    names   ///< a table of the user's own names
};

struct KeyValue {
    KeyType type = KeyType::text;
    std::string_view unit = "";
    NumberRange range = {};                        ///< of numbers
    std::span<const std::string_view> words = {};  ///< to choose from: the word_list of an enumeration
    Variable variables = Variable::place;          ///< of a formula
};

/// What holds where a scene leaves a key out.
struct Otherwise {
    enum class Kind { required, value, said };
    Kind kind = Kind::required;
    std::string_view text = "";   ///< a value as TOML, that of the preset "modern"; or in words
    std::string_view paper = "";  ///< the value of the preset "paper" if it is another
};

struct SceneKey {
    std::string_view path;  ///< "bodies.*.spacing": `*` is a name of the user's; shapes start at "SHAPE"
    KeyValue value;
    Otherwise otherwise;
    std::string_view meaning;
    /// In a table with `kind`: the kinds that it belongs to, apart by spaces, with `?` where it is not required.
    /// Elsewhere in words, as "2D". Empty = always.
    std::string_view only = "";
    std::optional<Effect> effect = {};  ///< that it is for; none = none in particular
};

/// The table that the key stands in: "bodies.*"; empty for the top level.
std::string_view table_of(const SceneKey& key);
/// "spacing"; "*" for a name of the user's.
std::string_view name_of(const SceneKey& key);
/// "bodies.NAME.spacing"
std::string shown_path(const SceneKey& key);
/// "bodies.NAME", as shown_path has it, for a table's pattern.
std::string shown_pattern(std::string_view pattern);

/// `text` at its spaces.
std::vector<std::string> words_in(std::string_view text);

/// The words to choose from.
std::vector<std::string> choices_of(const SceneKey& key);

/// "a number > 0 [m]": what a message tells of the values that the key takes in a scene of this dimension.
std::string expected_text(const SceneKey& key, int dimension);

}  // namespace sluice
