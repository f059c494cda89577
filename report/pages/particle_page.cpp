#include "report/pages/particle_page.hpp"

#include <cmath>
#include <utility>

#include "classify/schemes.hpp"
#include "core/number_text.hpp"
#include "core/version.hpp"
#include "mesh/triangle_tree.hpp"
#include "particles/engines.hpp"
#include "report/blocks/particle_shape.hpp"
#include "report/blocks/turntable.hpp"
#include "report/html/assets.hpp"
#include "report/html/html_page.hpp"
#include "report/html/page_script.hpp"
#include "report/scene/three_library.hpp"

namespace clast::report_detail {
namespace {

constexpr int kPageSkinSegments = 3;
/// A particle has more triangles than the surface of a block, and they are smaller.
constexpr double kParticleCells = 32.0;

/// True surface of a block in its principal frame.
struct TrueSurface {
  TriangleMesh drawn;   ///< rounded
  TriangleMesh core;    ///< of which the surface is an offset
  double radius = 0.0;  ///< the offset, m
};

/// Clumps replace the rounded body. Convex shapes replace the simplified scan, if there is one.
TrueSurface true_surface(const Block& block, ParticleShape shape) {
  const Pose body_from_source = block.source_from_body().inverse();
  if (shape != ParticleShape::kSpheres && !block.from_core) {
    const TriangleMesh surface = transformed(block.surface, body_from_source);
    return {surface, surface, 0.0};
  }
  return {transformed(rounded_surface_mesh(block.body, kPageSkinSegments), body_from_source),
          transformed(core_mesh(block.body), body_from_source), block.body.radius};
}

TurntableChoices choices_of(const Particle& particle) {
  switch (particle.shape) {
    case ParticleShape::kSpheres:
      return {"spheres", "block", "spheres in the block", "distance of the spheres from the block"};
    case ParticleShape::kParts:
      return {"convex parts", "block", "parts in the block",
              "distance of the parts from the block"};
    case ParticleShape::kPolyhedron:
      break;
  }
  return {"hull", "block", "hull in the block", "distance of the hull from the block"};
}

std::string particle_view_json(const Block& block, const Particle& particle) {
  TrueSurface truth = true_surface(block, particle.shape);
  ParticleSurface shape = make_particle_surface(particle);
  const TriangleTree tree(truth.core);
  const Pose body_from_source = block.source_from_body().inverse();
  TurntableContents contents = {
      .name = particle.name,
      .shape = std::move(shape.mesh),
      .smooth = particle.shape == ParticleShape::kSpheres,
      .surface = std::move(truth.drawn),
      .box = {body_from_source * block.box.centre,
              body_from_source.rotation.toRotationMatrix() * block.box.axes, block.box.lengths},
      .distance =
          [&, hint = std::uint32_t{0}](const Vec3& point) mutable {
            const TriangleTree::SignedClosest found = tree.signed_closest_point(point, hint);
            hint = found.triangle;
            return found.distance - truth.radius;
          },
      .reach = particle.errors.surface * particle.lengths[0]};
  if (particle.shape != ParticleShape::kPolyhedron) {
    contents.components = std::move(shape.components);
  }
  if (contents.reach == 0.0) contents.distance = {};
  return format_turntable_json(contents, {.deviation_cells = kParticleCells});
}

std::string class_name(const Vec3& lengths) {
  return sneed_folk_class({lengths[0], lengths[1], lengths[2]});
}

std::string format_change(double from, double to) {
  return format_fixed(100.0 * (to / from - 1.0), 2) + " %";
}

/// Table of class, sides, volume and moments of a block beside those of the exported shape.
std::string comparison_table(const Particle& particle) {
  HtmlTable table({"", "block", "exported", "difference"}, 1);
  const auto number = [](double value) { return format_significant_digits(value, 4); };
  table.row({"class of Sneed and Folk", class_name(particle.lengths),
             class_name(particle.shape_lengths), ""});
  const char* const sides[] = {"L, m", "I, m", "S, m"};
  for (int k = 0; k < 3; ++k) {
    table.row({sides[k], number(particle.lengths[k]), number(particle.shape_lengths[k]),
               format_change(particle.lengths[k], particle.shape_lengths[k])});
  }
  table.row({"volume, m3", number(particle.volume), number(particle.shape_mass.volume),
             format_change(particle.volume, particle.shape_mass.volume)});
  const char* const moments[] = {"J1, kg m2", "J2, kg m2", "J3, kg m2"};
  const Mat3 inertia = particle.mass / particle.shape_mass.mass * particle.shape_mass.inertia;
  for (int k = 0; k < 3; ++k) {
    table.row({moments[k], number(particle.moments[k]), number(inertia(k, k)),
               format_change(particle.moments[k], inertia(k, k))});
  }
  return table.html();
}

std::string particle_facts(const Particle& particle) {
  const double length = particle.lengths[0];
  std::string html = "<dl class=\"facts\">" +
                     format_fact("exported as", format_component_count(
                                                    particle_shape_name(particle.shape),
                                                    particle.balls.size(), particle.parts.size()));
  html += format_fact("error of the volume", format_percent(particle.errors.volume, 2));
  html += format_fact("error of the inertia tensor", format_percent(particle.errors.inertia, 2));
  html += format_fact("largest distance of the surfaces",
                      format_percent(particle.errors.surface, 2) + " of L, " +
                          format_significant_digits(particle.errors.surface * length, 2) + " m");
  if (!particle.balls.empty()) {
    const double smallest = particle.balls.back().radius;
    html += format_fact("smallest sphere", format_significant_digits(smallest, 3) + " m, " +
                                               format_percent(smallest / length, 2) + " of L");
  } else {
    html += format_fact("volume added by convexity", format_percent(particle.added_volume, 2));
  }
  html += format_fact("mass, kg", format_significant_digits(particle.mass, 4));
  html += format_fact("density, kg/m3", format_significant_digits(particle.density, 4));
  return html +
         format_fact("density if the engine computes the mass, kg/m3",
                     format_significant_digits(particle.mass / particle.shape_mass.volume, 5)) +
         "</dl>\n";
}

std::string particle_section(const Block& block, const Particle& particle, std::size_t index) {
  const std::string id = "particle-" + std::to_string(index);
  std::string html = particle_facts(particle);
  if (three_is_installed()) {
    html += format_turntable_view(id, choices_of(particle)) +
            format_packed_element(id, particle_view_json(block, particle));
  }
  return format_section(particle.name, html + comparison_table(particle));
}

}  // namespace

std::string format_component_count(const std::string& shape, std::size_t spheres,
                                   std::size_t parts) {
  if (shape == particle_shape_name(ParticleShape::kPolyhedron)) return "hull";
  return spheres > 0 ? format_count(spheres, "sphere") : format_count(parts, "convex part");
}

std::string make_particle_frame(const std::string& title, const std::string& body) {
  const std::string style = std::string(assets::scans_css) + std::string(assets::turntable_css);
  return format_page(title, body + "<footer>clast " + escape_html(version()) + "</footer>\n",
                     {.style = style});
}

std::string make_particle_page(const Block& block, const std::vector<Particle>& particles,
                               const ParticleExportOptions& options, const std::string& key) {
  const std::string title =
      "Block " + block.id + " for " + find_particle_engine(options.engine).program;
  std::string body = "<h1>" + escape_html(title) + "</h1>\n<p class=\"lead\">from " +
                     escape_html(block.source.file) + "</p>\n";
  body += format_paragraph(
      "Mass, centre of mass and inertia tensor in the files are those of the block. The errors "
      "are those of the exported shape. In 3-D, drag to rotate, use the wheel to zoom, drag with "
      "the right button to move.");
  for (std::size_t i = 0; i < particles.size(); ++i) {
    body += particle_section(block, particles[i], i);
  }
  HtmlTable source({"what", "value"}, 2);
  source.row({"options", format_particle_options(options)});
  source.row({"digest of block, options and program", key});
  source.row({"SHA-256 of the scan", block.source.sha256});
  body += turntable_script() + format_section("Source", source.html());
  return make_particle_frame(title, body);
}

}  // namespace clast::report_detail
