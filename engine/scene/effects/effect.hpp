// The effects that a scene can have, by name. What each of them is: effect_table.hpp.
#pragma once

#include <array>
#include <cstddef>

namespace sluice {

enum class Effect {
#define SLUICE_EFFECT(key, ...) key,
#include "engine/scene/effects/effects.def"
#undef SLUICE_EFFECT
};

inline constexpr std::size_t effect_count = 0
#define SLUICE_EFFECT(...) +1
#include "engine/scene/effects/effects.def"
#undef SLUICE_EFFECT
    ;

/// A value for each effect.
template <class T>
class PerEffect {
  public:
    constexpr T& operator[](Effect e) { return values_[static_cast<std::size_t>(e)]; }
    constexpr const T& operator[](Effect e) const { return values_[static_cast<std::size_t>(e)]; }

    static constexpr std::size_t size() { return effect_count; }
    /// In the order of the table.
    constexpr auto begin() const { return values_.begin(); }
    constexpr auto end() const { return values_.end(); }

    friend constexpr bool operator==(const PerEffect&, const PerEffect&) = default;

  private:
    std::array<T, effect_count> values_{};
};

}  // namespace sluice
