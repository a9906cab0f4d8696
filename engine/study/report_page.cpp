#include "engine/study/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/study/advice.hpp"
#include "engine/study/diagram.hpp"
#include "engine/study/diagram_marks.hpp"
#include "engine/study/svg.hpp"
#include "engine/study/words.hpp"

namespace sluice {
namespace {

constexpr const char* style = R"(
body { font: 15px/1.5 Helvetica, Arial, "Liberation Sans", sans-serif; color: #222; max-width: 960px; margin: 2em auto;
  padding: 0 1em; background: #fff; }
h1 { font-size: 1.6em; margin: 0 0 .2em; } h2 { font-size: 1.15em; margin: 2em 0 .5em; }
p.facts { color: #555; margin: 0 0 1.5em; } ul.advice { padding-left: 1.2em; } ul.advice li { margin: .4em 0; }
svg { max-width: 100%; height: auto; display: block; margin: 0 0 1.5em; }
table { border-collapse: collapse; font-size: .88em; width: 100%; } th { text-align: left; border-bottom: 1px solid #888; }
th, td { padding: .25em .7em .25em 0; vertical-align: top; } td { border-bottom: 1px solid #e6e6e6; }
.n { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; } tr.failed td { color: #a03000; }
td.band { color: #888; } @media print { body { margin: 0; } svg, tr { break-inside: avoid; } }
)";

std::vector<std::size_t> shown_in_picture(const Study& study) {
    std::vector<std::size_t> shown;
    for (std::size_t q = 0; q < study.quantities.size(); ++q)
        if (!study.quantities[q].extrapolated) shown.push_back(q);
    if (shown.empty())
        for (std::size_t q = 0; q < study.quantities.size(); ++q) shown.push_back(q);
    return shown;
}

std::string heading(const Study& study) {
    std::string vary;
    for (const Axis& axis : study.axes)
        vary += fmt::format("{}{} = {}", vary.empty() ? "" : "; ", axis.key, fmt::join(axis.values, ", "));
    return fmt::format(
        "<h1>{}: what accuracy costs in time</h1>\n<p class=\"facts\">{} varied over {}. sluice {}, {}, on {}, "
        "{} {} a run, {} {} each{}.</p>\n",
        xml_text(study.title), xml_text(study.scene), xml_text(vary.empty() ? "nothing" : vary),
        xml_text(study.version), xml_text(study.date), xml_text(machine_text(study)), study.threads,
        study.threads == 1 ? "thread" : "threads", study.repeats, study.repeats == 1 ? "run" : "runs",
        study.machine.load > 1 ? fmt::format("; other programs ran (load average {:.1f})", study.machine.load) : "");
}

std::string advice_list(const Study& study) {
    std::string html = "<h2>Advice</h2>\n<ul class=\"advice\">\n";
    for (const std::string& line : advice(study)) html += "<li>" + xml_text(line) + "</li>\n";
    return html + "</ul>\n<p class=\"facts\">Seconds are those of the machine above.</p>\n";
}

std::string slopes_table(const Study& study) {
    std::string html =
        "<h2>Slopes over the spacing d</h2>\n<table><tr><th>method</th><th class=\"n\">cost ~ d to the</th>";
    for (const Quantity& q : study.quantities)
        html += fmt::format("<th class=\"n\">error of {} ~ d to the</th>", xml_text(q.name));
    html += "</tr>\n";
    for (std::size_t m = 0; m < study.methods.size(); ++m) {
        std::string cost = "–", errors;
        for (std::size_t q = 0; q < study.quantities.size(); ++q) {
            const Slopes slopes = slopes_of(points_of(study, m, q), q);
            if (slopes.cost) cost = exponent_text(*slopes.cost);
            errors += fmt::format("<td class=\"n\">{}</td>", slopes.error ? exponent_text(*slopes.error) : "–");
        }
        html +=
            fmt::format("<tr><td>{}</td><td class=\"n\">{}</td>{}</tr>\n", xml_text(study.methods[m]), cost, errors);
    }
    return html + "</table>\n<p class=\"facts\">Fitted in logarithms; ± is the standard error of the exponent.</p>\n";
}

/// Why a point has no figures; empty if it has.
std::string reason_text(const StudyPoint& p) {
    switch (p.state) {
        case PointState::missing:
            return "not run";
        case PointState::failed:
            return "failed: " + xml_text(p.reason);
        case PointState::done:
            break;
    }
    return "";
}

std::string run_row(const Study& study, const StudyPoint& p) {
    const char* look = p.state == PointState::failed ? " class=\"failed\"" : "";
    std::string html = fmt::format("<tr{}><td>{}</td><td class=\"n\">{}</td>", look, xml_text(study.methods[p.method]),
                                   xml_text(length_text(p.spacing)));
    if (const std::string reason = reason_text(p); !reason.empty())
        return html + fmt::format("<td colspan=\"{}\">{}</td></tr>\n", 3 + study.quantities.size(), reason);
    const auto [least, most] = std::minmax_element(p.cpu.begin(), p.cpu.end());
    const std::string span = p.cpu.size() > 1 ? fmt::format("{}–{}", seconds_text(*least), seconds_text(*most)) : "";
    html += fmt::format("<td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>",
                        seconds_text(p.cpu_seconds()), span, seconds_text(p.wall_seconds()));
    for (std::size_t q = 0; q < study.quantities.size(); ++q) {
        const bool hidden =
            p.error[q] && study.quantities[q].uncertainty && *p.error[q] < *study.quantities[q].uncertainty;
        html += fmt::format("<td class=\"n{}\">{}</td>", hidden ? " band" : "",
                            p.error[q] ? percent_text(*p.error[q]) : "–");
    }
    return html + "</tr>\n";
}

std::string run_table(const Study& study) {
    std::string html =
        "<h2>All runs</h2>\n<table><tr><th>method</th><th class=\"n\">spacing</th><th class=\"n\">CPU [s]</th>"
        "<th class=\"n\">from–to</th><th class=\"n\">wall [s]</th>";
    for (const Quantity& q : study.quantities) html += fmt::format("<th class=\"n\">{}</th>", xml_text(q.name));
    html += "</tr>\n";
    for (std::size_t m = 0; m < study.methods.size(); ++m)
        for (const StudyPoint& p : study.points)
            if (p.method == m) html += run_row(study, p);
    return html +
           "</table>\n<p class=\"facts\">CPU and wall time are medians, set-up included. Grey errors are below the "
           "truth's own uncertainty.</p>\n";
}

std::string truth_list(const Study& study) {
    std::string html =
        "<h2>What is measured</h2>\n<table><tr><th>error</th><th>of what</th><th class=\"n\">100 % is</th>"
        "<th class=\"n\">uncertainty</th><th>truth</th></tr>\n";
    for (const Quantity& q : study.quantities)
        html += fmt::format(
            "<tr><td>{}</td><td>{}</td><td class=\"n\">{:.4g} {}</td><td class=\"n\">{}</td><td>{}</td></tr>\n",
            xml_text(q.name), xml_text(q.meaning), q.scale, xml_text(q.unit),
            q.uncertainty ? percent_text(*q.uncertainty) : "not stated", xml_text(q.note));
    return html + "</table>\n";
}

std::string failed_list(const Study& study) {
    std::string html;
    for (const StudyPoint& p : study.points)
        if (p.state == PointState::failed)
            html += fmt::format("<li>{}, spacing {}: {}</li>\n", xml_text(study.methods[p.method]),
                                xml_text(length_text(p.spacing)), xml_text(p.reason));
    return html.empty() ? "" : "<h2>Failed runs</h2>\n<ul>\n" + html + "</ul>\n";
}

}  // namespace

std::string study_svg(const Study& study) {
    std::string content;
    double width = 0, height = 0;
    for (const std::size_t q : shown_in_picture(study)) {
        const Svg one = diagram(study, q);
        content += fmt::format("<g transform=\"translate(0 {:.1f})\">\n{}</g>\n", height, one.content());
        width = std::max(width, one.width());
        height += one.height();
    }
    Svg all(width, height);
    all.raw(content);
    return all.document();
}

std::string study_page(const Study& study) {
    std::string html = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{}: study</title>\n"
        "<style>{}</style>\n</head>\n<body>\n",
        xml_text(study.title), style);
    html += heading(study) + advice_list(study) + "<h2>Error against CPU time</h2>\n";
    for (std::size_t q = 0; q < study.quantities.size(); ++q) html += diagram(study, q).document();
    html += failed_list(study) + run_table(study) + slopes_table(study) + truth_list(study);
    return html + "</body>\n</html>\n";
}

}  // namespace sluice
