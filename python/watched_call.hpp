#pragma once
/// Long calls during which the interpreter runs, with progress and interruption by Ctrl-C.
#include <pybind11/pybind11.h>

#include <functional>
#include <mutex>
#include <optional>

#include "core/progress.hpp"

namespace clast::python_detail {

/// Returns the mutex for file access, because HDF5 is not thread-safe. It must be locked without
/// holding the GIL.
/// @pre  the GIL is held
std::mutex& file_mutex();

/// Runs a long job on another thread that locks `busy`. Meanwhile, this thread releases the GIL,
/// checks for signals and calls `progress`. Signals and exceptions of `progress` end the job and
/// are raised here.
/// @param progress  None or a callable
void call_with_progress(const pybind11::object& progress,
                        const std::function<void(const ProgressCallback&)>& job,
                        std::mutex& busy = file_mutex());

/// Runs a long job that returns a value, with progress (see `call_with_progress`).
template <class Job>
auto run_with_progress(const pybind11::object& progress, const Job& job) {
  std::optional<decltype(job(ProgressCallback()))> result;
  call_with_progress(progress, [&](const ProgressCallback& step) { result.emplace(job(step)); });
  return std::move(*result);
}

/// Runs a short job on this thread without the GIL, with exclusive file access.
template <class Job>
auto run_without_gil(const Job& job) {
  std::mutex& access = file_mutex();
  const pybind11::gil_scoped_release release;
  const std::lock_guard files(access);
  return job();
}

}  // namespace clast::python_detail
