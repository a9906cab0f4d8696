// Random numbers that are the same with every library and compiler.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace random_scenes {

class Random {
  public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}

    /// In [0, 1).
    double unit() { return std::ldexp(static_cast<double>(bits_() >> 11), -53); }
    double between(double low, double high) { return low + (high - low) * unit(); }
    /// As often below the geometric mean as above.
    double scaled(double low, double high) { return low * std::pow(high / low, unit()); }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(unit() * static_cast<double>(n)); }
    bool chance(double share) { return unit() < share; }
    template <class T>
    const T& one_of(const std::vector<T>& all) {
        return all[below(all.size())];
    }
    std::string word(const std::vector<std::string>& all) { return one_of(all); }

  private:
    std::mt19937_64 bits_;
};

}  // namespace random_scenes
