// SPDX-License-Identifier: MIT
// The worker and the hand-over.
#include "editor/ui/loading.hpp"

#include <new>
#include <utility>

namespace steradian::ui {

void LoadStatus::enter(std::string step, double begin, double end) {
  const std::lock_guard lock(mutex_);
  shown_ = {std::move(step), begin};
  begin_ = begin;
  end_ = end;
}

void LoadStatus::report(double fraction) {
  const std::lock_guard lock(mutex_);
  shown_.fraction = begin_ + (end_ - begin_) * fraction;
}

LoadStatus::Shown LoadStatus::shown() const {
  const std::lock_guard lock(mutex_);
  return shown_;
}

Loading::~Loading() {
  cancel();
}

const Load* Loading::front() const {
  if (run_ && !run_->status.cancelled()) return &run_->load;
  return waiting_.empty() ? nullptr : &waiting_.front();
}

void Loading::start(Load load) {
  if (run_)
    waiting_.push_back(std::move(load));
  else
    begin(std::move(load));
}

void Loading::begin(Load load) {
  run_ = std::make_unique<Run>();
  run_->load = std::move(load);
  run_->thread = std::jthread([run = run_.get(), wake = wake_] { work(*run, wake); });
}

void Loading::work(Run& run, const std::function<void()>& wake) {
  try {
    run.taking = run.load.read(run.status);
    if (run.status.cancelled()) run.taking = nullptr;  // large things die here, not in the frame loop
  } catch (const std::bad_alloc&) {
    run.reason = run.load.name + ": not enough memory to read it";
  } catch (const std::exception& error) {
    run.reason = error.what();
  }
  run.done = true;
  if (wake) wake();
}

void Loading::advance() {
  if (run_ && run_->done) take();
  if (run_ || waiting_.empty()) return;
  Load next = std::move(waiting_.front());
  waiting_.pop_front();
  begin(std::move(next));
}

void Loading::take() {
  const std::unique_ptr<Run> finished = std::move(run_);
  finished->thread.join();
  if (finished->status.cancelled()) return;
  if (finished->taking)
    finished->taking();
  else
    finished->load.dropped(finished->reason);
}

void Loading::cancel() {
  std::deque<Load> dropped = std::exchange(waiting_, {});
  const bool running = run_ && !run_->status.cancelled();
  if (running) run_->status.cancel();
  if (running) run_->load.dropped({});
  for (const Load& load : dropped) load.dropped({});
}

bool Loading::stopWithin(std::chrono::milliseconds limit) {
  cancel();
  const auto end = Clock::now() + limit;
  while (run_ && !run_->done && Clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  return !run_ || run_->done;
}

Loading::View Loading::view() const {
  if (!busy()) return {};
  if (!run_ || front() != &run_->load)
    return {front()->name, "Waiting until the cancelled file lets go", 0.0, 1e9, waiting_.size() - 1};
  const LoadStatus::Shown shown = run_->status.shown();
  return {run_->load.name, shown.step, shown.fraction,
          std::chrono::duration<double>(Clock::now() - run_->start).count(), waiting_.size()};
}

}  // namespace steradian::ui
