// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "host/thread_pool.hpp"

#include <algorithm>

namespace echoarc::host {

ThreadPool::ThreadPool(std::size_t threads) {
  for (std::size_t i = 1; i < threads; ++i) workers_.emplace_back([this] { work(); });
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  begin_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::run(std::size_t count, const std::function<void(std::size_t)>& task) {
  if (count == 0) return;
  Batch batch{.task = task, .count = count, .error = nullptr};
  std::unique_lock lock(mutex_);
  open_.push_back(&batch);
  begin_.notify_all();
  while (batch.begun < batch.count) run_one(batch, lock);
  end_.wait(lock, [&] { return batch.ended == batch.count; });
  if (batch.error) std::rethrow_exception(batch.error);
}

void ThreadPool::run_one(Batch& batch, std::unique_lock<std::mutex>& lock) {
  const std::size_t index = batch.begun++;
  if (batch.begun == batch.count) std::erase(open_, &batch);
  std::exception_ptr error;
  lock.unlock();
  try {
    batch.task(index);
  } catch (...) {
    error = std::current_exception();
  }
  lock.lock();
  if (error && !batch.error) batch.error = error;
  if (++batch.ended == batch.count) end_.notify_all();
}

void ThreadPool::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    begin_.wait(lock, [this] { return closing_ || !open_.empty(); });
    if (closing_) return;
    run_one(*open_.back(), lock);
  }
}

std::size_t hardware_threads() {
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace echoarc::host
