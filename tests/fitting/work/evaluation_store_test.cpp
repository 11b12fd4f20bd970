#include "fitting/work/evaluation_store.hpp"
#include "fitting/back_analysis/back_analysis.hpp"
#include "fitting/work/parallel.hpp"
#include "tests/fitting/test_models.hpp"
#include "tests/plots/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace delabole {
namespace {

using test::answer;
using test::formula_model;

std::vector<std::uint64_t> bits(const std::vector<double>& values) {
    std::vector<std::uint64_t> result;
    for (const double value : values) {
        result.push_back(std::bit_cast<std::uint64_t>(value));
    }
    return result;
}

std::vector<double> coordinates(const Polyline& line) {
    std::vector<double> result;
    for (const Point& point : line) {
        result.insert(result.end(), {point.x(), point.y()});
    }
    return result;
}

void expect_same(const Prediction& one, const Prediction& other) {
    EXPECT_EQ(one.failure, other.failure);
    EXPECT_EQ(bits(one.outputs), bits(other.outputs));
    EXPECT_EQ(bits(coordinates(one.profile)), bits(coordinates(other.profile)));
}

// y = x1 + x2, counted; no answer for negative x1.
ModelInterface counted_sum(std::atomic<int>& calls) {
    return formula_model(2, {"y"}, [&calls](std::span<const double> x) {
        ++calls;
        return x[0] < 0 ? Prediction{"negative", {}, {}} : answer({x[0] + x[1]});
    });
}

double sum_at(const ModelInterface& model, double x1, double x2) {
    return model.predict(std::vector<Assignment>{{0, x1}, {1, x2}}).outputs.at(0);
}

class EvaluationStoreTest : public testing::Test {
  protected:
    std::filesystem::path file() const { return folder_.path() / "evaluations.sqlite"; }

    // Returns the message with which the file is refused, and expects that its bytes stay.
    std::string refusal(const std::filesystem::path& path) const {
        const std::string before = std::filesystem::is_directory(path) ? "" : content_of(path);
        try {
            EvaluationStore store(path, "program");
            std::atomic<int> calls = 0;
            const ModelInterface model = stored(counted_sum(calls), store, "sum");
            for (int number = 0; number < 20; ++number) {
                sum_at(model, number, 0.1);
            }
        } catch (const StoreError& error) {
            EXPECT_EQ(std::filesystem::is_directory(path) ? "" : content_of(path), before);
            return error.what();
        }
        return "not refused";
    }

    void fill() const {
        EvaluationStore store(file(), "program");
        std::atomic<int> calls = 0;
        const ModelInterface model = stored(counted_sum(calls), store, "sum");
        for (int number = 0; number < 20; ++number) {
            sum_at(model, number, 0.1);
        }
    }

    void overwrite(std::size_t place, const std::string& bytes) const {
        std::fstream stream(file(), std::ios::binary | std::ios::in | std::ios::out);
        stream.seekp(static_cast<std::streamoff>(place));
        stream << bytes;
    }

    ScratchFolder folder_;
};

TEST_F(EvaluationStoreTest, GivesTheSameBitsAgain) {
    const auto formula = [](std::span<const double> x) {
        const double tiny = std::numeric_limits<double>::denorm_min();
        return Prediction{{}, {x[0] / 3, -0.0, tiny, 1e308}, {{0.1, -0.0}, {x[0] / 7, tiny}}};
    };
    const ModelInterface plain = formula_model(1, {"a", "b", "c", "d"}, formula);
    const std::vector<Assignment> at{{0, 0.7}};
    for (const bool found : {false, true, true}) {
        EvaluationStore store(file(), "program");
        expect_same(stored(plain, store, "a model").predict(at), plain.predict(at));
        EXPECT_EQ(store.traffic().found, found ? 1 : 0);
        EXPECT_EQ(store.traffic().made, found ? 0 : 1);
    }
}

TEST_F(EvaluationStoreTest, KeepsFailures) {
    std::atomic<int> calls = 0;
    for (int round = 0; round < 2; ++round) {
        EvaluationStore store(file(), "program");
        const Prediction prediction =
            stored(counted_sum(calls), store, "sum").predict(std::vector<Assignment>{{0, -1.0}});
        EXPECT_EQ(prediction.failure, "negative");
        EXPECT_TRUE(prediction.outputs.empty());
    }
    EXPECT_EQ(calls, 1);
}

TEST_F(EvaluationStoreTest, TellsProgramsModelsInputsAndBitsApart) {
    std::atomic<int> calls = 0;
    EvaluationStore store(file(), "program");
    const ModelInterface model = stored(counted_sum(calls), store, "sum");
    sum_at(model, 1, 2);
    EXPECT_EQ(calls, 1);
    // The point is the same in another order; of an input given twice the last value counts.
    EXPECT_EQ(model.predict(std::vector<Assignment>{{1, 5.0}, {1, 2.0}, {0, 1.0}}).outputs.at(0), 3);
    EXPECT_EQ(calls, 1);
    model.predict(std::vector<Assignment>{{0, 1.0}});  // x2 has its base value, unknown to the store: another key
    sum_at(model, 2, 1);
    sum_at(model, 1, std::nextafter(2.0, 3.0));
    EXPECT_EQ(calls, 4);
    sum_at(stored(counted_sum(calls), store, "another sum"), 1, 2);
    EXPECT_EQ(calls, 5);
    EvaluationStore other(file(), "another program");
    sum_at(stored(counted_sum(calls), other, "sum"), 1, 2);
    EXPECT_EQ(calls, 6);
    sum_at(model, 1, 2);
    EXPECT_EQ(calls, 6) << "what the other program kept took nothing away";
}

TEST_F(EvaluationStoreTest, ThreadsWaitForWhatIsUnderWay) {
    std::atomic<int> calls = 0;
    EvaluationStore store(file(), "program");
    const ModelInterface slow = formula_model(1, {"y"}, [&](std::span<const double> x) {
        ++calls;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        return answer({x[0]});
    });
    const ModelInterface model = stored(slow, store, "slow");
    std::vector<double> answers(8);
    run_tasks(8, 8, [&](std::size_t number) {
        answers[number] = model.predict(std::vector<Assignment>{{0, static_cast<double>(number % 2)}}).outputs.at(0);
    });
    EXPECT_EQ(calls, 2);
    EXPECT_EQ(answers, (std::vector<double>{0, 1, 0, 1, 0, 1, 0, 1}));
    EXPECT_EQ(store.traffic().found, 6);
}

TEST_F(EvaluationStoreTest, AnExceptionOfTheModelLeavesNothing) {
    int calls = 0;
    EvaluationStore store(file(), "program");
    const ModelInterface model = stored(formula_model(1, {"y"},
                                                      [&](std::span<const double>) {
                                                          if (++calls == 1) {
                                                              throw std::runtime_error("first");
                                                          }
                                                          return answer({1});
                                                      }),
                                        store, "throws once");
    EXPECT_THROW(model.predict({}), std::runtime_error);
    EXPECT_EQ(model.predict({}).outputs.at(0), 1);
    EXPECT_EQ(calls, 2);
}

TEST_F(EvaluationStoreTest, TwoProcessesWriteAtOnce) {
    constexpr int points = 100;  // points of each process, half of which the other has too
    const auto work = [&](int first) {
        EvaluationStore store(file(), "program");
        std::atomic<int> calls = 0;
        const ModelInterface model = stored(counted_sum(calls), store, "sum");
        bool right = true;
        for (int number = first; number < first + points; ++number) {
            right = right && sum_at(model, number, 0.5) == number + 0.5;
        }
        return right ? 0 : 1;
    };
    std::vector<pid_t> children;
    for (const int first : {0, points / 2}) {
        children.push_back(::fork());
        if (children.back() == 0) {
            int code = 2;
            try {
                code = work(first);
            } catch (const std::exception&) {
            }
            ::_exit(code);
        }
    }
    for (const pid_t child : children) {
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    EvaluationStore store(file(), "program");
    std::atomic<int> calls = 0;
    const ModelInterface model = stored(counted_sum(calls), store, "sum");
    for (int number = 0; number < points / 2 + points; ++number) {
        EXPECT_EQ(sum_at(model, number, 0.5), number + 0.5);
    }
    EXPECT_EQ(calls, 0);
}

// A process reports each evaluation that it has finished, and is killed at some moment, often while it is storing one.
TEST_F(EvaluationStoreTest, AKillLosesNothingFinished) {
    double finished_before = 0;
    for (int round = 0; round < 12; ++round) {
        std::array<int, 2> channel{};
        ASSERT_EQ(::pipe(channel.data()), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            EvaluationStore store(file(), "program");
            std::atomic<int> calls = 0;
            const ModelInterface model = stored(counted_sum(calls), store, "sum");
            for (double x = finished_before;; ++x) {
                sum_at(model, x, 0.25);
                if (::write(channel[1], &x, sizeof x) != sizeof x) {
                    ::_exit(1);
                }
            }
        }
        ::close(channel[1]);
        std::this_thread::sleep_for(std::chrono::milliseconds(20 + 7 * round));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        double last = finished_before - 1;
        while (::read(channel[0], &last, sizeof last) == sizeof last) {
        }
        ::close(channel[0]);

        EvaluationStore store(file(), "program");
        std::atomic<int> calls = 0;
        const ModelInterface model = stored(counted_sum(calls), store, "sum");
        for (double x = 0; x <= last; ++x) {
            ASSERT_EQ(sum_at(model, x, 0.25), x + 0.25);
        }
        ASSERT_EQ(calls, 0) << "round " << round;
        finished_before = last + 1;
    }
    EXPECT_GT(finished_before, 12) << "the kills came too early to say anything";
}

TEST_F(EvaluationStoreTest, AnEmptyFileBecomesAStore) {
    std::ofstream(file()).close();
    fill();
    EvaluationStore store(file(), "program");
    std::atomic<int> calls = 0;
    sum_at(stored(counted_sum(calls), store, "sum"), 3, 0.1);
    EXPECT_EQ(calls, 0);
}

TEST_F(EvaluationStoreTest, RefusesWhatIsNoStore) {
    std::ofstream(file()) << "A text of some length, which is no database and shall stay as it is.\n";
    EXPECT_EQ(refusal(file()), file().string() +
                                   " is no evaluation store: name another file, or move this one away; "
                                   "nothing in it was changed");
    EXPECT_NE(refusal(folder_.path()).find("is no ordinary file"), std::string::npos);
    EXPECT_THROW(EvaluationStore(folder_.path() / "missing" / "file", "program"), StoreError);
}

// The header of an SQLite database holds the user version in bytes 60 to 63, the application in 68 to 71, most
// significant first (www.sqlite.org/fileformat.html).
TEST_F(EvaluationStoreTest, RefusesAnotherLayoutAndOtherDatabases) {
    fill();
    overwrite(63, "\x07");
    EXPECT_NE(refusal(file()).find("is an evaluation store of layout 7, of another version of delabole; this one uses "
                                   "layout 1: name another file"),
              std::string::npos)
        << refusal(file());
    overwrite(68, "ABCD");
    EXPECT_NE(refusal(file()).find("is a database of another program"), std::string::npos);
}

TEST_F(EvaluationStoreTest, RefusesDamagedFiles) {
    fill();
    const std::string whole = content_of(file());
    ASSERT_GT(whole.size(), 8192U);
    overwrite(4096, std::string(4096, '\x5A'));  // the second page
    EXPECT_NE(refusal(file()).find("is damaged ("), std::string::npos) << refusal(file());
    std::filesystem::resize_file(file(), 6000);
    EXPECT_NE(refusal(file()).find("is damaged ("), std::string::npos) << refusal(file());
}

TEST_F(EvaluationStoreTest, FindsASingleWrongBit) {
    fill();
    // The answer 5.1 for x1 = 5 stands in the file but once.
    const auto number = std::bit_cast<std::array<char, 8>>(5 + 0.1);
    const std::string content = content_of(file());
    const std::size_t place = content.find(std::string(number.data(), number.size()));
    ASSERT_NE(place, std::string::npos);
    overwrite(place, std::string(1, static_cast<char>(number[0] ^ 1)));
    EXPECT_NE(refusal(file()).find("is damaged (an entry differs from its checksum)"), std::string::npos);
}

TEST_F(EvaluationStoreTest, AFitFromTheStoreIsTheSameFit) {
    std::atomic<int> calls = 0;
    const auto fitted = [&](EvaluationStore& store) {
        FitProblem problem = test::problem_of(stored(counted_sum(calls), store, "sum"),
                                              {test::with_prior("x1", 0, 4, 1, 0.5), test::free_parameter("x2", 0, 4)},
                                              {test::observe("y", 3, 0.1)});
        problem.settings.starts = 4;
        problem.settings.evaluations_per_start = 50;
        problem.settings.profile_points = 5;
        problem.settings.map_points = 5;
        return fit(problem);
    };
    EvaluationStore store(file(), "program");
    const FitResult first = fitted(store);
    const int made = calls;
    EXPECT_GT(made, 50);
    const FitResult second = fitted(store);
    EXPECT_EQ(calls, made);
    EXPECT_EQ(bits(first.mechanisms.at(0).best), bits(second.mechanisms.at(0).best));
}

// Each thread has a connection of its own, as a process would.
TEST_F(EvaluationStoreTest, ManyMayOpenANewFileAtOnce) {
    constexpr int files = 20;
    constexpr int openers = 6;
    for (int number = 0; number < files; ++number) {
        const std::filesystem::path path = file().string() + std::to_string(number);
        std::atomic<int> waiting = openers;
        std::vector<std::string> faults(openers);
        std::vector<std::thread> threads;
        for (int opener = 0; opener < openers; ++opener) {
            threads.emplace_back([&, opener] {
                --waiting;
                while (waiting > 0) {
                    std::this_thread::yield();
                }
                try {
                    const EvaluationStore store(path, "program");
                } catch (const StoreError& error) {
                    faults[static_cast<std::size_t>(opener)] = error.what();
                }
            });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        for (const std::string& fault : faults) {
            ASSERT_EQ(fault, "");
        }
    }
}

}  // namespace
}  // namespace delabole
