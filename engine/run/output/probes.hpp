// Probes: the scene's measurements over time, as one table DIRECTORY/probes.csv.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/files/atomic_file.hpp"
#include "engine/files/background_writer.hpp"
#include "engine/run/output/probe_sampler.hpp"

namespace sluice {

/// The scene's probes, bound to the particles of the initial configuration.
template <int Dim>
class Probes {
  public:
    /// Throws SceneError for a probe that has nothing to measure.
    explicit Probes(const Simulation<Dim>& initial);

    /// Names with units; time is not among them.
    std::vector<std::string> columns() const;
    /// The present values, one per column.
    std::vector<double> sample(const Simulation<Dim>& simulation) const;

  private:
    std::vector<ProbeSamplerPtr<Dim>> samplers_;
};

/// Writes DIRECTORY/probes.csv by way of a BackgroundWriter: a heading, then a row per output time. Numbers are the
/// shortest that read back as the same double.
template <int Dim>
class ProbeWriter {
  public:
    /// Throws OutputError.
    ProbeWriter(const std::filesystem::path& directory, Probes<Dim> probes, BackgroundWriter& writer);
    /// Goes on with the table after its first `size` bytes. Throws OutputError if it has fewer.
    ProbeWriter(const std::filesystem::path& directory, Probes<Dim> probes, std::uint64_t size,
                BackgroundWriter& writer);

    std::vector<std::string> columns() const { return probes_.columns(); }
    std::vector<double> sample(const Simulation<Dim>& simulation) const { return probes_.sample(simulation); }
    /// Adds a row, to be written.
    void write(const Simulation<Dim>& simulation);
    /// Makes the disk take what is to be written before.
    void sync();
    /// Takes back the rows beyond its first `size` bytes; all must be written. Throws OutputError.
    void cut_back(std::uint64_t size);
    std::uint64_t size() const { return size_; }  ///< of the table, with what is to be written [bytes]

  private:
    std::string heading() const;

    Probes<Dim> probes_;
    LineFile file_;
    BackgroundWriter& writer_;
    std::uint64_t size_ = 0;
};

extern template class Probes<2>;
extern template class Probes<3>;
extern template class ProbeWriter<2>;
extern template class ProbeWriter<3>;

}  // namespace sluice
