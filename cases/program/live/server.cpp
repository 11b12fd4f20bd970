#include "cases/program/live/server.hpp"

#include "cases/program/live/page.hpp"
#include "cases/program/terminal/interrupt.hpp"

#include <httplib.h>

#include <chrono>
#include <future>
#include <iostream>
#include <mutex>
#include <random>
#include <string_view>
#include <thread>

namespace delabole {

namespace {

constexpr std::size_t largest_request = std::size_t{256} << 10U;
constexpr int patience = 1;                                 // s, with a connection that says nothing
constexpr int longest_writing = 5;                          // s
constexpr std::chrono::milliseconds end_of_patience{1800};  // after Ctrl-C
constexpr std::size_t threads = 8;

std::string new_token() {
    constexpr std::string_view digits = "0123456789abcdef";
    constexpr int length = 32;  // 128 bits
    std::random_device random;
    std::string token;
    for (int index = 0; index < length; ++index) {
        token += digits[random() % digits.size()];
    }
    return token;
}

// Compares in a time that does not tell how much of the text is right.
bool same(std::string_view given, std::string_view right) {
    unsigned difference = given.size() == right.size() ? 0 : 1;
    for (std::size_t index = 0; index < right.size(); ++index) {
        const char letter = index < given.size() ? given[index] : '\0';
        difference |=
            static_cast<unsigned>(static_cast<unsigned char>(letter) ^ static_cast<unsigned char>(right[index]));
    }
    return difference == 0;
}

std::string page_with(const std::string& nonce) {
    constexpr std::string_view placeholder = "@nonce@";
    std::string page(live_page);
    for (std::size_t at = page.find(placeholder); at != std::string::npos; at = page.find(placeholder, at)) {
        page.replace(at, placeholder.size(), nonce);
    }
    return page;
}

void refuse(httplib::Response& response, int status, const std::string& why) {
    response.status = status;
    response.set_content(json_text({{"refused", why}}), "application/json");
}

// Names of folders need not be UTF-8. A content provider sends the answer uncompressed: for a browser on the same
// machine, compressing it would take ten times as long as computing it.
void send(httplib::Response& response, const Json& json) {
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    response.set_content_provider(text.size(), "application/json",
                                  [text](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                      return sink.write(text.data() + offset, length);
                                  });
}

}  // namespace

struct LiveServer::Parts {
    httplib::Server server;
    LiveSession& session;
    std::string token = new_token();
    std::string nonce = new_token();
    int port = -1;

    explicit Parts(LiveSession& served) : session(served) {}

    std::mutex telling;
    std::chrono::steady_clock::time_point told{};
    int untold = 0;

    std::string host() const { return "127.0.0.1:" + std::to_string(port); }

    // Returns whether the request may be answered at all.
    bool admits(const httplib::Request& request, httplib::Response& response) const {
        if (request.get_header_value("Host") != host()) {
            refuse(response, 403, "this server answers to " + host() + " alone");
            return false;
        }
        if (request.has_header("Origin") && request.get_header_value("Origin") != "http://" + host()) {
            refuse(response, 403, "pages from elsewhere are not answered");
            return false;
        }
        if (request.method == "POST" && !same(request.get_header_value("X-Delabole-Token"), token)) {
            refuse(response, 401, "the address that delabole live has printed ends with a token: open that one");
            return false;
        }
        // The library enforces its limit only for a body whose length is given.
        for (const char* const header : {"Transfer-Encoding", "Content-Encoding", "Range"}) {
            if (request.has_header(header)) {
                refuse(response, 400, "a request is sent whole and as it is, and so is the answer");
                return false;
            }
        }
        return true;
    }

    // Tells the terminal of refusals, except those that the page shows to its user. The text of a request is not
    // repeated, because it may be anything.
    void tell_of(const httplib::Response& response) {
        using std::chrono_literals::operator""s;
        const std::scoped_lock lock(telling);
        const auto now = std::chrono::steady_clock::now();
        if (now - told < 1s) {
            ++untold;
            return;
        }
        std::cerr << "delabole: a request was refused with status " << response.status
                  << (response.status == 403   ? ": it came from another page or under another name"
                      : response.status == 401 ? ": it had not the token"
                      : response.status == 413
                          ? ": it was longer than " + std::to_string(largest_request >> 10U) + " kB"
                          : "")
                  << (untold > 0 ? ", after " + std::to_string(untold) + " others" : "") << '\n';
        told = now;
        untold = 0;
    }

    using Answer = std::function<void(const Json& request, httplib::Response& response)>;

    void answer(const std::string& path, Answer with) {
        server.Post(path, [with = std::move(with)](const httplib::Request& request, httplib::Response& response) {
            const Json json = Json::parse(request.body, nullptr, false);
            if (json.is_discarded()) {
                refuse(response, 400, "the request is not JSON");
                return;
            }
            try {
                with(json, response);
            } catch (const LiveRefusal& error) {
                refuse(response, 400, error.what());
            }
        });
    }

    void answer_json(const std::string& path, Json (LiveSession::*function)(const Json&) const) {
        answer(path, [this, function](const Json& request, httplib::Response& response) {
            send(response, (session.*function)(request));
        });
    }
    void answer_json(const std::string& path, Json (LiveSession::*function)(const Json&)) {
        answer(path, [this, function](const Json& request, httplib::Response& response) {
            send(response, (session.*function)(request));
        });
    }

    void set_up() {
        server.set_payload_max_length(largest_request);
        // Otherwise the body, in a packet after the head, would wait 40 ms for the browser's acknowledgement.
        server.set_tcp_nodelay(true);
        server.set_read_timeout(patience);
        server.set_write_timeout(longest_writing);
        server.set_keep_alive_timeout(patience);
        server.new_task_queue = [] { return new httplib::ThreadPool(threads); };
        server.set_default_headers({{"Cache-Control", "no-store"},
                                    {"X-Content-Type-Options", "nosniff"},
                                    {"X-Frame-Options", "DENY"},
                                    {"Referrer-Policy", "no-referrer"},
                                    {"Cross-Origin-Resource-Policy", "same-origin"},
                                    {"Content-Security-Policy",
                                     "default-src 'none'; script-src 'nonce-" + nonce + "'; style-src 'nonce-" + nonce +
                                         "'; connect-src 'self'; img-src data:; base-uri 'none'; form-action 'none'; "
                                         "frame-ancestors 'none'"}});
        server.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
            return admits(request, response) ? httplib::Server::HandlerResponse::Unhandled
                                             : httplib::Server::HandlerResponse::Handled;
        });
        server.set_logger([this](const httplib::Request&, const httplib::Response& response) {
            if (response.status > 400) {
                tell_of(response);
            }
        });
        server.set_exception_handler([](const httplib::Request&, httplib::Response& response, std::exception_ptr) {
            refuse(response, 500, "stopped by an error that lies neither in the case nor in the request");
        });
        server.Get("/", [page = page_with(nonce)](const httplib::Request&, httplib::Response& response) {
            response.set_content(page, "text/html; charset=utf-8");
        });
        answer("/open", [this](const Json&, httplib::Response& response) { send(response, session.open()); });
        answer_json("/answer", &LiveSession::answer);
        answer_json("/drag", &LiveSession::drag);
        answer_json("/map", &LiveSession::map);
        answer_json("/fit", &LiveSession::fit);
        answer_json("/study", &LiveSession::study);
        answer_json("/support", &LiveSession::support);
        answer_json("/save", &LiveSession::save);
        answer_json("/report", &LiveSession::report);
        answer_json("/motion/start", &LiveSession::start_motion);
        answer_json("/motion/verdict", &LiveSession::verdict_of_motion);
        answer_json("/motion/change", &LiveSession::change_motion);
        answer("/motion/step", [this](const Json& request, httplib::Response& response) {
            response.set_content(session.step_motion(request), "application/octet-stream");
        });
    }
};

LiveServer::LiveServer(LiveSession& session) : parts_(std::make_unique<Parts>(session)) {
    parts_->set_up();
    parts_->port = parts_->server.bind_to_any_port("127.0.0.1");
    if (parts_->port < 0) {
        throw OutputError("127.0.0.1", "no port is free");
    }
}

LiveServer::~LiveServer() = default;

std::string LiveServer::address() const {
    return "http://" + parts_->host() + "/#" + parts_->token;
}

void LiveServer::serve(const std::function<bool()>& ended) {
    using std::chrono_literals::operator""ms;
    std::promise<void> served;
    std::thread serving([&] {
        parts_->server.listen_after_bind();
        served.set_value();
    });
    while (!ended()) {
        std::this_thread::sleep_for(100ms);
    }
    parts_->server.stop();
    if (served.get_future().wait_for(end_of_patience) != std::future_status::ready) {
        end_work();
    }
    serving.join();
}

}  // namespace delabole
