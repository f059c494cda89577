#include "app/option_flags.hpp"

#include <map>

#include "core/printable.hpp"

namespace clast {

namespace {

/// Names between backticks in messages of the libraries, and the flags that users type.
const std::map<std::string, std::string, std::less<>> kFlags = {
    {"accuracy", "--accuracy"},
    {"after", "--after"},
    {"align", "--align"},
    {"allow_unscaled", "--allow-unscaled"},
    {"any_size", "--any-size"},
    {"axis_error", "--axis-error"},
    {"bars", "--scale-bar"},
    {"before", "--before"},
    {"board", "--board"},
    {"bodies", "--bodies"},
    {"box", "--box"},
    {"cache", "--photo-cache"},
    {"campaign", "--campaign"},
    {"columns", "--columns"},
    {"convexity", "--convexity"},
    {"core", "--core"},
    {"degree", "--degree"},
    {"density", "--density"},
    {"detail", "--detail"},
    {"draw", "--draw"},
    {"edits", "--edits"},
    {"engine", "--to"},
    {"equal_spheres", "--equal-spheres"},
    {"error", "--error"},
    {"exponent", "--exponent"},
    {"find_ground = false", "--ground none"},
    {"format", "--format"},
    {"grid", "--grid"},
    {"group_by", "--by"},
    {"hull", "--hull"},
    {"inertia", "--inertia"},
    {"jobs", "--jobs"},
    {"joints", "--joints"},
    {"keep", "--keep"},
    {"labelled", "--labelled"},
    {"least", "--least"},
    {"least_volume", "--least-volume"},
    {"levels", "--levels"},
    {"like", "--like"},
    {"marker_side", "--marker-size"},
    {"mass", "--mass"},
    {"max_spheres", "--max-spheres"},
    {"merge_results", "clast simulate --merge PARTS -o ALL"},
    {"metres_per_unit", "--scale-length"},
    {"min_thickness", "--min-thickness"},
    {"model", "--model"},
    {"outliers", "--outliers"},
    {"part_vertices", "--part-vertices"},
    {"parts", "--parts"},
    {"picked", "--picked"},
    {"polygon", "--polygon"},
    {"pose", "--pose"},
    {"radius", "--radius"},
    {"radius_share", "--radius-share"},
    {"reference", "--reference"},
    {"replace", "--replace"},
    {"resolution", "--resolution"},
    {"resume", "--resume"},
    {"rounding", "--rounding"},
    {"roundness", "--roundness"},
    {"free_scale", "--scale"},
    {"scale_factor", "--scale-factor"},
    {"scale_points", "--scale-length"},
    {"schemes", "--scheme"},
    {"seconds", "--colmap-minutes"},
    {"segments", "--segments"},
    {"shape", "--shape"},
    {"shard", "--shard"},
    {"smallest_axis", "--smallest"},
    {"smallest_sphere", "--smallest-sphere"},
    {"split", "--split"},
    {"stations", "--stations"},
    {"to", "--to"},
    {"tolerance", "--tolerance"},
    {"units", "--units"},
    {"up", "--up"},
    {"vertices", "--vertices"},
    {"what", "--what"},
};

}  // namespace

std::string replace_keys_by_flags(std::string_view text) {
  std::string result;
  while (true) {
    const std::size_t begin = text.find('`');
    const std::size_t end = begin == text.npos ? begin : text.find('`', begin + 1);
    if (end == text.npos) return result.append(text);
    const std::string_view field = text.substr(begin + 1, end - begin - 1);
    const auto flag = kFlags.find(field);
    result.append(text.substr(0, begin)).append(flag == kFlags.end() ? field : flag->second);
    text.remove_prefix(end + 1);
  }
}

std::string format_for_terminal(std::string_view text) {
  return escape_nonprintable(replace_keys_by_flags(text));
}

}  // namespace clast
