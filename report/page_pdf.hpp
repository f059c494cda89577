#pragma once
/// Conversion of pages to PDF with a headless browser.
#include <filesystem>

namespace clast {

/// Finds the browser for printing pages: that named by CLAST_BROWSER, otherwise Chromium or Chrome.
/// @throws InputError  if there is no browser; the message states the package to install
std::filesystem::path find_browser();

/// Prints an HTML page with its charts as PDF in A4.
/// @param page  HTML file
/// @param pdf  output file, which is overwritten
/// @param seconds  time limit
/// @throws InputError  if the browser cannot be started, exceeds the time limit, or writes no PDF
void print_page_to_pdf(const std::filesystem::path& page, const std::filesystem::path& pdf,
                       const std::filesystem::path& browser, double seconds = 180.0);

}  // namespace clast
