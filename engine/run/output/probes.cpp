#include "engine/run/output/probes.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <utility>

#include "engine/base/errors.hpp"

namespace sluice {
namespace {

template <int Dim>
ProbeSamplerPtr<Dim> make_sampler(const Probe& probe, const Simulation<Dim>& initial) {
    switch (probe.kind) {
        case ProbeKind::displacement:
            return make_displacement_probe<Dim>(probe, initial);
        case ProbeKind::pressure:
            return make_pressure_probe<Dim>(probe, initial);
        case ProbeKind::water_level:
            return make_level_probe<Dim>(probe, initial);
        case ProbeKind::energy:
            return make_energy_probe<Dim>(probe);
        case ProbeKind::momentum:
            return make_momentum_probe<Dim>(probe);
        case ProbeKind::force:
            return make_force_probe<Dim>(probe);
        case ProbeKind::velocity_error:
            return make_velocity_error_probe<Dim>(probe, initial);
    }
    throw std::logic_error("probe '" + probe.name + "': unknown kind");
}

}  // namespace

template <int Dim>
Probes<Dim>::Probes(const Simulation<Dim>& initial) {
    for (const Probe& probe : initial.scene().probes) samplers_.push_back(make_sampler<Dim>(probe, initial));
}

template <int Dim>
std::vector<std::string> Probes<Dim>::columns() const {
    std::vector<std::string> all;
    for (const auto& sampler : samplers_)
        for (std::string& column : sampler->columns()) all.push_back(std::move(column));
    return all;
}

template <int Dim>
std::vector<double> Probes<Dim>::sample(const Simulation<Dim>& simulation) const {
    std::vector<double> values;
    for (const auto& sampler : samplers_) sampler->sample(simulation, values);
    return values;
}

template <int Dim>
ProbeWriter<Dim>::ProbeWriter(const std::filesystem::path& directory, Probes<Dim> probes, BackgroundWriter& writer)
    : probes_(std::move(probes)), file_(directory / "probes.csv"), writer_(writer) {
    file_.append(heading());
    size_ = file_.size();
}

template <int Dim>
ProbeWriter<Dim>::ProbeWriter(const std::filesystem::path& directory, Probes<Dim> probes, std::uint64_t size,
                              BackgroundWriter& writer)
    : probes_(std::move(probes)), file_(directory / "probes.csv", size), writer_(writer), size_(size) {
    std::ifstream table(directory / "probes.csv");
    std::string found;
    std::getline(table, found);
    if (found != heading())
        throw OutputError(fmt::format("{}: cannot go on: found other columns than the scene's probes have",
                                      (directory / "probes.csv").string()));
}

template <int Dim>
std::string ProbeWriter<Dim>::heading() const {
    std::string text = "t [s]";
    for (const std::string& column : columns()) text += "," + column;  // names hold neither commas nor quotes
    return text;
}

template <int Dim>
void ProbeWriter<Dim>::write(const Simulation<Dim>& simulation) {
    std::string row = fmt::format("{}", simulation.time());
    for (const double value : sample(simulation)) row += fmt::format(",{}", value);
    size_ += row.size() + 1;  // the end of line
    const std::size_t bytes = row.size();
    writer_.add(bytes, [this, row = std::move(row)] { file_.append(row); });
}

template <int Dim>
void ProbeWriter<Dim>::sync() {
    writer_.add(0, [this] { file_.sync(); });
}

template <int Dim>
void ProbeWriter<Dim>::cut_back(std::uint64_t size) {
    file_.cut_back(size);
    size_ = file_.size();
}

template class Probes<2>;
template class Probes<3>;
template class ProbeWriter<2>;
template class ProbeWriter<3>;

}  // namespace sluice
