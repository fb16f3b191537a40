// SPDX-License-Identifier: MIT
// Files read beside the frame loop: what was read is taken once, there, or a reason is told, or nothing
// happens.
#include <gtest/gtest.h>

#include <future>
#include <stdexcept>

#include "editor/ui/loading.hpp"

namespace steradian::ui {
namespace {

using namespace std::chrono_literals;

/// Loads that tell what became of them.
class LoadingTest : public testing::Test {
 protected:
  Load load(const std::string& name, std::function<void(LoadStatus&)> work = {}) {
    return {name, true,
            [this, name, work](LoadStatus& status) -> Taking {
              if (work) work(status);
              return [this, name] {
                events.push_back(name);
                takenOn = std::this_thread::get_id();
              };
            },
            [this, name](const std::string& reason) { events.push_back(name + " dropped: " + reason); }};
  }
  /// As the frame loop does, until nothing is left to do.
  void frames(Loading& loading) {
    for (int i = 0; i < 2000 && loading.busy(); ++i) {
      loading.advance();
      std::this_thread::sleep_for(1ms);
    }
    EXPECT_FALSE(loading.busy());
  }
  /// Work that ends when it is cancelled, or when the test says so.
  std::function<void(LoadStatus&)> untilCancelled() {
    return [this](LoadStatus& status) {
      started.set_value();
      while (!status.cancelled()) std::this_thread::sleep_for(1ms);
      noticed = true;
    };
  }

  std::vector<std::string> events;
  std::thread::id takenOn;
  std::promise<void> started;
  std::atomic<bool> noticed = false;
};

TEST_F(LoadingTest, what_was_read_is_taken_once_by_the_thread_of_the_frame_loop) {
  std::thread::id readOn;
  std::atomic<int> woken = 0;
  Loading loading([&] { ++woken; });
  loading.start(load("chair", [&](LoadStatus&) { readOn = std::this_thread::get_id(); }));
  EXPECT_TRUE(loading.modal());
  frames(loading);
  loading.advance();
  EXPECT_EQ(events, std::vector<std::string>{"chair"});
  EXPECT_EQ(takenOn, std::this_thread::get_id());
  EXPECT_NE(readOn, std::this_thread::get_id());
  EXPECT_EQ(woken, 1);
}

TEST_F(LoadingTest, nothing_is_taken_before_the_frame_loop_asks) {
  Loading loading;
  loading.start(load("chair"));
  ASSERT_TRUE(loading.busy());
  std::this_thread::sleep_for(50ms);
  EXPECT_TRUE(events.empty());
  EXPECT_TRUE(loading.busy());
  frames(loading);
}

TEST_F(LoadingTest, an_error_is_told_with_its_reason_and_the_next_file_goes_on) {
  Loading loading;
  loading.start(load("bad", [](LoadStatus&) { throw std::runtime_error("bad.obj: line 3"); }));
  loading.start(load("huge", [](LoadStatus&) { throw std::bad_alloc(); }));
  loading.start(load("chair"));
  frames(loading);
  EXPECT_EQ(events, (std::vector<std::string>{"bad dropped: bad.obj: line 3",
                                              "huge dropped: huge: not enough memory to read it", "chair"}));
}

TEST_F(LoadingTest, files_are_read_one_after_the_other_in_their_order) {
  std::atomic<int> running = 0, most = 0;
  Loading loading;
  for (const char* name : {"a", "b", "c"})
    loading.start(load(name, [&](LoadStatus&) {
      most = std::max(most.load(), ++running);
      std::this_thread::sleep_for(5ms);
      --running;
    }));
  frames(loading);
  EXPECT_EQ(events, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(most, 1);
}

TEST_F(LoadingTest, cancelling_frees_the_window_at_once_and_drops_what_waits) {
  Loading loading;
  loading.start(load("slow", untilCancelled()));
  loading.start(load("next"));
  started.get_future().wait();
  loading.cancel();
  EXPECT_FALSE(loading.busy());
  EXPECT_EQ(events, (std::vector<std::string>{"slow dropped: ", "next dropped: "}));
  EXPECT_TRUE(loading.stopWithin(5s));
  loading.advance();
  EXPECT_TRUE(noticed);
  EXPECT_EQ(events.size(), 2u) << "what it read is not taken";
}

TEST_F(LoadingTest, a_new_load_waits_for_a_cancelled_one_that_has_not_noticed_yet) {
  std::promise<void> letGo;
  Loading loading;
  loading.start(load("deaf", [&](LoadStatus&) {
    started.set_value();
    letGo.get_future().wait();
  }));
  started.get_future().wait();
  loading.cancel();
  loading.start(load("chair"));
  loading.advance();
  EXPECT_EQ(loading.view().name, "chair");
  EXPECT_FALSE(loading.stopWithin(20ms)) << "and the end of the program is told so";
  loading.start(load("table"));
  letGo.set_value();
  frames(loading);
  EXPECT_EQ(events, (std::vector<std::string>{"deaf dropped: ", "chair dropped: ", "table"}));
}

TEST_F(LoadingTest, its_end_waits_for_the_worker) {
  {
    Loading loading;
    loading.start(load("slow", untilCancelled()));
    started.get_future().wait();
  }
  EXPECT_TRUE(noticed);
}

TEST_F(LoadingTest, the_progress_of_a_step_is_a_part_of_the_whole) {
  LoadStatus status;
  status.enter("Reading", 0.0, 0.6);
  status.report(0.5);
  EXPECT_EQ(status.shown().step, "Reading");
  EXPECT_DOUBLE_EQ(status.shown().fraction, 0.3);
  status.enter("Building", 0.6, 1.0);
  EXPECT_DOUBLE_EQ(status.shown().fraction, 0.6);
  status.report(1.0);
  EXPECT_DOUBLE_EQ(status.shown().fraction, 1.0);
}

}  // namespace
}  // namespace steradian::ui
