// Printing by a browser that fails in every way it can; a real one prints in report_page_test.
#include "report/page_pdf.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "core/files/text_file.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

namespace fs = std::filesystem;

class PagePdf : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(folder / "tmp");
    write_text_file(folder / "page.html", "<p>x</p>");
    ::setenv("TMPDIR", (folder / "tmp").c_str(), 1);
  }
  void TearDown() override {
    ::unsetenv("TMPDIR");
    ::unsetenv("CLAST_BROWSER");
    EXPECT_TRUE(fs::is_empty(folder / "tmp")) << "the profile is still there";
  }
  /// A browser that is a script.
  fs::path browser(const std::string& script) {
    write_text_file(folder / "browser", "#!/bin/sh\n" + script);
    fs::permissions(folder / "browser", fs::perms::owner_all);
    return folder / "browser";
  }
  std::string refused(const std::string& script, double seconds = 20.0) {
    const fs::path program = browser(script);
    return refusal(
        [&] { print_page_to_pdf(folder / "page.html", folder / "a.pdf", program, seconds); });
  }
  ScratchFolder folder;
};

TEST_F(PagePdf, IsWhatTheBrowserWrote) {
  const fs::path program = browser(
      "for word in \"$@\"; do case $word in --print-to-pdf=*) printf '%%PDF-1.4' > "
      "\"${word#--print-to-pdf=}\";; esac; done\n");
  write_text_file(folder / "a.pdf", "old");
  print_page_to_pdf(folder / "page.html", folder / "a.pdf", program);
  EXPECT_EQ(read_text_file(folder / "a.pdf"), "%PDF-1.4");
}

// Chromium writes the time, and numbers elements of the page from anywhere.
TEST_F(PagePdf, EqualPagesGiveEqualFiles) {
  const auto printed = [&](const std::string& time, int first) {
    const auto node = [&](int i) {
      const std::string number = std::to_string(first + i);
      return "/ID (node" + std::string(8 - number.size(), '0') + number + ")>>";
    };
    const std::string content = "%PDF-1.4 /CreationDate (D:" + time + "+00)\n/ModDate (D:" + time +
                                "+00)\n" + node(1) + node(0) + node(70) + "(node12)(node1234567x)";
    const fs::path program =
        browser("for word in \"$@\"; do case $word in --print-to-pdf=*) printf %s '" + content +
                "' > " + "\"${word#--print-to-pdf=}\";; esac; done\n");
    print_page_to_pdf(folder / "page.html", folder / "a.pdf", program);
    return read_text_file(folder / "a.pdf");
  };
  const std::string one = printed("20261127110656", 849);
  EXPECT_EQ(one, printed("20270101000001", 99999));
  EXPECT_TRUE(contains(one, "(node00000002)>>/ID (node00000001)>>/ID (node00000071)>>(node12)"));
}

TEST_F(PagePdf, BrowsersThatHangFailOrWriteSomethingElseAreToldOf) {
  EXPECT_TRUE(contains(refused("sleep 60\n", 0.3), "did not print the report within 0.3 s"));
  EXPECT_TRUE(contains(refused("exit 3\n"), "wrote no PDF (exit code 3)"));
  EXPECT_TRUE(contains(refused("for word in \"$@\"; do case $word in --print-to-pdf=*) echo no > "
                               "\"${word#--print-to-pdf=}\";; esac; done\n"),
                       "wrote no PDF (exit code 0)"));
  EXPECT_FALSE(fs::exists(folder / "a.pdf"));
}

TEST_F(PagePdf, WithoutABrowserItIsSaidWhatToInstall) {
  ::setenv("CLAST_BROWSER", (folder / "none").c_str(), 1);
  EXPECT_TRUE(contains(refusal([] { find_browser(); }), "CLAST_BROWSER names "));
  ::unsetenv("CLAST_BROWSER");
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder / "tmp").c_str(), 1);
  EXPECT_TRUE(contains(refusal([] { find_browser(); }), "apt install chromium"));
  ::setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace clast
