#include "fitting/work/ranks.hpp"

#ifdef DELABOLE_WITH_MPI
#include <mpi.h>
#endif

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace delabole {

namespace {

// Whether a launcher has started this process as one of several. MPI is initialised only then, since that takes time
// and prints complaints where it fails, which would be wrong for a program that runs alone. The names are those set by
// Open MPI, by MPICH and Intel MPI, and by Slurm's srun.
bool is_one_of_several() {
    constexpr std::array words{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"};
    return std::any_of(words.begin(), words.end(), [](const char* word) {
        const char* value = std::getenv(word);  // NOLINT(concurrency-mt-unsafe): nobody sets any
        return value != nullptr && std::atoi(value) > 1;
    });
}

}  // namespace

std::string Ranks::machine() {
    std::array<char, 256> name{};
    ::gethostname(name.data(), name.size() - 1);
    return name.data();
}

std::string_view Ranks::word(const std::string& text) const {
    const std::lock_guard lock(mutex_);
    return *words_.insert(text).first;
}

#ifdef DELABOLE_WITH_MPI

namespace {

// MPI's own waiting keeps a processor busy that the threads of this rank and other ranks could use.
void await(MPI_Request& request) {
    constexpr int impatient = 2000;
    int arrived = 0;
    for (int tries = 0; arrived == 0; ++tries) {
        MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
        if (arrived == 0 && tries > impatient) {
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
    }
}

}  // namespace

Ranks::Ranks() {
    if (!is_one_of_several()) {
        return;
    }
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    MPI_Comm_rank(MPI_COMM_WORLD, &number_);
}

Ranks::~Ranks() {
    int begun = 0;
    MPI_Initialized(&begun);
    if (begun != 0) {
        MPI_Request request{};
        MPI_Ibarrier(MPI_COMM_WORLD, &request);
        await(request);
        MPI_Finalize();
    }
}

std::vector<std::string> Ranks::exchange(const std::string& own) const {
    if (alone()) {
        return {own};
    }
    const auto ranks = static_cast<std::size_t>(count_);
    const std::uint64_t own_size = own.size();
    std::vector<std::uint64_t> sizes(ranks);
    MPI_Request request{};
    MPI_Iallgather(&own_size, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD, &request);
    await(request);
    std::vector<std::string> all(ranks);
    for (std::size_t rank = 0; rank < ranks; ++rank) {
        std::string& bytes = all[rank];
        bytes = static_cast<int>(rank) == number_ ? own : std::string(sizes[rank], '\0');
        constexpr std::size_t most = std::size_t{1} << 30U;  // MPI counts with an int
        for (std::size_t first = 0; first < bytes.size(); first += most) {
            const auto count = static_cast<int>(std::min(most, bytes.size() - first));
            MPI_Ibcast(bytes.data() + first, count, MPI_BYTE, static_cast<int>(rank), MPI_COMM_WORLD, &request);
            await(request);
        }
    }
    return all;
}

void Ranks::end_all(int code) const {
    if (!alone()) {
        MPI_Abort(MPI_COMM_WORLD, code);
    }
}

#else

Ranks::Ranks() {
    if (is_one_of_several()) {
        throw std::runtime_error(
            "mpirun has started several processes, but this program was built without MPI: install libopenmpi-dev and "
            "build it again, or run it alone with --threads");
    }
}

Ranks::~Ranks() = default;

std::vector<std::string> Ranks::exchange(const std::string& own) const {
    return {own};
}

void Ranks::end_all(int) const {}

#endif

}  // namespace delabole
