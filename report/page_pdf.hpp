#pragma once
/// Conversion of pages to PDF with a headless browser.
#include <filesystem>

namespace clast {

/// Finds a browser: that named by CLAST_BROWSER, otherwise Chromium or Chrome on PATH.
/// @throws InputError  if there is none; the message states the package to install
std::filesystem::path find_browser();

/// Prints a page with its charts as PDF in A4. The browser uses a temporary profile.
/// @param page  HTML file
/// @param pdf  output file, overwritten
/// @param seconds  time limit
/// @throws InputError  if the browser cannot be started, exceeds the time limit, or writes no PDF
void print_page_to_pdf(const std::filesystem::path& page, const std::filesystem::path& pdf,
                       const std::filesystem::path& browser, double seconds = 180.0);

}  // namespace clast
