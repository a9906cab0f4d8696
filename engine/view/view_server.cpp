#include "engine/view/view_server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <charconv>
#include <chrono>
#include <fstream>
#include <sstream>

#include "engine/base/errors.hpp"
#include "engine/view/view_page.hpp"

namespace sluice {
namespace {

/// Frames are packed whenever they are asked for: the fastest level, as they do not travel far.
constexpr int live_level = 1;
/// As long may a page wait for an answer.
constexpr std::chrono::milliseconds scan_time{500};
constexpr const char* this_machine = "127.0.0.1";

bool same(const FrameFile& a, const FrameFile& b) { return a.path == b.path && a.time == b.time; }

void send_file(const std::filesystem::path& file, httplib::Response& response) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    response.set_content(text.str(), "text/plain; charset=utf-8");
}

/// A page of another site can make a browser ask under a name of its own that leads here; it gets nothing.
bool asks_for_this_machine(const httplib::Request& request) {
    const std::string host = request.get_header_value("Host");
    const std::string name = host.substr(0, host.rfind(':'));
    return name == this_machine || name == "localhost";
}

void send_frame(LiveRun& run, const httplib::Request& request, httplib::Response& response) {
    const std::string digits = request.matches[1];
    std::size_t index = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (const auto packed = run.frame(index)) {
        response.set_content(*packed, "application/octet-stream");
    } else {
        response.status = 404;
        response.set_content("there is no such frame", "text/plain");
    }
}

void add_answers(httplib::Server& server, LiveRun& run) {
    server.set_pre_routing_handler([](const httplib::Request& request, httplib::Response& response) {
        if (asks_for_this_machine(request)) return httplib::Server::HandlerResponse::Unhandled;
        response.status = 403;
        return httplib::Server::HandlerResponse::Handled;
    });
    server.set_exception_handler([](const httplib::Request&, httplib::Response& response, std::exception_ptr problem) {
        response.status = 500;
        try {
            std::rethrow_exception(problem);
        } catch (const std::exception& error) {
            response.set_content(error.what(), "text/plain; charset=utf-8");
        }
    });
    server.Get("/", [&run](const httplib::Request&, httplib::Response& response) {
        response.set_content(page_with(run.title(), ""), "text/html; charset=utf-8");
    });
    server.Get("/run.json", [&run](const httplib::Request&, httplib::Response& response) {
        response.set_content(run.head(), "application/json");
    });
    server.Get("/summary.json", [&run](const httplib::Request&, httplib::Response& response) {
        send_file(run.directory() / "summary.json", response);
    });
    server.Get("/probes.csv", [&run](const httplib::Request&, httplib::Response& response) {
        send_file(run.directory() / "probes.csv", response);
    });
    server.Get(R"(/frame/(\d{1,9}))", [&run](const httplib::Request& request, httplib::Response& response) {
        send_frame(run, request, response);
    });
}

}  // namespace

LiveRun::LiveRun(std::filesystem::path directory, std::vector<std::string> fields)
    : directory_(std::move(directory)), fields_(std::move(fields)) {
    restart();
}

void LiveRun::restart() {
    view_.reset();
    scanned_.clear();
    readable_.clear();
    std::string problem;
    for (const FrameFile& file : list_frames(directory_)) {
        scanned_.push_back(file);
        try {
            const StoredFrame frame = read_frame(file);
            view_.emplace(directory_, frame.table, fields_);
            view_->add(frame);
            readable_.push_back(file);
            return;
        } catch (const RunReadError& error) {
            if (problem.empty()) problem = error.what();
        }
    }
    throw RunReadError(problem);
}

bool LiveRun::scan() {
    const auto end = std::chrono::steady_clock::now() + scan_time;
    const std::vector<FrameFile> files = list_frames(directory_);
    const bool goes_on =
        files.size() >= scanned_.size() && std::equal(scanned_.begin(), scanned_.end(), files.begin(), same);
    if (!goes_on) restart();  // the run has been started anew
    for (std::size_t k = scanned_.size(); k < files.size(); ++k) {
        if (std::chrono::steady_clock::now() > end) return true;
        scanned_.push_back(files[k]);
        try {
            view_->add(read_frame(files[k]));
            readable_.push_back(files[k]);
        } catch (const RunReadError&) {
            // left out; the frames around it can be shown
        }
    }
    return false;
}

std::string LiveRun::head() {
    const std::lock_guard lock(mutex_);
    const bool more = scan();
    return view_->head(more ? PageKind::catching_up : PageKind::live);
}

std::optional<std::string> LiveRun::frame(std::size_t index) {
    const std::lock_guard lock(mutex_);
    if (index >= readable_.size()) return std::nullopt;
    return view_->pack(read_frame(readable_[index]), live_level);
}

std::string LiveRun::title() {
    const std::lock_guard lock(mutex_);
    return view_->folder().title;
}

void serve_run(LiveRun& run, int port, const std::function<void(const std::string&)>& started) {
    httplib::Server server;
    add_answers(server, run);
    const int bound = port == 0                                 ? server.bind_to_any_port(this_machine)
                      : server.bind_to_port(this_machine, port) ? port
                                                                : -1;
    if (bound < 0)
        throw OutputError(
            fmt::format("port {}: cannot be used; is another program listening there? --serve=0 takes any "
                        "free one",
                        port));
    started(fmt::format("http://{}:{}/", this_machine, bound));
    server.listen_after_bind();
}

}  // namespace sluice
