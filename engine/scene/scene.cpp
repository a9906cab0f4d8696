#include "engine/scene/scene.hpp"

#include "engine/scene/describe.hpp"

namespace sluice {

bool Probe::has_place() const {
    switch (kind) {
        case ProbeKind::displacement:
        case ProbeKind::pressure:
        case ProbeKind::water_level:
            return true;
        case ProbeKind::energy:
        case ProbeKind::momentum:
        case ProbeKind::force:
        case ProbeKind::velocity_error:
            break;
    }
    return false;
}

void Scene::fail(const std::string& key, const std::string& message) const {
    throw SceneError(located(*this, key, message));
}

}  // namespace sluice
