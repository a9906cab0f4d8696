// The choice of an instruction set.
#include <algorithm>
#include <stdexcept>
#include <string>

#include "tests/catch.hpp"
#include "tests/neighbor/scopes.hpp"

namespace sluice::test_isa {

TEST_CASE("the best instruction set is in use from the start, and the baseline is always there", "[isa]") {
    const auto& isas = available_isas();
    REQUIRE_FALSE(isas.empty());
    CHECK(isas.front() == Isa::baseline);
    CHECK(std::is_sorted(isas.begin(), isas.end()));
    CHECK(active_isa() == isas.back());
}

TEST_CASE("an instruction set is chosen by name", "[isa]") {
    const IsaScope restore(active_isa());
    for (const Isa isa : available_isas()) {
        use_isa(name_of(isa));
        CHECK(active_isa() == isa);
    }
}

TEST_CASE("an instruction set that there is not is refused, with those that there are", "[isa]") {
    const Isa before = active_isa();
    for (const std::string name : {"", "AVX2", "sse9"}) {
        std::string message;
        try {
            use_isa(name);
        } catch (const std::invalid_argument& e) {
            message = e.what();
        }
        CAPTURE(name, message);
        CHECK(message.find('"' + name + '"') != std::string::npos);
        for (const Isa isa : available_isas()) CHECK(message.find(name_of(isa)) != std::string::npos);
        CHECK(active_isa() == before);
    }
}

}  // namespace sluice::test_isa
