#pragma once
/// Pages as PDF, by a browser without a window.
#include <filesystem>

namespace clast {

/// The browser that prints: the one that the environment variable CLAST_BROWSER names, else the
/// first of Chromium and Chrome by PATH.
/// @throws InputError  there is none; the message says what to install
std::filesystem::path find_browser();

/// Prints a page on A4 with its charts. The browser's profile is a folder that is removed.
/// @param page     HTML, a file
/// @param pdf      is written, also over a file
/// @param seconds  time the browser has
/// @throws InputError  it can't be started, took too long, or wrote no PDF
void print_page(const std::filesystem::path& page, const std::filesystem::path& pdf,
                const std::filesystem::path& browser, double seconds = 180.0);

}  // namespace clast
