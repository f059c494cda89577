#include "report/particle_report.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.hpp"
#include "core/files/file_kind.hpp"
#include "core/files/output_file.hpp"
#include "core/files/text_file.hpp"
#include "core/number_text.hpp"
#include "core/utf8.hpp"
#include "report/blocks/block_pictures.hpp"
#include "report/html/html_page.hpp"
#include "report/pages/particle_page.hpp"

namespace clast {

using namespace report_detail;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kIndexPage = "particles.html";

bool page_contains(const fs::path& page, const std::string& text) {
  std::error_code code;
  return fs::is_regular_file(page, code) &&
         read_text_file(page).find(escape_html(text)) != std::string::npos;
}

std::string percent_cell(const Json& row, const char* column) {
  return format_fixed(100.0 * row.at(column).get<double>(), 2);
}

std::string length_cell(const Json& row, const char* column) {
  return format_significant_digits(row.at(column).get<double>(), 3);
}

/// Range and median of a column: "12 to 80, median 31".
std::string spread_text(std::vector<double> values, int decimals) {
  std::sort(values.begin(), values.end());
  return format_fixed(values.front(), decimals) + " to " + format_fixed(values.back(), decimals) +
         ", median " + format_fixed(values[values.size() / 2], decimals);
}

/// Table of all particles and the ranges of their figures.
class ParticleTable {
 public:
  ParticleTable(std::span<const Block* const> blocks, ParticleShape shape)
      : has_spheres_(shape == ParticleShape::kSpheres), table_(make_table(has_spheres_)) {
    for (const Block* block : blocks) blocks_[block->id] = block;
    table_.show_as_cards();
  }

  /// @param link  to the page of the block; may be empty
  void add(const Json& row, const std::string& link) {
    const std::string id = row.at("block");
    const std::string name = escape_html(row.at("name").get<std::string>());
    const auto block = blocks_.find(id);
    const auto count = row.at(has_spheres_ ? "spheres" : "parts").get<std::size_t>();
    const double length = row.at("L_m").get<double>();
    table_.add_html_row(
        {link.empty() ? name : "<a href=\"" + link + "\">" + name + "</a>",
         block == blocks_.end() ? "" : render_thumbnail(block->second->surface, id),
         escape_html(row.at("class").get<std::string>()),
         escape_html(row.at("shape_class").get<std::string>()), length_cell(row, "L_m"),
         length_cell(row, "I_m"), length_cell(row, "S_m"), std::to_string(count),
         percent_cell(row, "error_volume"), percent_cell(row, "error_inertia"),
         percent_cell(row, "error_surface"),
         has_spheres_ ? format_fixed(100.0 * row.at("smallest_radius_m").get<double>() / length, 2)
                      : percent_cell(row, "added_volume"),
         format_significant_digits(row.at("mass_kg").get<double>(), 4)});
    counts_.push_back(static_cast<double>(count));
    for (std::size_t k = 0; k < kErrors.size(); ++k) {
      errors_[k].push_back(100.0 * row.at(kErrors[k].first).get<double>());
    }
  }

  std::string html() const {
    if (counts_.empty()) return {};
    std::string facts = "<dl class=\"facts\">" +
                        format_fact(has_spheres_ ? "spheres of a block" : "parts of a block",
                                    spread_text(counts_, 0));
    for (std::size_t k = 0; k < kErrors.size(); ++k) {
      facts += format_fact(kErrors[k].second, spread_text(errors_[k], 2));
    }
    return facts + "</dl>\n" +
           format_section("Blocks",
                          format_paragraph("Click the heading of a column to sort by it, and a "
                                           "name to see the block in 3-D with the exported shape. "
                                           "L, I, S are the sides of the smallest box.") +
                              table_.html());
  }

 private:
  static HtmlTable make_table(bool has_spheres) {
    return {{"name", "picture", "class", "class as exported", "L m", "I m", "S m",
             has_spheres ? "spheres" : "parts", "error of volume, %", "error of inertia, %",
             "error of surface, % of L",
             has_spheres ? "smallest radius, % of L" : "added volume, %", "mass kg"},
            4};
  }

  static constexpr std::array<std::pair<const char*, const char*>, 3> kErrors = {
      {{"error_volume", "error of the volume, %"},
       {"error_inertia", "error of the inertia tensor, %"},
       {"error_surface", "largest distance of the surfaces, % of L"}}};

  std::map<std::string, const Block*> blocks_;
  bool has_spheres_;
  HtmlTable table_;
  std::vector<double> counts_;
  std::array<std::vector<double>, 3> errors_;
};

Json read_manifest(const fs::path& file) {
  const Json manifest = Json::parse(read_text_file(file), nullptr, false);
  if (manifest.is_discarded()) throw InputError(file.string() + ": is not JSON");
  return manifest;
}

}  // namespace

ParticleReport::ParticleReport(fs::path folder, const ParticleExportOptions& options)
    : folder_(std::move(folder)), options_(options) {
  const fs::path index = folder_ / kIndexPage;
  std::error_code code;
  if (fs::exists(index, code) && !options_.replace &&
      !page_contains(index, format_particle_options(options_))) {
    throw InputError(index.string() +
                     ": is the page of an export with other options; name another folder or use "
                     "`replace`");
  }
  check_output_target(index, {.kind = kPageKind});
}

fs::path ParticleReport::page_of(const std::string& id) const {
  return folder_ / "particles" / (particle_name(id) + ".html");
}

void ParticleReport::write_page(const fs::path& path, const std::string& page) const {
  const bool is_own = page_contains(path, format_particle_options(options_));
  write_output(path, page, {.kind = kPageKind, .replace = options_.replace || is_own});
}

bool ParticleReport::is_finished(const Block& block, const std::string& key) const {
  return page_contains(page_of(block.id), key);
}

void ParticleReport::on_particles_made(const Block& block, const std::vector<Particle>& particles,
                                       const std::string& key) {
  write_page(page_of(block.id), make_particle_page(block, particles, options_, key));
}

fs::path ParticleReport::finish(const fs::path& export_folder, std::span<const Block* const> blocks,
                                const std::vector<std::string>& failures) const {
  ParticleTable table(blocks, options_.chosen_shape());
  const Json manifest = read_manifest(export_folder / kParticleManifest);
  for (const Json& entry : manifest.at("blocks")) {
    const fs::path page = page_of(entry.at("block"));
    std::error_code code;
    std::string link;
    if (fs::exists(page, code)) {
      link = format_link_target("particles/" + page.filename().string());
    }
    for (const Json& row : entry.at("particles")) table.add(row, link);
  }
  const std::string title = "Particles for " + find_particle_engine(options_.engine).program;
  std::string body = "<h1>" + escape_html(title) + "</h1>\n<p class=\"lead\">" +
                     format_count(manifest.at("blocks").size(), "block");
  if (!failures.empty()) body += ", " + format_count(failures.size(), "block") + " left out";
  body += "</p>\n" + table.html();
  if (!failures.empty()) {
    HtmlTable reasons({"reason"}, 1);
    for (const std::string& failure : failures) reasons.row({to_utf8(failure)});
    body += format_section("Blocks that were left out", reasons.html());
  }
  HtmlTable source({"what", "value"}, 2);
  source.row({"options", format_particle_options(options_)});
  body += format_section("Source", source.html());
  const fs::path index = folder_ / kIndexPage;
  write_page(index, make_particle_frame(title, body));
  return index;
}

}  // namespace clast
