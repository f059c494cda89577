#include "reconstruct/repair/repair_report.hpp"

#include <algorithm>
#include <cmath>

#include "core/number_text.hpp"
#include "reconstruct/repair/holes.hpp"

namespace clast {

namespace {

/// A share of the surface below which it isn't worth a word.
constexpr double kWorthNoting = 1e-3;

std::string in_percent(double fraction) { return format_significant(100.0 * fraction, 3) + " %"; }

std::string change(double relative) {
  return std::abs(relative) < 1e-5 ? "less than 0.001 %" : in_percent(relative);
}

class Sentences {
 public:
  explicit Sentences(const RepairReport& report) : report_(report) {}

  std::vector<std::string> all() const {
    std::vector<std::string> notes;
    for (const Defect& defect : report_.defects) {
      if (defect.kind == DefectKind::kHole) {
        for (std::string& note : of_holes()) notes.push_back(std::move(note));
      } else if (defect.kind == DefectKind::kDuplicateShell) {
        continue;  // one by one below
      } else {
        notes.push_back(of(defect));
      }
    }
    for (const DuplicateSurface& copy : report_.duplicates) notes.push_back(of(copy));
    if (report_.relative_wrap_excess) {
      notes.push_back(
          "the self-intersections of the surface could not be removed, so it was wrapped anew: "
          "hollows narrower "
          "than a sixtieth of its diagonal are bridged, and the " +
          in_percent(*report_.relative_wrap_excess) +
          " of volume that this added is removed by scaling");
    }
    return notes;
  }

 private:
  static std::string metres(double length) { return format_significant(length, 3) + " m"; }

  static std::string near(const Defect& defect) {
    return defect.position ? " near " + format_point(*defect.position) : "";
  }

  static std::string worth_of(const Defect& defect) {
    if (defect.area_fraction < kWorthNoting) return "";
    return ", " + in_percent(defect.area_fraction) + " of the surface";
  }

  static std::string of(const DuplicateSurface& copy) {
    std::string text = copy.closed
                           ? "a second copy of the block's whole surface, "
                           : "a second copy of " + in_percent(std::min(1.0, copy.area_fraction)) +
                                 " of the block's surface, ";
    text += format_significant(100.0 * copy.scale, 4) + " % of its size, " + metres(copy.distance) +
            " away from it and on average " + metres(std::abs(copy.offset)) +
            (copy.offset < 0.0 ? " inside" : " outside") +
            ", was removed: it is not a bubble but the same rock, scanned or stored twice and not "
            "registered. ";
    switch (copy.retention_reason) {
      case RetentionReason::kClosed:
        text += "The kept copy is closed";
        break;
      case RetentionReason::kMoreComplete:
        text += "The kept copy covers the whole block";
        break;
      case RetentionReason::kFiner:
        text += "The kept copy has more triangles";
        break;
      case RetentionReason::kLarger:
        text += "Neither copy is more complete or finer, so the larger one was kept";
        break;
    }
    const double volume = copy.retained_volume, change = copy.volume_change;
    text += volume > 0.0 ? "; its volume is " + format_significant(volume, 4) +
                               " m3, with the other copy it would be " +
                               format_significant(volume + change, 4) + " m3"
                         : "; with the other copy the volume would be " +
                               format_significant(std::abs(change), 3) + " m3 " +
                               (change < 0.0 ? "smaller" : "larger");
    return text + ". Register the scans again, or delete one";
  }

  std::string of(const Defect& d) const {
    switch (d.kind) {
      case DefectKind::kNearVertices:
        return format_count(d.count, "vertex", "vertices") + " joined to a neighbour closer than " +
               format_significant(d.size, 4) + " m";
      case DefectKind::kDegenerate:
        return format_count(d.count, "triangle", "triangles") +
               " without area or stored twice, removed";
      case DefectKind::kFoldedPair:
        return format_count(d.count, "triangle", "triangles") +
               " back to back with another, removed" + worth_of(d);
      case DefectKind::kFin:
        return format_count(d.count, "triangle that stands", "triangles that stand") +
               " on the surface or duplicate it, removed" + worth_of(d) + ", the first" + near(d);
      case DefectKind::kNonManifoldEdge:
        return format_count(d.count, "edge", "edges") +
               " shared by more than two triangles separated, the first" + near(d);
      case DefectKind::kInconsistentOrientation:
        return format_count(d.count, "triangle", "triangles") + " turned to agree with neighbours";
      case DefectKind::kNonManifoldVertex:
        return format_count(d.count, "vertex", "vertices") +
               " where the surface touches itself split";
      case DefectKind::kDuplicateSheet:
        return format_count(d.count, "sheet that lies", "sheets that lie") +
               " on the block removed (a part scanned twice)" + worth_of(d) + ", the largest" +
               near(d);
      case DefectKind::kIsland:
        return format_count(d.count, "loose scrap", "loose scraps") + " dropped" + worth_of(d);
      case DefectKind::kInnerShell:
        return format_count(d.count, "inner shell", "inner shells") + " (bubbles) of " +
               format_significant(report_.inner_shell_volume, 4) + " m3 in all " +
               (report_.inner_shells_retained ? "kept as cavities" : "dropped");
      case DefectKind::kSpike:
        return format_count(d.count, "spike", "spikes") + " of up to " + metres(d.size) +
               " moved back to the surface, the highest" + near(d);
      case DefectKind::kSelfIntersection:
        return format_count(d.count, "pair", "pairs") +
               " of triangles that touched or passed through each other separated or replaced" +
               near(d) + ", which changed the volume by " + change(report_.crossing_volume_change);
      case DefectKind::kInwardOrientation:
        return "the surface faced inwards and was reversed";
      case DefectKind::kTunnel:
        return format_count(d.count, "tunnel (a hole through the block) was kept",
                            "tunnels (holes through the block) were kept") +
               "; if the rock has no tunnel, close it in the scan";
      case DefectKind::kHole:
      case DefectKind::kDuplicateShell:
        break;
    }
    return "";
  }

  /// Tiny ones together, the others together, and each large one by itself.
  std::vector<std::string> of_holes() const {
    std::vector<std::string> notes;
    std::size_t fans = 0, fan_edges = 0, fillings = 0, largest_fan = 0;
    const FilledHole* largest = nullptr;
    for (const FilledHole& hole : report_.holes) {
      if (hole.is_fan) {
        ++fans;
        largest_fan = std::max(largest_fan, hole.border_edges);
        fan_edges += hole.border_edges;
      } else {
        ++fillings;
        if (largest == nullptr) largest = &hole;
      }
    }
    if (fans > 0) {
      notes.push_back(
          format_count(fans, "hole", "holes") + " with " +
          format_count(fan_edges, "border edge", "border edges") + " in all closed by " +
          (largest_fan <= reconstruct_detail::kMaxFanEdges ? "a fan"
                                                           : "triangles between their corners"));
    }
    if (largest != nullptr) {
      notes.push_back(format_count(fillings, "hole", "holes") + " filled; the largest has " +
                      std::to_string(largest->border_edges) + " border edges, is " +
                      metres(largest->perimeter) + " in perimeter and reaches " +
                      metres(largest->radius) + " from its centre at " +
                      format_point(largest->centre));
    }
    if (report_.filled_fraction >= kWorthNoting) {
      std::string open;
      if (report_.volume_below + report_.volume_above > 0.0) {
        open = "; the volume may be up to " + format_significant(report_.volume_below, 2) +
               " m3 smaller or " + format_significant(report_.volume_above, 2) + " m3 larger";
      }
      notes.push_back(
          format_significant(100.0 * report_.filled_fraction, 2) + " %" +
          " of the surface was filled without data: no scan shows the surface at the holes" + open);
    }
    for (const FilledHole& hole : report_.holes) {
      if (hole.area_fraction <= kLargeHoleFraction) continue;
      notes.push_back(
          "the filling at " + format_point(hole.centre) + " is " + in_percent(hole.area_fraction) +
          " of the surface; it is an assumption on which volume and axes depend: scan that side, "
          "or check the volume by weighing (`mass` with `density`)");
    }
    return notes;
  }

  const RepairReport& report_;
};

}  // namespace

const Defect* RepairReport::find_defect(DefectKind kind) const {
  const auto found = std::find_if(defects.begin(), defects.end(),
                                  [&](const Defect& defect) { return defect.kind == kind; });
  return found == defects.end() ? nullptr : &*found;
}

RepairReport merged(RepairReport first, RepairReport second) {
  if (first.as_read.triangles > 0) second.as_read = first.as_read;
  for (const Defect& defect : first.defects) {
    const auto same = std::find_if(second.defects.begin(), second.defects.end(),
                                   [&](const Defect& other) { return other.kind == defect.kind; });
    if (same == second.defects.end()) {
      second.defects.push_back(defect);
      continue;
    }
    same->count += defect.count;
    same->area_fraction += defect.area_fraction;
    if (defect.size >= same->size && defect.position) same->position = defect.position;
    same->size = std::max(same->size, defect.size);
  }
  std::stable_sort(second.defects.begin(), second.defects.end(),
                   [](const Defect& a, const Defect& b) { return a.kind < b.kind; });
  for (const FilledHole& hole : first.holes) {
    second.holes.push_back(hole);
    second.filled_fraction += hole.area_fraction;
  }
  second.volume_below += first.volume_below;
  second.volume_above += first.volume_above;
  std::stable_sort(second.holes.begin(), second.holes.end(),
                   [](const FilledHole& a, const FilledHole& b) { return a.area > b.area; });
  second.duplicates.insert(second.duplicates.begin(), first.duplicates.begin(),
                           first.duplicates.end());
  second.inner_shells += first.inner_shells;
  second.inner_shell_volume += first.inner_shell_volume;
  return second;
}

const char* name_of(DefectKind kind) {
  switch (kind) {
    case DefectKind::kNearVertices:
      return "vertices stored more than once, joined";
    case DefectKind::kDegenerate:
      return "triangles without area or stored twice, removed";
    case DefectKind::kFoldedPair:
      return "triangles back to back with another, removed";
    case DefectKind::kFin:
      return "triangles attached to the surface or duplicating it, removed";
    case DefectKind::kNonManifoldEdge:
      return "edges of more than two triangles, separated";
    case DefectKind::kInconsistentOrientation:
      return "triangles that face the other way, reversed";
    case DefectKind::kNonManifoldVertex:
      return "vertices where the surface touches itself, split";
    case DefectKind::kDuplicateSheet:
      return "sheets that lie on the block, removed";
    case DefectKind::kDuplicateShell:
      return "second copies of the whole surface, removed";
    case DefectKind::kIsland:
      return "loose scraps, removed";
    case DefectKind::kInnerShell:
      return "closed shells inside (bubbles)";
    case DefectKind::kSpike:
      return "spikes, moved back to the surface";
    case DefectKind::kHole:
      return "holes, filled";
    case DefectKind::kSelfIntersection:
      return "pairs of intersecting triangles, replaced";
    case DefectKind::kInwardOrientation:
      return "surface that faced inwards, reversed";
    case DefectKind::kTunnel:
      return "tunnels through the block, left open";
  }
  return "";
}

std::vector<std::string> describe_repairs(const RepairReport& report) {
  return Sentences(report).all();
}

}  // namespace clast
