#include "engine/scene/scene.hpp"

#include "engine/scene/place.hpp"

namespace sluice {

void Scene::fail(const std::string& key, const std::string& message) const {
    throw SceneError(located(*this, key, message));
}

}  // namespace sluice
