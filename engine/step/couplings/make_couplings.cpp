#include "engine/step/couplings/make_couplings.hpp"

#include "engine/step/couplings/boundary_coupling.hpp"
#include "engine/step/couplings/contact.hpp"
#include "engine/step/couplings/interface_coupling.hpp"
#include "engine/step/couplings/wall_coupling.hpp"

namespace sluice {

template <int Dim>
std::vector<std::unique_ptr<Coupling<Dim>>> make_couplings(StepContext<Dim>& context) {
    std::vector<std::unique_ptr<Coupling<Dim>>> couplings;
    if (context.has(Effect::fixed_wall)) couplings.push_back(std::make_unique<WallCoupling<Dim>>(context));
    if (context.has(Effect::contact)) couplings.push_back(std::make_unique<SolidContact<Dim>>(context));
    if (context.has(Effect::interface_force)) couplings.push_back(std::make_unique<InterfaceCoupling<Dim>>(context));
    if (context.has(Effect::moving_boundary)) couplings.push_back(std::make_unique<BoundaryCoupling<Dim>>(context));
    return couplings;
}

template std::vector<std::unique_ptr<Coupling<2>>> make_couplings<2>(StepContext<2>&);
template std::vector<std::unique_ptr<Coupling<3>>> make_couplings<3>(StepContext<3>&);

}  // namespace sluice
