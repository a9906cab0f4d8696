// What a run must keep to go on, put into a checkpoint and taken from one.
//
// Whoever changes during a run has `visit_state(visit)`, which calls visit(name, member) for each such member. The same
// function serves both directions, so that what is written and what is read cannot differ.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include "engine/base/errors.hpp"
#include "engine/files/hdf5_reader.hpp"

namespace sluice {

namespace detail {

struct AnyVisit {
    template <class T>
    void operator()(std::string_view, T&) const;
};

/// Values that have members of their own to visit.
template <class T>
concept HasState = requires(T& value, AnyVisit visit) {
    value.visit_state(visit);
};
template <class T>
concept Resizable = requires(T& value) {
    value.resize(1);
};

/// Arrays whose values are no plain memory.
template <class T>
concept List = requires {
    typename T::value_type;
}
&&!std::is_trivially_copyable_v<typename T::value_type>;

}  // namespace detail

/// Writes what it is shown into a group: numbers as attributes, arrays as datasets, empty ones not at all.
class StateWriter {
  public:
    explicit StateWriter(Hdf5Group group) : group_(std::move(group)) {}
    StateWriter group(const std::string& name) const { return StateWriter(group_.group(name)); }

    template <class T>
    void operator()(std::string_view name, T& value) const {
        const std::string key(name);
        if constexpr (detail::HasState<T>)
            value.visit_state(group(key));
        else if constexpr (std::is_arithmetic_v<T>)
            group_.attribute(key, std::remove_const_t<T>(value));
        else if constexpr (detail::List<T>)
            write_list(group(key), value);
        else if (!value.empty())
            group_.plain_dataset(key, std::span<const typename T::value_type>(value));
    }

  private:
    template <class T>
    static void write_list(const StateWriter& writer, T& list) {
        std::uint64_t count = list.size();
        writer("count", count);
        for (std::size_t k = 0; k < count; ++k) writer(std::to_string(k), list[k]);
    }

    Hdf5Group group_;
};

/// Fills what it is shown from a group. Throws CheckpointError for what is not there or does not fit.
class StateReader {
  public:
    explicit StateReader(Hdf5Source group) : group_(std::move(group)) {}
    StateReader group(const std::string& name) const { return StateReader(group_.group(name)); }

    template <class T>
    void operator()(std::string_view name, T& value) const {
        const std::string key(name);
        if constexpr (detail::HasState<T>)
            value.visit_state(group(key));
        else if constexpr (std::is_arithmetic_v<T>)
            value = group_.attribute<T>(key);
        else if constexpr (detail::List<T>)
            read_list(group(key), value);
        else
            read_array(key, value);
    }

  private:
    template <class T>
    void read_array(const std::string& key, T& values) const {
        const std::size_t count = group_.has(key) ? group_.count(key) : 0;
        if constexpr (detail::Resizable<T>) {
            values.clear();
            values.reserve(count);  // no more than it takes
            values.resize(count);
        }
        if (count > 0) group_.read(key, std::span<typename T::value_type>(values));
    }
    template <class T>
    static void read_list(const StateReader& reader, T& list) {
        std::uint64_t count = 0;
        reader("count", count);
        constexpr std::uint64_t most = 1 << 20;  // lists are of bodies and walls
        if (count > most) throw CheckpointError("the checkpoint does not fit: a list without end");
        if constexpr (detail::Resizable<T>) list.resize(count);
        if (count != list.size()) throw CheckpointError("the checkpoint does not fit: a list of another length");
        for (std::size_t k = 0; k < count; ++k) reader(std::to_string(k), list[k]);
    }

    Hdf5Source group_;
};

}  // namespace sluice
