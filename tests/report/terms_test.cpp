// Words that a page explains, and its contents.
#include "report/html/terms.hpp"

#include <gtest/gtest.h>

#include "report/html/contents_list.hpp"
#include "report/html/html_page.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/refusal.hpp"

namespace clast {
namespace {

using namespace report_detail;

TEST(Terms, AreMarkedOnceInASectionAndExplainedAtTheEnd) {
  const std::string html = link_glossary_terms(
      format_section("One", format_paragraph("Runout, and runout again.")) +
      format_section("Two", "<table><tr><th>runout mean, m</th><td>runout</td></tr></table>"));
  const std::string mark = "aria-describedby=\"term-runout\"";
  EXPECT_EQ(count_of(html, mark), 2u) << html;
  EXPECT_EQ(count_of(html, "id=\"term-runout\""), 1u);
  EXPECT_TRUE(contains(html, "tabindex=\"0\""));
  EXPECT_TRUE(contains(html, "<td>runout</td>"));
  EXPECT_EQ(unbalanced(html), "");
}

TEST(Terms, AreWholeWordsOutsideScriptsAndTitles) {
  const std::string plain =
      "<h2>Runout</h2><p>runouts</p><script>var runout='<p>runout</p>';"
      "</script><p><code>runout</code></p>";
  EXPECT_EQ(link_glossary_terms(plain), plain);
  const std::string html = link_glossary_terms("<p>A 95 % interval, Cliff&#39;s delta.</p>");
  EXPECT_TRUE(contains(html, ">95 % interval</span>"));
  EXPECT_TRUE(contains(html, ">Cliff&#39;s delta</span>"));
}

TEST(Contents, LinkToEverySection) {
  const std::string html =
      make_contents_list("<header id=\"answer\"></header>" + format_section("Along the slope", "") +
                         format_section("What was run", "<p>x</p>"));
  EXPECT_TRUE(contains(html, "<a href=\"#answer\">Answer</a>"));
  EXPECT_TRUE(contains(html, "<a href=\"#along-the-slope\">Along the slope</a>"));
  EXPECT_TRUE(contains(html, "<a href=\"#what-was-run\">What was run</a>"));
  EXPECT_EQ(unbalanced(html), "");
}

}  // namespace
}  // namespace clast
