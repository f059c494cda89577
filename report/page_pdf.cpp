#include "report/page_pdf.hpp"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/files/child_process.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "report/html/html_page.hpp"

namespace clast {

namespace fs = std::filesystem;
namespace {

/// A folder of its own that is gone at the end.
class BrowserProfile {
 public:
  BrowserProfile() {
    std::error_code code;
    std::string name = (fs::temp_directory_path(code) / "clast-browser-XXXXXX").string();
    if (code || ::mkdtemp(name.data()) == nullptr) {
      throw InputError(
          "cannot make a folder for the browser in the folder for temporary files; set TMPDIR to a "
          "writable folder");
    }
    folder_ = name;
  }
  ~BrowserProfile() {
    std::error_code code;
    fs::remove_all(folder_, code);
  }
  BrowserProfile(const BrowserProfile&) = delete;
  BrowserProfile& operator=(const BrowserProfile&) = delete;

  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

bool is_pdf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  char start[5] = {};
  return stream.read(start, sizeof start) && std::string(start, sizeof start) == "%PDF-";
}

/// Replaces what differs from print to print of the same page, which keeps all lengths: the times,
/// and the numbers of the page's elements, which then begin at 1.
std::string without_print_marks(std::string pdf) {
  constexpr std::string_view kNoTime = "19700101000000";
  for (const std::string_view key : {"/CreationDate (D:", "/ModDate (D:"}) {
    for (std::size_t at = 0; (at = pdf.find(key, at)) != pdf.npos;) {
      at += key.size();
      if (at + kNoTime.size() <= pdf.size()) pdf.replace(at, kNoTime.size(), kNoTime);
    }
  }
  constexpr std::string_view kNode = "(node";
  constexpr std::size_t kDigits = 8;
  std::vector<std::size_t> places;
  std::uint32_t minimum = UINT32_MAX;
  const auto number_at = [&](std::size_t at) {
    std::uint32_t number = 0;
    std::from_chars(pdf.data() + at, pdf.data() + at + kDigits, number);
    return number;
  };
  for (std::size_t at = 0; (at = pdf.find(kNode, at)) != pdf.npos;) {
    at += kNode.size();
    const std::string_view digits = std::string_view(pdf).substr(at, kDigits + 1);
    if (digits.size() <= kDigits || digits.back() != ')' ||
        digits.find_first_not_of("0123456789") != kDigits) {
      continue;
    }
    places.push_back(at);
    minimum = std::min(minimum, number_at(at));
  }
  for (const std::size_t at : places) {
    const std::string number = std::to_string(number_at(at) - minimum + 1);
    pdf.replace(at, kDigits, std::string(kDigits - number.size(), '0') + number);
  }
  return pdf;
}

}  // namespace

fs::path find_browser() {
  const char* named = std::getenv("CLAST_BROWSER");
  if (named && *named) {
    const fs::path browser = find_executable(named);
    if (!browser.empty()) return browser;
    throw InputError("CLAST_BROWSER names " + std::string(named) +
                     ", which is not an executable program; name Chromium or Chrome");
  }
  for (const char* name : {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable",
                           "chrome", "microsoft-edge"}) {
    const fs::path browser = find_executable(name);
    if (!browser.empty()) return browser;
  }
  throw InputError(
      "no browser was found to print the report; install Chromium (on Debian: apt install "
      "chromium), name a browser in CLAST_BROWSER, or print report.html yourself");
}

void print_page_to_pdf(const fs::path& page, const fs::path& pdf, const fs::path& browser,
                       double seconds) {
  const BrowserProfile profile;
  std::error_code code;
  fs::remove(pdf, code);
  std::vector<std::string> words = {
      browser.string(), "--headless", "--use-angle=swiftshader", "--disable-quic", "--no-first-run",
      "--disable-background-networking", "--disable-component-update", "--disable-sync",
      // Nothing but the page is read, and nothing asked of the network.
      "--host-resolver-rules=MAP * ~NOTFOUND", "--user-data-dir=" + profile.folder().string(),
      "--window-size=794,1123",       // A4, px
      "--virtual-time-budget=60000",  // charts are drawn after the page
      "--no-pdf-header-footer", "--print-to-pdf=" + fs::absolute(pdf).string()};
  // The browser refuses to run for root with its own protection.
  if (::geteuid() == 0) words.push_back("--no-sandbox");
  words.push_back("file://" + report_detail::format_link_target(fs::absolute(page).string()) +
                  "#print");
  const ProcessResult end = run_child_process(words, {{"HOME", profile.folder().string()}},
                                              profile.folder() / "log", seconds);
  if (end.timed_out) {
    throw InputError(browser.string() + " did not print the report within " +
                     format_significant(seconds, 3) + " s; print report.html yourself");
  }
  if (!is_pdf(pdf)) {
    fs::remove(pdf, code);
    throw InputError(browser.string() + " wrote no PDF (exit code " +
                     std::to_string(end.exit_code) + "); print report.html yourself");
  }
  write_text_file(pdf, without_print_marks(read_text_file(pdf)));
}

}  // namespace clast
