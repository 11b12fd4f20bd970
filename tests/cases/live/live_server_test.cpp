// Whatever bytes arrive at the server of `delabole live`, it goes on; and nothing is answered but to who has the token
// and speaks to its own address.
#include "cases/program/live/server.hpp"

#include <gtest/gtest.h>

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <thread>

namespace delabole {
namespace {

// Returns what the server sends until it closes the connection; empty if it only closes it. The server waits a second
// for the rest of a request, its client for a twentieth of one, and then says that nothing more will come.
std::string answer_to(int port, const std::string& bytes) {
    const int connection = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    std::string answer;
    const auto receive = [&](const timeval& patience) {
        setsockopt(connection, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        std::array<char, 4096> part{};
        for (ssize_t got = 0; (got = recv(connection, part.data(), part.size(), 0)) > 0;) {
            answer.append(part.data(), static_cast<std::size_t>(got));
        }
    };
    if (connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
        send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL) >= 0) {
        receive({0, 50'000});
        shutdown(connection, SHUT_WR);
        receive({60, 0});  // a busy machine answers late
    }
    close(connection);
    return answer;
}

std::string request(const std::string& host, const std::string& token, const std::string& body) {
    return "POST /answer HTTP/1.1\r\nHost: " + host + "\r\nX-Delabole-Token: " + token +
           "\r\nContent-Type: application/json\r\nConnection: close\r\nContent-Length: " + std::to_string(body.size()) +
           "\r\n\r\n" + body;
}

// Bytes of the request changed, left out, doubled or moved.
std::string spoilt(std::string text, std::minstd_rand& random) {
    for (auto changes = 1 + random() % 4; changes > 0 && !text.empty(); --changes) {
        const std::size_t at = random() % text.size();
        const std::size_t length = 1 + random() % 20;
        switch (random() % 5) {
        case 0:
            text[at] = static_cast<char>(random() % 256);
            break;
        case 1:
            text.erase(at, length);
            break;
        case 2:
            text.insert(at, text.substr(random() % text.size(), length));
            break;
        case 3:
            text.insert(at, length * 100, static_cast<char>(random() % 256));
            break;
        default:
            text.resize(at);
        }
    }
    return text;
}

TEST(LiveServer, RandomBytesDoNotStopItNorGetAnAnswerWithoutTheToken) {
    const std::string path = DELABOLE_CASES "/starting/plane_failure.toml";
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    LiveSession session(read_case(path), text, [](const std::vector<std::string>&) { return "results"; });
    LiveServer server(session);
    const std::string address = server.address();  // http://127.0.0.1:1234/#token
    const std::string host = address.substr(7, address.find('/', 7) - 7);
    const std::string token = address.substr(address.find('#') + 1);
    const int port = std::stoi(host.substr(host.find(':') + 1));
    std::atomic<bool> ended = false;
    std::thread serving([&] { server.serve([&] { return ended.load(); }); });

    const std::string good = request(host, token, R"({"values":{"slope.height":15.0}})");
    const auto is_answered = [](const std::string& answer) {
        return answer.starts_with("HTTP/1.1 200") && answer.find("\"verdict\"") != std::string::npos;
    };
    EXPECT_TRUE(is_answered(answer_to(port, good)));
    std::minstd_rand random(21);
    int answered = 0;
    constexpr int requests = 500;
    for (int number = 0; number < requests; ++number) {
        const std::string bytes = spoilt(good, random);
        const std::string answer = answer_to(port, bytes);
        EXPECT_TRUE(answer.empty() || answer.starts_with("HTTP/1.1 ")) << answer.substr(0, 80);
        EXPECT_FALSE(answer.starts_with("HTTP/1.1 500")) << bytes;
        if (is_answered(answer)) {
            ++answered;
            EXPECT_NE(bytes.find(token), std::string::npos) << bytes;
            EXPECT_NE(bytes.find(host), std::string::npos) << bytes;
        }
    }
    EXPECT_GT(answered, 0) << "no change left the request whole: the requests test nothing behind the token";
    EXPECT_LT(answered, requests / 2) << "hardly any change mattered";
    EXPECT_TRUE(is_answered(answer_to(port, good))) << "it still serves";
    ended = true;
    serving.join();
}

}  // namespace
}  // namespace delabole
