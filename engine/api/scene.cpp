#include "engine/api/include/sluice/scene.hpp"

#include "engine/scene/scene.hpp"

namespace sluice::api {
namespace {

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
    std::vector<std::string> names;
    for (const Named& one : all) names.push_back(one.name);
    return names;
}

}  // namespace

Scene::Scene(std::shared_ptr<const sluice::Scene> scene) : scene_(std::move(scene)) {}

Scene Scene::from_file(const std::string& path, const std::vector<std::string>& changes) {
    return Scene(std::make_shared<sluice::Scene>(load_scene(path, changes)));
}

Scene Scene::from_text(const std::string& text, const std::vector<std::string>& changes, const std::string& name) {
    return Scene(std::make_shared<sluice::Scene>(parse_scene(text, name, changes)));
}

std::string Scene::title() const { return scene_->title; }
int Scene::dimension() const { return scene_->dimension; }
double Scene::end_time() const { return scene_->output.end; }
std::string Scene::text() const { return scene_->source; }
std::vector<std::string> Scene::bodies() const { return names_of(scene_->bodies); }
std::vector<std::string> Scene::walls() const { return names_of(scene_->walls); }

}  // namespace sluice::api
