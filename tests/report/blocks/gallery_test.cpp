// The gallery of a library as text; tests/app/gallery_page_test.cpp uses it in a browser.
#include <gtest/gtest.h>

#include "core/files/text_file.hpp"
#include "report/blocks/gallery.hpp"
#include "tests/library/block_samples.hpp"
#include "tests/support/markup.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scratch_folder.hpp"

namespace clast {
namespace {

TEST(Gallery, HasACardWithItsNumbersForEveryBlock) {
  const ScratchFolder folder;
  const Block flat = filled_block("flat <1>");
  Block longer = filled_block("long");
  longer.box.lengths = {3.0, 1.0, 0.9};
  Block unscaled = filled_block("model");
  unscaled.source.unscaled = true;
  const std::vector<const Block*> blocks = {&flat, &longer, &unscaled};
  const std::filesystem::path file = write_gallery(blocks, "Blocks of a & b", folder.path());
  EXPECT_EQ(file, folder / "gallery.html");
  const std::string html = read_text_file(file);
  EXPECT_EQ(unbalanced(html), "");
  EXPECT_EQ(count_of(html, " src=\""), count_of(html, " src=\"data:image/png;base64,"));
  EXPECT_EQ(count_of(html, "http"), 0u);
  EXPECT_EQ(count_of(html, "<article class=\"card\""), 3u);
  EXPECT_EQ(count_of(html, "<img "), 3u);
  EXPECT_EQ(count_of(html, "id=\"block-"), 3u) << "each with its data";
  EXPECT_EQ(count_of(html, "flat &lt;1&gt;</h3>"), 1u);
  EXPECT_EQ(count_of(html, "scans/long.stl</div>"), 1u) << "file names in full";
  EXPECT_EQ(count_of(html, "data-shape=\"elongated\""), 3u);
  EXPECT_EQ(count_of(html, "<option value=\"shape:elongated\">elongated (3)</option>"), 1u);
  EXPECT_EQ(count_of(html, "<option value=\"zingg:rod\">rod (1)</option>"), 1u);
  EXPECT_EQ(count_of(html, "none: unscaled"), 1u) << "no mass is claimed for a model";
  EXPECT_EQ(count_of(html, "data-mass=\"\""), 1u);
}

TEST(Gallery, ItsFolderIsKnown) {
  const OutputFolderKind kind = gallery_folder_kind();
  EXPECT_TRUE(kind.is_own_file("gallery.html"));
  EXPECT_FALSE(kind.is_own_file("report.html"));
  const ScratchFolder folder;
  const Block block = filled_block("one");
  const Block* const one = &block;
  const auto file = write_gallery({&one, 1}, "Blocks", folder.path());
  EXPECT_TRUE(contains(read_text_file(file), kind.marker_text));
}

}  // namespace
}  // namespace clast
