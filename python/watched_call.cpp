#include "python/watched_call.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <thread>

namespace clast::python_detail {

namespace py = pybind11;

namespace {

constexpr std::chrono::milliseconds kBetweenLooks{50};

/// State shared by the two threads.
struct Exchange {
  std::mutex mutex;
  std::condition_variable changed;
  std::optional<ProgressUpdate> latest;  ///< not yet passed on
  bool stop = false;
  bool done = false;
  std::exception_ptr failure;

  void report(const ProgressUpdate& step) {
    const std::lock_guard lock(mutex);
    if (stop) throw Cancelled();
    latest = step;
  }

  /// Waits a little, without the interpreter's lock.
  std::optional<ProgressUpdate> wait(bool& is_done) {
    const py::gil_scoped_release release;
    std::unique_lock lock(mutex);
    changed.wait_for(lock, kBetweenLooks, [&] { return done; });
    is_done = done;
    return std::exchange(latest, std::nullopt);
  }
};

void pass_on(const py::object& progress, const ProgressUpdate& step) {
  if (progress.is_none()) return;
  using namespace pybind11::literals;
  progress(py::dict("done"_a = step.done, "total"_a = step.total, "before"_a = step.done_before,
                    "what"_a = step.activity));
}

}  // namespace

std::mutex& file_mutex() { return py::get_or_create_shared_data<std::mutex>("clast file access"); }

void call_with_progress(const py::object& progress,
                        const std::function<void(const ProgressCallback&)>& job, std::mutex& busy) {
  if (!progress.is_none() && !PyCallable_Check(progress.ptr())) {
    throw py::type_error("progress: must be a callable that takes a dict");
  }
  Exchange exchange;
  std::thread worker([&] {
    try {
      const std::lock_guard lock(busy);
      job([&](const ProgressUpdate& step) { exchange.report(step); });
    } catch (...) {
      exchange.failure = std::current_exception();
    }
    const std::lock_guard lock(exchange.mutex);
    exchange.done = true;
    exchange.changed.notify_all();
  });
  std::exception_ptr raised;
  for (bool done = false; !done;) {
    const std::optional<ProgressUpdate> step = exchange.wait(done);
    if (raised) continue;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (step) pass_on(progress, *step);
    } catch (const py::error_already_set&) {
      raised = std::current_exception();
      const std::lock_guard lock(exchange.mutex);
      exchange.stop = true;
    }
  }
  {
    const py::gil_scoped_release release;
    worker.join();
  }
  if (raised) std::rethrow_exception(raised);
  if (exchange.failure) std::rethrow_exception(exchange.failure);
}

}  // namespace clast::python_detail
