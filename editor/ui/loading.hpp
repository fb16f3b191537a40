// SPDX-License-Identifier: MIT
// Files are read on a thread of their own, one after the other, while the window goes on drawing.
#pragma once
#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace steradian::ui {

/// How far a load is, and whether it should go on. Any thread.
class LoadStatus {
 public:
  /// From now on `step` ("Reading"): the part of the whole from `begin` to `end`, 0..1.
  void enter(std::string step, double begin, double end);
  /// A share of the step, 0..1.
  void report(double fraction);
  void cancel() { cancelled_ = true; }
  bool cancelled() const { return cancelled_; }

  struct Shown {
    std::string step;
    double fraction = 0.0;  // of the whole
  };
  Shown shown() const;

 private:
  mutable std::mutex mutex_;
  Shown shown_;
  double begin_ = 0.0, end_ = 1.0;
  std::atomic<bool> cancelled_ = false;
};

/// What a load has read, ready to be taken over on the thread of the frame loop.
using Taking = std::function<void()>;

struct Load {
  std::string name;   // for people: "dragon.ply"
  bool modal = true;  // the document must not change meanwhile
  /// On the worker. Throws when the file is at fault.
  std::function<Taking(LoadStatus&)> read;
  /// On the thread of the frame loop when there is nothing to take; no reason = cancelled.
  std::function<void(const std::string& reason)> dropped;
};

/// Owns the worker. All methods on the thread of the frame loop.
class Loading {
 public:
  /// `wake` is called on the worker when something waits to be taken.
  explicit Loading(std::function<void()> wake = {}) : wake_(std::move(wake)) {}
  ~Loading();  // waits for the worker: see stopWithin

  /// Now, or after those that were started before.
  void start(Load load);
  /// Between frames: takes what is ready, once, and starts what waits. Throws what taking throws.
  void advance();
  /// Drops what runs and what waits; at once, although the worker may need a while to notice. What is
  /// started meanwhile waits for it.
  void cancel();
  /// Cancels, and waits. False when the worker did not end in time: a plugin does not answer.
  bool stopWithin(std::chrono::milliseconds limit);

  bool busy() const { return front() != nullptr; }
  bool modal() const { return front() && front()->modal; }

  /// For the progress window.
  struct View {
    std::string name, step;
    double fraction = 0.0, seconds = 0.0;  // since its start
    std::size_t waiting = 0;               // others after it
  };
  View view() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Run {
    Load load;
    Clock::time_point start = Clock::now();
    LoadStatus status;
    Taking taking;       // set before `done`
    std::string reason;  // set before `done`
    std::atomic<bool> done = false;
    std::jthread thread;  // last: ends before the rest dies
  };
  const Load* front() const;
  void begin(Load load);
  void take();
  static void work(Run& run, const std::function<void()>& wake);

  std::function<void()> wake_;
  std::unique_ptr<Run> run_;
  std::deque<Load> waiting_;
};

}  // namespace steradian::ui
