// What can go wrong: with a scene, with its computation, with files.
#pragma once

#include <stdexcept>

#include "export.hpp"

namespace sluice {

/// What is wrong with a scene, as one readable text: `file:line: key: what was found, what was expected`.
class SLUICE_API SceneError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The computed state has become meaningless: not finite, or beyond what the method can represent.
class SLUICE_API NumericalError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A result could not be written. The text names the path and what the system answered.
class SLUICE_API OutputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A checkpoint is missing, damaged, or of another scene. The text names file and reason.
class SLUICE_API CheckpointError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The folder of a run, or a file in it, cannot be read back. The text names path and reason.
class SLUICE_API RunReadError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace sluice
