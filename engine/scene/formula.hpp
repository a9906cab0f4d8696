// A formula of the scene, ready to be evaluated at points or times.
#pragma once

#include <memory>
#include <string>

#include "engine/scene/scene.hpp"

namespace sluice {

/// Knows its variables, pi, the scene's [constants] and muParser's functions. Must not outlive the scene; one thread at
/// a time.
class CompiledFormula {
  public:
    /// Throws SceneError at `key` for a text that is no formula. An empty text is 0.
    CompiledFormula(const Scene& scene, std::string key, const Formula& text, Variable variable = Variable::place);
    ~CompiledFormula();
    CompiledFormula(CompiledFormula&&) noexcept;
    CompiledFormula& operator=(CompiledFormula&&) noexcept;

    /// Throws SceneError where the value is not finite.
    double operator()(const Point& p) const;
    /// At a time [s].
    double operator()(double t) const { return (*this)(Point{t, 0, 0}); }
    /// At a place and a time [s].
    double at(const Point& p, double t) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Empty if formulas may use a constant of this name, otherwise what is wrong with it.
std::string constant_name_problem(const std::string& name);

}  // namespace sluice
