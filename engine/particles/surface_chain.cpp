#include "engine/particles/surface_chain.hpp"

#include <map>
#include <utility>

namespace sluice {
namespace {

using Corner = std::pair<std::int32_t, std::int32_t>;

/// A unit edge of the outline between two lattice corners, and the particle whose square it bounds.
struct Edge {
    Corner from, to;
    Index owner;
};

/// Edges of the squares that have no neighbour across them, directed with the material on the left.
std::multimap<Corner, Edge> outline_edges(const std::vector<std::array<std::int32_t, 3>>& sites) {
    std::map<Corner, Index> at;
    for (std::size_t i = 0; i < sites.size(); ++i) at[{sites[i][0], sites[i][1]}] = static_cast<Index>(i);
    std::multimap<Corner, Edge> edges;
    const auto add = [&](Corner from, Corner to, Index owner) { edges.insert({from, {from, to, owner}}); };
    for (const auto& [site, i] : at) {
        const auto [x, y] = site;
        if (!at.contains({x, y - 1})) add({x, y}, {x + 1, y}, i);
        if (!at.contains({x + 1, y})) add({x + 1, y}, {x + 1, y + 1}, i);
        if (!at.contains({x, y + 1})) add({x + 1, y + 1}, {x, y + 1}, i);
        if (!at.contains({x - 1, y})) add({x, y + 1}, {x, y}, i);
    }
    return edges;
}

/// Takes the edge that leaves a corner; where two squares touch at that corner only, the one that turns left, which
/// keeps to the same square.
Edge take_next(std::multimap<Corner, Edge>& edges, const Edge& last) {
    auto [first, end] = edges.equal_range(last.to);
    auto chosen = first;
    for (auto e = first; e != end; ++e)
        if (e->second.owner == last.owner) chosen = e;
    const Edge next = chosen->second;
    edges.erase(chosen);
    return next;
}

}  // namespace

std::vector<std::vector<Index>> trace_outline(const std::vector<std::array<std::int32_t, 3>>& sites) {
    std::multimap<Corner, Edge> edges = outline_edges(sites);
    std::vector<std::vector<Index>> loops;
    while (!edges.empty()) {
        Edge edge = edges.begin()->second;
        edges.erase(edges.begin());
        const Corner start = edge.from;
        std::vector<Index> loop{edge.owner};
        while (edge.to != start) {
            edge = take_next(edges, edge);
            if (edge.owner != loop.back()) loop.push_back(edge.owner);
        }
        if (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
        loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace sluice
