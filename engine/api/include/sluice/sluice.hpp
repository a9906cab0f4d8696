// All that other programs may use.
#pragma once

#include "field.hpp"       // IWYU pragma: export
#include "run.hpp"         // IWYU pragma: export
#include "scene.hpp"       // IWYU pragma: export
#include "simulation.hpp"  // IWYU pragma: export
#include "sluice/errors.hpp"      // IWYU pragma: export
