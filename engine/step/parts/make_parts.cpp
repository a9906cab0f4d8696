#include "engine/step/parts/make_parts.hpp"

#include "engine/step/parts/fluid.hpp"
#include "engine/step/parts/hyperelastic_solid.hpp"
#include "engine/step/parts/hypoelastic_solid.hpp"
#include "engine/step/parts/wall.hpp"

namespace sluice {

template <int Dim>
std::vector<std::unique_ptr<Part<Dim>>> make_parts(StepContext<Dim>& context) {
    std::vector<std::unique_ptr<SolidPart<Dim>>> solids;
    if (context.has(Effect::solid_stress)) solids.push_back(std::make_unique<HypoelasticSolid<Dim>>(context));
    if (context.has(Effect::total_lagrangian)) solids.push_back(std::make_unique<HyperelasticSolid<Dim>>(context));
    std::vector<std::unique_ptr<Part<Dim>>> parts;
    if (context.has(Effect::fluid_pressure)) parts.push_back(std::make_unique<FluidPart<Dim>>(context));
    if (!solids.empty()) parts.push_back(std::make_unique<Solids<Dim>>(context, std::move(solids)));
    if (context.has(Effect::moving_wall)) parts.push_back(std::make_unique<WallPart<Dim>>(context));
    return parts;
}

template std::vector<std::unique_ptr<Part<2>>> make_parts<2>(StepContext<2>&);
template std::vector<std::unique_ptr<Part<3>>> make_parts<3>(StepContext<3>&);

}  // namespace sluice
