"""Rock blocks from field scans, and their simulation on surveyed terrain.

    >>> import clast
    >>> block = clast.reconstruct("B017.ply", units="mm", density=2650)
    >>> block.mass, block.box_lengths, block.classes["sneed_folk"].survives

The module has all functions of the program `clast`, with the names of its options, of the keys of
campaign files and of the columns of its tables. Lengths are in metres, masses in kilograms, angles in
radians where a name has no unit, and z is up. Errors are raised as `InputError`,
`GeometryError` or `SimulationError`, all subclasses of `Error`, with the program's messages.
"""

from clast._blocks import (
    Cut,
    Library,
    Reconstruction,
    Series,
    cut,
    reconstruct,
    reconstruct_batch,
    vary,
)
from clast._calibrations import (
    Calibration,
    calibrate,
    calibrate_shard,
    calibration_schema,
    check_calibration,
)
from clast._campaigns import Campaign, CampaignTable, campaign_schema, new_campaign
from clast._core import (
    Block,
    Core,
    Error,
    GeometryError,
    InputError,
    ShapeClass,
    SimulationError,
    mass_properties,
    schemes,
    shape_classes,
)
from clast._core import version as __version__
from clast._populations import Population, classify
from clast._results import Comparison, Results, compare, import_results, merge_results
from clast._tables import Table
from clast._terrain import Terrain, terrain
from clast._worlds import World

__all__ = [
    "Block",
    "Calibration",
    "Campaign",
    "CampaignTable",
    "Comparison",
    "Core",
    "Cut",
    "Error",
    "GeometryError",
    "InputError",
    "Library",
    "Population",
    "Reconstruction",
    "Results",
    "Series",
    "ShapeClass",
    "SimulationError",
    "Table",
    "Terrain",
    "World",
    "__version__",
    "calibrate",
    "calibrate_shard",
    "calibration_schema",
    "campaign_schema",
    "check_calibration",
    "classify",
    "compare",
    "cut",
    "import_results",
    "mass_properties",
    "merge_results",
    "new_campaign",
    "reconstruct",
    "reconstruct_batch",
    "schemes",
    "shape_classes",
    "terrain",
    "vary",
]
