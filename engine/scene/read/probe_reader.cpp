#include <fmt/format.h>

#include "engine/scene/read/reader_parts.hpp"

namespace sluice {
namespace {

std::size_t read_body_of(const TomlValue& value) {
    std::vector<std::string> names;
    for (const Body& body : value.scene().bodies) names.push_back(body.name);
    return value.name(names);
}

std::size_t read_solid_of(const TomlValue& value) {
    const std::size_t body = read_body_of(value);
    const Scene& scene = value.scene();
    if (scene.materials[scene.bodies[body].material].kind != MaterialKind::solid)
        value.fail(fmt::format("found \"{}\", a fluid, expected a solid body", scene.bodies[body].name));
    return body;
}

std::size_t read_fluid_of(const TomlValue& value) {
    const std::size_t body = read_body_of(value);
    const Scene& scene = value.scene();
    if (scene.materials[scene.bodies[body].material].kind != MaterialKind::fluid)
        value.fail(fmt::format("found \"{}\", a solid, expected a fluid body", scene.bodies[body].name));
    return body;
}

/// A station that the level is taken over: x in 2D, [x, z] in 3D.
Point read_station(const TomlValue& value) {
    const bool flat = value.scene().dimension == 2;
    if (flat && value && value.node()->is_number()) return {value.number(), 0, 0};
    const std::string_view expected = flat ? "a number x" : "2 numbers [x, z]";
    const std::vector<TomlValue> values = value.items(expected);
    if (values.size() != (flat ? 1 : 2)) value.reject(expected);
    return {values[0].number(), 0, flat ? 0 : values[1].number()};
}

Probe read_probe(TomlTable& table, const std::string& name) {
    check_name(table, name);
    Probe probe;
    probe.name = name;
    probe.kind = table.get("kind").choice<ProbeKind>();
    switch (probe.kind) {
        case ProbeKind::displacement:
            probe.body = read_solid_of(table.get("body"));
            probe.at = table.get("at").point();
            break;
        case ProbeKind::pressure:
            if (const auto body = table.get("body")) probe.body = read_body_of(body);
            probe.at = table.get("at").point();
            break;
        case ProbeKind::water_level:
            probe.at = read_station(table.get("at"));
            break;
        case ProbeKind::force:
            probe.body = read_solid_of(table.get("body"));
            break;
        case ProbeKind::velocity_error:
            probe.body = read_fluid_of(table.get("body"));
            probe.velocity = read_formulas(table.get("velocity"));
            break;
        case ProbeKind::energy:
        case ProbeKind::momentum:
            break;
    }
    table.finish();
    return probe;
}

}  // namespace

void read_probes(TomlTable& root) {
    const TomlValue value = root.get("probes");
    if (!value) return;
    TomlTable all(value);
    for (const std::string& name : all.keys()) {
        TomlTable table(all.get(name));
        root.scene().probes.push_back(read_probe(table, name));
    }
}

}  // namespace sluice
