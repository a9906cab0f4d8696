// Tasks are done in order, what waits is bounded, and a fault reaches who waits for it.
#include <atomic>
#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

#include "engine/files/background_writer.hpp"
#include "tests/catch.hpp"

namespace sluice::test_background_writer {

TEST_CASE("Tasks are done in their order") {
    const std::size_t capacity = GENERATE(std::size_t{0}, std::size_t{1}, std::size_t{1000});
    std::vector<int> done;
    BackgroundWriter writer(capacity);
    for (int k = 0; k < 100; ++k) writer.add(10, [&, k] { done.push_back(k); });
    writer.finish();
    REQUIRE(done.size() == 100);
    for (int k = 0; k < 100; ++k) CHECK(done[static_cast<std::size_t>(k)] == k);
}

TEST_CASE("A slow disk holds nobody up until the queue is full, and then the one who adds") {
    std::promise<void> disk;
    std::shared_future<void> answer = disk.get_future().share();
    std::atomic<int> written = 0;
    BackgroundWriter writer(100);
    const auto write = [&, answer] { answer.wait(), ++written; };
    // One is being written; of 40 bytes each, two wait.
    std::promise<void> started;
    writer.add(40, [&, write] { started.set_value(), write(); });
    started.get_future().wait();
    for (int k = 0; k < 2; ++k) writer.add(40, write);
    CHECK(written == 0);
    // The disk answers when who does not wait would long have gone on.
    const auto answered = std::async(std::launch::async, [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        disk.set_value();
    });
    writer.add(40, write);
    CHECK(written > 0);
    CHECK(writer.waited() > 0);
    writer.finish();
    CHECK(written == 4);
}

TEST_CASE("A task larger than the queue is taken when nothing else waits") {
    BackgroundWriter writer(1);
    int done = 0;
    for (int k = 0; k < 3; ++k) writer.add(1000, [&] { ++done; });
    writer.finish();
    CHECK(done == 3);
}

TEST_CASE("After a fault nothing of what waited is done, the fault is thrown once, and writing goes on") {
    std::promise<void> all_added;
    std::shared_future<void> ready = all_added.get_future().share();
    int done = 0;
    BackgroundWriter writer(1000);
    writer.add(1, [ready] {
        ready.wait();
        throw std::runtime_error("full");
    });
    for (int k = 0; k < 3; ++k) writer.add(1, [&] { ++done; });
    all_added.set_value();
    CHECK_THROWS_WITH(writer.finish(), "full");
    CHECK(done == 0);
    writer.add(1, [&] { ++done; });
    writer.finish();
    CHECK(done == 1);
}

TEST_CASE("What waits is done before a writer goes") {
    int done = 0;
    {
        BackgroundWriter writer(1000);
        for (int k = 0; k < 20; ++k) writer.add(1, [&] { ++done; });
    }
    CHECK(done == 20);
}

}  // namespace sluice::test_background_writer
