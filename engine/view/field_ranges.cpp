#include "engine/view/field_ranges.hpp"

#include <algorithm>
#include <cmath>

namespace sluice {
namespace {

/// More particles than these tell a percentile no better; every so many is taken.
constexpr std::size_t sample_size = 20000;

/// `values` is reordered.
float quantile(std::vector<float>& values, double part) {
    const auto at = values.begin() + std::lround(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

std::array<std::vector<float>, 3> finite_by_medium(const NumberColumn& column, const FrameTable& table) {
    std::array<std::vector<float>, 3> values;
    for (std::size_t i = 0; i < column.count; ++i)
        if (std::isfinite(column[i]) && table.medium[i] < values.size()) values[table.medium[i]].push_back(column[i]);
    return values;
}

std::vector<float> thinned(const std::vector<float>& values) {
    const std::size_t stride = 1 + values.size() / sample_size;
    std::vector<float> some;
    for (std::size_t i = 0; i < values.size(); i += stride) some.push_back(values[i]);
    return some;
}

}  // namespace

void FieldRanges::add(const FrameTable& table, int dimension) {
    if (table.particles == 0) return;
    for (const NumberColumn& column : field_columns(table, dimension)) {
        const auto values = finite_by_medium(column, table);
        for (std::size_t m = 0; m < values.size(); ++m) {
            if (values[m].empty()) continue;
            Frames& frames = fields_[column.name][m];
            const auto [least, most] = std::minmax_element(values[m].begin(), values[m].end());
            frames.least = frames.low.empty() ? *least : std::min(frames.least, *least);
            frames.most = frames.low.empty() ? *most : std::max(frames.most, *most);
            std::vector<float> some = thinned(values[m]);
            frames.low.push_back(quantile(some, 0.01));
            frames.high.push_back(quantile(some, 0.99));
        }
    }
    for (const NumberColumn& x : position_columns(table, dimension)) {
        std::vector<float> values;
        for (std::size_t i = 0; i < x.count; ++i) values.push_back(x[i]);
        auto& [low, high] = bounds_[static_cast<std::size_t>(x.name[0] - 'x')];
        const double from = quantile(values, 0.001), to = quantile(values, 0.999);
        low = empty_ ? from : std::min(low, from), high = empty_ ? to : std::max(high, to);
    }
    empty_ = false;
}

std::vector<std::string> FieldRanges::fields() const {
    std::vector<std::string> names;
    for (const auto& [name, media] : fields_) names.push_back(name);
    return names;
}

std::optional<ValueRange> FieldRanges::of(const std::string& field, FrameMedium medium) const {
    const auto found = fields_.find(field);
    if (found == fields_.end()) return std::nullopt;
    Frames frames = found->second[static_cast<std::size_t>(medium)];
    if (frames.low.empty()) return std::nullopt;
    return ValueRange{quantile(frames.low, 0.05), quantile(frames.high, 0.95), frames.least, frames.most};
}

}  // namespace sluice
