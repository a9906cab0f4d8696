// The diagram and the page: well-formed, complete, and with no word over another.
#include <cctype>
#include <regex>

#include "engine/study/diagram.hpp"
#include "engine/study/label_layout.hpp"
#include "engine/study/log_axis.hpp"
#include "engine/study/report_page.hpp"
#include "tests/catch.hpp"
#include "tests/engine/study_examples.hpp"

namespace sluice::test_study_pictures {
using Catch::Matchers::Contains;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
    return n;
}

/// Whether elements nest and close, attributes are quoted, and & starts an entity: all that can go wrong with a writer
/// that puts strings together. Empty, or what is wrong.
std::string xml_problem(const std::string& xml) {
    static const std::regex tag(R"(^<(/?)([A-Za-z:]+)((?:\s+[A-Za-z:_0-9-]+="[^"<]*")*)\s*(/?)>)");
    static const std::regex entity(R"(^&(amp|lt|gt|quot|#[0-9]+);)");
    std::vector<std::string> open;
    bool had_root = false;
    for (auto at = xml.begin(); at != xml.end();) {
        std::smatch match;
        if (*at == '<') {
            if (!std::regex_search(at, xml.end(), match, tag))
                return "tag: " + std::string(at, std::min(at + 60, xml.end()));
            if (open.empty() && had_root) return "a second root";
            had_root = true;
            if (match[1].length() > 0) {
                if (open.empty() || open.back() != match[2]) return "closed: " + match[2].str();
                open.pop_back();
            } else if (match[4].length() == 0) {
                open.push_back(match[2]);
            }
            at = match[0].second;
        } else if (*at == '&') {
            if (!std::regex_search(at, xml.end(), match, entity)) return "entity";
            at = match[0].second;
        } else {
            if (open.empty() && !std::isspace(static_cast<unsigned char>(*at))) return "text outside";
            ++at;
        }
    }
    return open.empty() ? "" : "left open: " + open.back();
}

}  // namespace

TEST_CASE("The check of XML finds what is wrong with it", "[study]") {
    CHECK(xml_problem("<a b=\"1\"><c/>x &amp; y</a>\n").empty());
    CHECK_FALSE(xml_problem("<a><b></a></b>").empty());
    CHECK_FALSE(xml_problem("<a>x & y</a>").empty());
    CHECK_FALSE(xml_problem("<a b=1/>").empty());
    CHECK_FALSE(xml_problem("<a>").empty());
}

TEST_CASE("A diagram is well-formed and has each run that is done", "[study]") {
    const Study study = study_examples::two_methods();
    const std::string one = diagram(study, 0).document();
    CHECK(xml_problem(one) == "");
    CHECK(count(one, "class=\"point\"") == 8);
    CHECK(count(one, "class=\"method\"") == 2);
    CHECK(count(one, "class=\"spacing\"") == 8);
    CHECK(count(one, "class=\"front\"") == 1);
    CHECK_THAT(one, Contains("below 0.20 % more accuracy buys nothing"));
    CHECK_THAT(one, Contains("A &lt;made-up&gt; study &amp; its scene"));
    CHECK_THAT(one, Contains("1 of 9 settings failed"));
    // Slopes of the first method, exact: −3 and 2.
    CHECK_THAT(one, Contains("−3.00 ± 0.00") && Contains(">2.00 ± 0.00"));
    const std::string page = study_page(study);
    CHECK_THAT(page, Contains("failed: torn, &quot;apart&quot;"));
    CHECK_THAT(page, !Contains("href=") && !Contains("src="));
    const std::string picture = study_svg(study);
    CHECK(xml_problem(picture) == "");
    CHECK(count(picture, "class=\"point\"") == 8);  // the extrapolated quantity is on the page only
}

TEST_CASE("Studies with hardly anything in them are drawn as well", "[study]") {
    Study study = study_examples::two_methods();
    study.points.resize(1);
    CHECK(xml_problem(study_svg(study)) == "");
    study.points[0].error[0] = 0.0;  // has no place on a logarithmic axis
    CHECK(xml_problem(study_svg(study)) == "");
    CHECK(count(diagram(study, 0).document(), "class=\"point\"") == 0);
    study.points.clear();
    CHECK(xml_problem(study_svg(study)) == "");
    study.quantities.clear();
    CHECK(xml_problem(study_svg(study)) == "");
    CHECK_FALSE(study_page(study).empty());
}

TEST_CASE("Words are placed beside their points and over no other", "[study]") {
    LabelLayout layout({0, 0, 200, 200});
    std::vector<SvgBox> placed;
    for (int i = 0; i < 12; ++i) {
        const auto box = layout.place_beside({100 + 3.0 * i, 100 - 2.0 * i}, 30, 10);
        if (box) placed.push_back(*box);
    }
    CHECK(placed.size() >= 8);  // twelve points within 33 pixels: some have no room near them
    for (std::size_t a = 0; a < placed.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) CHECK_FALSE(placed[a].meets(placed[b]));
    for (const SvgBox& box : placed) CHECK(box.lies_in({0, 0, 200, 200}));
}

TEST_CASE("Blocks are spread without overlap, near to where they want to be", "[study]") {
    const auto middles = spread({50, 52, 10, 95}, {20, 20, 20, 20}, 0, 100);
    CHECK(middles == std::vector<double>{50, 70, 10, 90});
    const auto crowded = spread({99, 99, 99}, {20, 20, 20}, 0, 100);
    CHECK(crowded == std::vector<double>{50, 70, 90});
}

TEST_CASE("Logarithmic axes have labels at round numbers", "[study]") {
    const LogAxis axis(0.8, 30, 0, 100);
    CHECK(axis.labelled() == std::vector<double>{1, 2, 5, 10, 20});
    CHECK(axis(0.8) == Approx(0).margin(1e-12));
    CHECK(axis(30) == Approx(100));
    CHECK(LogAxis(1.1, 1.2, 0, 1).labelled().size() >= 2);
    CHECK(LogAxis(0.001, 900, 0, 1).labelled().size() == 6);
}

}  // namespace sluice::test_study_pictures
