#include "engine/scene/formula.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "engine/scene/table/excerpt.hpp"
#include "engine/scene/table/scene_key.hpp"

namespace sluice {
namespace {

// Where a formula is tried when it is compiled: three values that no sensible assignment would leave in place.
constexpr Point trial{0.337, 0.571, 0.793};
constexpr double trial_time = 0.419;

/// muParser ends its sentences; ours go on.
std::string without_end(std::string sentence) {
    if (sentence.ends_with('.')) sentence.pop_back();
    return sentence;
}

}  // namespace

struct CompiledFormula::Impl {
    const Scene* scene;
    std::string key;
    Formula text;
    Variable variable;
    mu::Parser parser;
    Point at = trial;
    double time = trial_time;  ///< beside a place

    /// `message` with the key, what was found, and what may be used.
    [[noreturn]] void fail(const std::string& problem) const {
        std::string names = fmt::format("{}, pi", fmt::join(words_in(word_of(variable)), ", "));
        for (const auto& [name, value] : scene->constants) names += ", " + name;
        scene->fail(key, fmt::format("found \"{}\": {}, expected a formula in {}", excerpt(text), problem, names));
    }

    void define_variables() {
        switch (variable) {
            case Variable::time:
                parser.DefineVar("t", &at[0]);
                return;
            case Variable::place:
                break;
            case Variable::place_and_time:
                parser.DefineVar("t", &time);
                break;
        }
        parser.DefineVar("x", &at[0]);
        parser.DefineVar("y", &at[1]);
        parser.DefineVar("z", &at[2]);
    }

    /// What the action returns; muParser's own complaints become scene errors.
    template <class Action>
    auto guarded(Action&& action) const {
        try {
            return action();
        } catch (const mu::Parser::exception_type& error) {
            fail(error.GetCode() == mu::ecUNASSIGNABLE_TOKEN ? fmt::format("\"{}\" is not known", error.GetToken())
                                                             : without_end(error.GetMsg()));
        }
    }

    /// One value.
    double evaluate() {
        return guarded([this] {
            int values = 0;
            const double* result = parser.Eval(values);
            if (values != 1) fail(fmt::format("{} values", values));
            return result[0];
        });
    }
};

CompiledFormula::CompiledFormula(const Scene& scene, std::string key, const Formula& text, Variable variable)
    : impl_(std::make_unique<Impl>()) {
    impl_->scene = &scene;
    impl_->key = std::move(key);
    impl_->text = text;
    impl_->variable = variable;
    impl_->define_variables();
    mu::Parser& parser = impl_->parser;
    parser.DefineConst("pi", std::numbers::pi);
    for (const auto& [name, value] : scene.constants) parser.DefineConst(name, value);
    impl_->guarded([&] { parser.SetExpr(text.empty() ? "0" : text); });
    impl_->evaluate();
    if (impl_->at != trial || impl_->time != trial_time) impl_->fail("an assignment (to compare, write ==)");
}

CompiledFormula::~CompiledFormula() = default;
CompiledFormula::CompiledFormula(CompiledFormula&&) noexcept = default;
CompiledFormula& CompiledFormula::operator=(CompiledFormula&&) noexcept = default;

double CompiledFormula::operator()(const Point& p) const {
    impl_->at = p;
    const double value = impl_->evaluate();
    if (std::isfinite(value)) return value;
    switch (impl_->variable) {
        case Variable::time:
            impl_->fail(fmt::format("{} at t = {} s", value, p[0]));
        case Variable::place:
        case Variable::place_and_time:
            break;
    }
    impl_->fail(fmt::format("{} at ({}, {}, {})", value, p[0], p[1], p[2]));
}

double CompiledFormula::at(const Point& p, double t) const {
    impl_->at = p;
    impl_->time = t;
    const double value = impl_->evaluate();
    if (!std::isfinite(value)) impl_->fail(fmt::format("{} at ({}, {}, {}), t = {} s", value, p[0], p[1], p[2], t));
    return value;
}

std::string constant_name_problem(const std::string& name) {
    const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
    const bool is_word = !name.empty() && letters.find(name[0]) != std::string::npos &&
                         name.find_first_not_of(letters + "0123456789") == std::string::npos;
    if (!is_word) return "a name that is not made of letters, digits and _";
    const mu::Parser parser;
    if (name == "x" || name == "y" || name == "z" || name == "t" || name == "pi" || parser.GetConst().contains(name))
        return "a name that formulas have already";
    if (parser.GetFunDef().contains(name)) return "the name of a function";
    return "";
}

}  // namespace sluice
