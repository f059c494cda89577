#pragma once
/// Long calls: the interpreter goes on, Ctrl-C is heard, progress is reported.
#include <pybind11/pybind11.h>

#include <functional>
#include <mutex>
#include <optional>

#include "core/progress.hpp"

namespace clast::python_detail {

/// HDF5 serves one thread at a time, and Python may call from several: whoever reads or writes
/// files holds this, without the interpreter's lock. Both extensions have the same.
/// @pre  the interpreter's lock is held
std::mutex& file_mutex();

/// Runs `job` on a thread of its own, which holds `busy`, while this one lets the interpreter
/// go on, looks for signals twenty times a second, and calls `progress` with a dict (done, total,
/// before, what) where something is new. A signal, or what `progress` raises, ends the job at its
/// next step of progress, and is raised here.
/// @param progress  None or a callable
void watch(const pybind11::object& progress, const std::function<void(const ProgressCallback&)>& job,
           std::mutex& busy = file_mutex());

/// The same for a job that returns something.
template <class Job>
auto run_with_progress(const pybind11::object& progress, const Job& job) {
  std::optional<decltype(job(ProgressCallback()))> result;
  watch(progress, [&](const ProgressCallback& step) { result.emplace(job(step)); });
  return std::move(*result);
}

/// A shorter job, which nothing interrupts: on this thread, with the files to itself.
template <class Job>
auto without_gil(const Job& job) {
  std::mutex& access = file_mutex();
  const pybind11::gil_scoped_release release;
  const std::lock_guard files(access);
  return job();
}

}  // namespace clast::python_detail
