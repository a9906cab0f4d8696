// A scene, read and checked.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sluice/errors.hpp"
#include "sluice/export.hpp"

namespace sluice {
struct Scene;
}

/// What other programs may build on: scenes, simulations, runs. It needs nothing but the standard library, and changes
/// incompatibly only with the version's second number (after 1.0 with its first).
namespace sluice::api {

/// An immutable scene; copies share it.
class SLUICE_API Scene {
  public:
    /// Reads and checks a scene file. Each change is a `key.path=value`, as with `sluice run --set`. Throws SceneError.
    static Scene from_file(const std::string& path, const std::vector<std::string>& changes = {});
    /// The same for a text. `name` stands for the file in messages; files that the scene names are sought beside it.
    static Scene from_text(const std::string& text, const std::vector<std::string>& changes = {},
                           const std::string& name = "scene");

    std::string title() const;
    int dimension() const;
    double end_time() const;                  ///< to which a run goes [s]
    std::string text() const;                 ///< with the changes applied, as canonical TOML
    std::vector<std::string> bodies() const;  ///< names; the field `body` of fluid and solid particles counts them
    std::vector<std::string> walls() const;   ///< names; the field `body` of wall particles counts them

    /// For the engine itself.
    const sluice::Scene& checked() const { return *scene_; }

  private:
    explicit Scene(std::shared_ptr<const sluice::Scene> scene);

    std::shared_ptr<const sluice::Scene> scene_;
};

}  // namespace sluice::api
