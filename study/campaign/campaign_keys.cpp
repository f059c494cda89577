#include "study/campaign/campaign_keys.hpp"

#include "library/series_steps.hpp"
#include "library/variation_ranges.hpp"
#include "study/campaign/campaign_ranges.hpp"
#include "study/campaign/campaign_reading.hpp"
#include "study/campaign/ground_fields.hpp"
#include "study/campaign/key_forms.hpp"

namespace clast {

using namespace study_detail;

namespace {

using Repeat = KeyTable::Repeat;

/// Of a ground zone, or of two blocks, which have no soil and no uncertain parameters.
/// @param complete  what every zone must have is required
std::vector<TableKey> ground_keys(bool between_blocks, bool complete = true) {
  std::vector<TableKey> keys;
  for (const GroundField& field : ground_fields()) {
    if (between_blocks && field.of_soil) continue;
    const std::string trust = field.of_soil ? "experimental, unmeasured: " : "";
    keys.push_back({field.name, field.unit, trust + field.words + ": " + field.meaning,
                    between_blocks ? Forms{number(field.range)} : uncertain(field.range),
                    complete && field.required});
  }
  return keys;
}

ValueForm block_class() {
  return table({{"scheme", "", "scheme of shape classes", {words(kSelectingSchemes)}, true},
                {"class", "", "a class of the scheme", {text()}, true}});
}

Forms selection() { return {text(), list(text(), 1), block_class()}; }

/// A value or a list of such.
Forms one_or_more(const ValueForm& form) { return {form, list(form, 1)}; }

/// What bodies are made of the blocks: key for key what `SeriesRequest` asks for.
std::vector<TableKey> vary_keys() {
  const ValueForm ratio = number(kVariedRatio);
  return {{"to", "", "stretch to these ratios, [I/L, S/L] each", {list(list(ratio, 2, 2), 1)}},
          {"grid",
           "",
           "stretch to forms all over a diagram",
           {table({{"diagram", "", "of form", {words(form_grid_names())}, true},
                   {"steps", "", "along each side", {count(1, kMostGridSteps)}, true},
                   {"least", "", "smallest S/L, in zingg I/L and S/I", {number(kLeastRatio)}}})}},
          {"like", "", "stretch to the ratios of these blocks of the library", texts()},
          {"convexity", "", "fill hollows until the volume is this share of the hull's",
           one_or_more(number(kVariedConvexity))},
          {"rounding", "", "radius of edges and corners as a share of S",
           one_or_more(number(kVariedRadiusShare))},
          {"roundness", "", "round edges and corners until Wadell's roundness is this",
           one_or_more(number(kVariedRoundness))},
          {"roundness_edge",
           "",
           "edges that it is measured on, over the diameter of the ball of equal volume",
           {number(kRoundnessEdge)}},
          {"vertices", "", "simplify the core to so many",
           one_or_more(count(kFewestVaried, kMostVaried))},
          {"detail", "", "factor on what lies off the coarse form: 0 smooths, 2 roughens",
           one_or_more(number(kDetailGain))},
          {"degree",
           "",
           "spherical harmonics up to this degree are the coarse form",
           {count(kLowestDegree, kHighestDegree)}},
          {"reference", "", "simple bodies with the block's I/L and S/L",
           one_or_more(words(reference_form_names()))},
          {"exponent", "", "of the superellipsoid", {number(kSuperellipsoidExponent)}},
          {"inertia", "", "bodies with the block's mass and principal moments",
           one_or_more(words(inertia_form_names()))},
          {"population",
           "",
           "bodies with sizes and forms drawn as the blocks, or a table, have them",
           {table({{"count", "", "how many", {count(1, kMostSeriesBodies)}, true},
                   {"seed", "", "of the draw", {seed()}},
                   {"table", "", "of measured blocks, with columns L, I and S", {text()}},
                   {"units", "", "length unit of the table", {text()}},
                   {"prefix", "", "ids are this and a number", {text()}}})}},
          {"keep",
           "",
           "what bodies have in common with their block",
           {words({"mass", "volume", "L"})}}};
}

KeyTable blocks_table() {
  return {
      "blocks",
      "Which blocks run, and how large",
      Repeat::kOnce,
      {{"library", "", "block library (HDF5)", {text()}, true},
       {"select", "", "ids, run in this order, or a class; without, all blocks", selection()},
       {"scale",
        "",
        "size to which every block is scaled; shape and density stay the same",
        {words({"equal-mass"}),
         table({{"mass_kg", "kg", "mass of every block", {number(kBlockMass)}, true}}),
         table({{"volume_m3", "m^3", "volume of every block", {number(kBlockVolume)}, true}})}},
       {"allow_any_size", "", "take blocks of unusual size too", {flag()}},
       {"draw",
        "",
        "blocks drawn from those selected",
        {table(
            {{"count", "", "how many", {count(1, kMostPerSet)}},
             {"volume_m3",
              "m^3",
              "total volume of rock, on average; in place of count",
              {number(kDrawnVolume)}},
             {"seed", "", "of the draw", {seed()}},
             {"scheme", "", "scheme of the classes in shares", {words(kSelectingSchemes)}},
             {"shares", "", "share of each class; they add up to 1", {named(number(kClassShare))}},
             {"mass_kg", "kg", "mass of a drawn block; without, its own",
              uncertain(kBlockMass)}})}},
       {"vary",
        "",
        "bodies made of the selected blocks, that run in their place",
        {table(vary_keys())}}},
      true};
}

KeyTable block_group_table() {
  return {"block_group",
          "Blocks for which the ground behaves differently",
          Repeat::kEither,
          {{"name", "", "of the group", {text()}, true},
           {"select", "", "ids, or a class", selection(), true},
           {"ground",
            "",
            "by zone, the parameters that differ",
            {named(table(ground_keys(false, false)))},
            true}}};
}

KeyTable terrain_table() {
  return {
      "terrain",
      "The surface that blocks move on",
      Repeat::kOnce,
      {{"surface", "", "TIN, raster, cloud or terrain file; or a list of files", texts(), true},
       {"zones", "", "a name per mesh, one zone file, or rules by slope and height", texts()},
       {"up",
        "",
        "axis that points up in surface, point and quaternion files",
        {words({"z", "y", "auto"})}},
       {"columns", "", "names or numbers of the columns x, y, z of a cloud in text", texts()},
       {"radius_m", "m", "raises the surface of the ground", {number(kGroundRadius)}},
       {"resolution_m", "m", "cell size of clouds and resampled rasters", {number(kCellSize)}},
       {"percentile",
        "",
        "height of a cloud's cell: percentile of its points",
        {number(kPercentile)}},
       {"outliers_m",
        "m",
        "points of a cloud farther from the ground around are left out",
        {number(kOutlierDistance)}},
       {"fill_m", "m", "holes up to this width are filled", {number(kHoleWidth)}},
       {"crack_m", "m", "cracks between tiles up to this width are closed", {number(kCrackWidth)}},
       {"spike_steepness",
        "",
        "vertices that protrude by more, over the distance to their neighbours, are levelled",
        {number(kSpikeSteepness)}},
       {"smoothing", "", "rounds of smoothing", {count(0, kMostSmoothing)}},
       {"tolerance_m",
        "m",
        "vertices are removed where the surface stays within this height",
        {number(kSurfaceTolerance)}},
       {"breaklines", "", "files with lines that become edges of the surface", texts()},
       {"cut_zones", "", "cut the borders of zone polygons into the triangles", {flag()}},
       {"border_distance_m",
        "m",
        "release points nearer to the border give a warning",
        {number(kBorderDistance)}}},
      true};
}

KeyTable ensemble_table() {
  return {"ensemble",
          "How often uncertain parameters are drawn",
          Repeat::kOnce,
          {{"members", "", "number of draws", {count(1, kMostPerSet)}, true},
           {"seed", "", "of the draws", {seed()}},
           {"design",
            "",
            "by chance, or filling the space of the parameters evenly",
            {words({"random", "sobol"})}},
           {"posterior", "", "posterior file whose draws the members have", {text()}},
           {"take",
            "",
            "tables whose parameters come from the posterior",
            {words({"ground", "contact", "release"}),
             list(words({"ground", "contact", "release"}), 1)}}}};
}

ValueForm point() { return list(number(kMapCoordinate), 2, 3); }

KeyTable release_table() {
  const TableKey how_many{"count", "", "how many points", {count(1, kMostPerSet)}, true};
  return {"release",
          "Where and how blocks start",
          Repeat::kEither,
          {{"name", "", "of the release set, where there are several", {text()}},
           {"points",
            "m",
            "of centres of mass: a file, a list, along a line or in a polygon",
            {text(), list(point(), 1),
             table({{"line", "m", "points are spaced evenly along it", {list(point(), 2)}, true},
                    how_many}),
             table({{"polygon", "m", "points are drawn in it", {list(point(), 3)}, true},
                    how_many,
                    {"seed", "", "of the points", {seed()}}})},
            true},
           {"orientations",
            "",
            "\"grid-45\", a file of quaternions, or random ones",
            {text(), table({{"random", "", "how many", {count(1, kMostPerSet)}, true},
                            {"seed", "", "of the orientations", {seed()}},
                            {"fresh", "", "different ones for every block and point", {flag()}}})},
            true},
           {"frame", "", "to which a file's rotations apply", {words({"source", "principal"})}},
           {"height_m", "m", "drop height; points are plan positions then", {number(kDropHeight)}},
           {"velocity_m_s",
            "m/s",
            "of the centre of mass at the start",
            {list(number({-kMostSpeed, kMostSpeed}), 3, 3)}},
           {"angular_velocity_rad_s",
            "rad/s",
            "at the start, along the map axes",
            {list(number({-kMostSpin, kMostSpin}), 3, 3)}},
           {"seed", "", "where points or orientations have none of their own", {seed()}},
           {"sequence",
            "",
            "every run alone, or blocks stay where they stop",
            {words({"single", "stay"})}},
           {"realisations",
            "",
            "how often all blocks are released, where they stay",
            {count(1, kMostPerSet)}},
           {"order", "", "of blocks that stay", {words({"random", "listed"})}},
           {"remove",
            "",
            "blocks that rest in a ground zone are removed",
            {table({{"zone", "", "name of the zone, or several", texts(), true}})}}}};
}

KeyTable mass_table() {
  return {"mass",
          "A rock mass, all blocks of which are released at once",
          Repeat::kEither,
          {{"name", "", "of the mass, required where there are several", {text()}},
           {"in_place", "", "blocks start where they lie in their library", {flag()}},
           {"height_m", "m", "a mass in place is raised by this", {number(kDropHeight)}},
           {"polygon",
            "m",
            "outline in plan of a heap, or of one of several masses in place",
            {list(point(), 3)}},
           {"thickness_m", "m", "largest height of a heap above the ground", {number(kThickness)}},
           {"share", "", "of the blocks that are in this heap", {number(kMassShare)}},
           {"count", "", "blocks that are in this heap", {count(1, kMostPerSet)}},
           {"release_time_s",
            "s",
            "its blocks are held until then, since the first release",
            {number(kReleaseTime)}},
           {"settle", "", "the blocks of a heap settle before it is released", {flag()}},
           {"settle_time_s", "s", "after which they must rest", {number(kSettleTime)}},
           {"faces",
            "",
            "how the faces that they settle behind are removed",
            {words({"together", "one by one"})}},
           {"face_interval_s", "s", "from one face to the next", {number(kFaceInterval)}},
           {"realisations", "", "how often the masses are released", {count(1, kMostPerSet)}},
           {"seed", "", "of what is drawn", {seed()}}}};
}

KeyTable contact_table() {
  return {"contact",
          "Law of contacts, their stiffness, and the time step",
          Repeat::kOnce,
          {{"law", "", "of the normal force", {words(contact_law_names())}},
           {"weights",
            "",
            "how contact points share the stiffness",
            {words({"patch", "overlap", "count", "none"})}},
           {"stiffness", "", "what each block, ground and start require", {words({"auto"})}},
           {"stiffness_n_m", "N/m", "normal stiffness k_n", {number(kStiffness)}},
           {"tangential_stiffness_n_m", "N/m", "tangential stiffness k_t", {number(kStiffness)}},
           {"rolling_stiffness_n_m_rad",
            "N m/rad",
            "rolling stiffness k_r on zones without rolling_length_m",
            {number(kRollingStiffness)}},
           {"time_step_s", "s", "time step, kept throughout", {number(kTimeStep)}},
           {"blocks",
            "",
            "what two blocks do to each other, where they stay",
            {table(ground_keys(true))}}}};
}

KeyTable barrier_table() {
  const ValueForm plan = list(number(kMapCoordinate), 2, 2);
  return {
      "barrier",
      "A line at which passing blocks are recorded",
      Repeat::kMany,
      {{"name", "", "of the barrier", {text()}, true},
       {"from", "m", "first end, [x, y]", {plan}},
       {"to", "m", "second end, [x, y]", {plan}},
       {"through", "m", "instead of from and to: all points of a line or ring", {list(plan, 2)}},
       {"direction", "", "which crossings count", {words({"either", "forward"})}}}};
}

KeyTable run_table() {
  return {
      "run",
      "When a run ends, and what is stored",
      Repeat::kOnce,
      {{"max_time_s", "s", "longest time of a run", {number(kRunTime)}},
       {"rest_energy_j_kg",
        "J/kg",
        "a block rests below this kinetic energy per mass ...",
        {number(kRestEnergy)}},
       {"rest_duration_s", "s", "... for this time", {number(kRestDuration)}},
       {"gravity_m_s2", "m/s^2", "gravity, downwards", {number(kGravity)}},
       {"downslope", "", "direction [dx, dy] of runout", {list(number(kDirectionComponent), 2, 2)}},
       {"trajectory_interval_s", "s", "between stored states", {number(kTrajectoryInterval)}}}};
}

}  // namespace

const std::vector<KeyTable>& campaign_tables() {
  static const std::vector<KeyTable> tables = {
      blocks_table(),
      {"blocks.vary", "Bodies made of the blocks, that run in their place", Repeat::kOnce,
       vary_keys()},
      block_group_table(),
      terrain_table(),
      {"ground", "How the ground of a zone behaves", Repeat::kNamed, ground_keys(false), true},
      ensemble_table(),
      release_table(),
      mass_table(),
      contact_table(),
      {"contact.blocks", "What two blocks do to each other", Repeat::kOnce, ground_keys(true)},
      barrier_table(),
      run_table()};
  return tables;
}

std::vector<std::string> campaign_keys(const std::string& table) {
  return table_named(campaign_tables(), table).key_names();
}

const std::vector<std::string>& campaign_words(const std::string& table, const std::string& key) {
  return table_named(campaign_tables(), table).key(key).words();
}

}  // namespace clast
