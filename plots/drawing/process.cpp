#include "plots/drawing/process.hpp"

#include "plots/drawing/atomic_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>

namespace delabole {

namespace {

namespace fs = std::filesystem;

std::atomic<pid_t> running{0};
static_assert(std::atomic<pid_t>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

struct SpawnSettings {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;

    SpawnSettings() {
        posix_spawn_file_actions_init(&actions);
        posix_spawnattr_init(&attributes);
    }
    ~SpawnSettings() {
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&actions);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;
};

// Returns 0 and the id of the process, or the error of the system.
int spawn(const fs::path& program, const std::vector<std::string>& arguments, const fs::path& folder, int output,
          pid_t& child) {
    SpawnSettings settings;
    posix_spawn_file_actions_addchdir_np(&settings.actions, folder.c_str());
    posix_spawn_file_actions_addopen(&settings.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&settings.actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&settings.actions, output, STDERR_FILENO);

    // Signals that the caller ignores or blocks must not remain so in the child: with an ignored SIGPIPE or a blocked
    // SIGINT it could not be stopped.
    sigset_t none;
    sigset_t defaults;
    sigemptyset(&none);
    sigemptyset(&defaults);
    for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGHUP, SIGQUIT}) {
        sigaddset(&defaults, number);
    }
    posix_spawnattr_setsigmask(&settings.attributes, &none);
    posix_spawnattr_setsigdefault(&settings.attributes, &defaults);
    // The program runs in its own process group, so that Ctrl-C reaches only the caller, which may let the picture be
    // finished.
    posix_spawnattr_setpgroup(&settings.attributes, 0);
    posix_spawnattr_setflags(&settings.attributes,
                             POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);

    std::vector<std::string> words{program.filename().string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    return posix_spawn(&child, program.c_str(), &settings.actions, &settings.attributes, pointers.data(), environ);
}

// Reads until the other end closes. False if the deadline came first or the caller gave up.
bool drain(int descriptor, std::string& output, std::chrono::steady_clock::time_point deadline,
           const std::function<bool()>& give_up) {
    constexpr long interval = 100;  // ms
    constexpr std::size_t most_kept = 65'536;
    std::array<char, 4096> buffer;
    for (;;) {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now()).count();
        pollfd waiting{.fd = descriptor, .events = POLLIN, .revents = 0};
        const int ready = left <= 0 ? 0 : ::poll(&waiting, 1, static_cast<int>(std::min<long>(left, interval)));
        if (left <= 0 || (give_up && give_up())) {
            return false;
        }
        if (ready == 0) {
            continue;
        }
        if (ready < 0) {
            if (errno == EINTR) {
                continue;
            }
            return true;
        }
        const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
        if (count > 0) {
            const std::size_t room = most_kept - std::min(most_kept, output.size());
            output.append(buffer.data(), std::min(room, static_cast<std::size_t>(count)));
        } else if (count == 0 || errno != EINTR) {
            return true;
        }
    }
}

}  // namespace

std::optional<std::filesystem::path> find_program(std::string_view name) {
    const char* variable = std::getenv("PATH");
    std::string_view folders = variable ? variable : "/usr/local/bin:/usr/bin:/bin";
    while (!folders.empty()) {
        const std::size_t colon = std::min(folders.find(':'), folders.size());
        const std::string_view folder = folders.substr(0, colon);
        folders.remove_prefix(std::min(colon + 1, folders.size()));
        std::error_code error;
        const fs::path candidate = fs::absolute(fs::path(folder) / name, error);
        if (!folder.empty() && !error && fs::is_regular_file(candidate, error) &&
            ::access(candidate.c_str(), X_OK) == 0) {
            return candidate;
        }
    }
    return std::nullopt;
}

void kill_running_program() {
    if (const pid_t child = running; child > 0) {
        ::kill(child, SIGKILL);
    }
}

ProcessResult run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder, std::chrono::seconds time_limit,
                          const std::function<bool()>& give_up) {
    ProcessResult result;
    std::array<int, 2> ends;
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
        result.problem = "cannot be started: " + reason_of(errno);
        return result;
    }
    pid_t child = 0;
    const int error = spawn(program, arguments, folder, ends[1], child);
    ::close(ends[1]);
    if (error != 0) {
        ::close(ends[0]);
        result.problem = "cannot be started: " + reason_of(error);
        return result;
    }

    running = child;
    const bool ended = drain(ends[0], result.output, std::chrono::steady_clock::now() + time_limit, give_up);
    ::close(ends[0]);
    result.given_up = !ended && give_up && give_up();
    result.timed_out = !ended && !result.given_up;
    if (!ended) {
        ::kill(child, SIGKILL);
    }
    running = 0;
    int state = 0;
    pid_t waited = -1;
    do {
        waited = ::waitpid(child, &state, 0);
    } while (waited < 0 && errno == EINTR);

    if (result.given_up) {
        result.problem = "given up";
    } else if (result.timed_out) {
        result.problem = "no end within " + std::to_string(time_limit.count()) + " s";
    } else if (waited < 0) {
        result.problem = "its end could not be observed: " + reason_of(errno);
    } else if (WIFSIGNALED(state)) {
        result.problem = "stopped by signal " + std::to_string(WTERMSIG(state));
    } else if (WEXITSTATUS(state) != 0) {
        result.problem = "exit code " + std::to_string(WEXITSTATUS(state));
    }
    result.succeeded = result.problem.empty();
    return result;
}

}  // namespace delabole
