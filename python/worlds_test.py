import clast
import numpy as np
import pytest
from conftest import SAMPLES, cube

GROUND = {"ground": {"energy_restitution": 0.04, "friction": 0.5, "rolling_friction": 0.2}}


@pytest.fixture(scope="module")
def stone():
    vertices, triangles = cube(0.5)
    return clast.reconstruct((vertices, triangles), "stone", radius=0.02)


@pytest.fixture(scope="module")
def plane(tmp_path_factory):
    """Flat ground at z = 0 from -10 to 10 m."""
    file = tmp_path_factory.mktemp("plane") / "plane.off"
    file.write_text("OFF\n4 2 0\n-10 -10 0\n10 -10 0\n10 10 0\n-10 10 0\n3 0 1 2\n3 0 2 3\n")
    return clast.terrain(file)


def test_a_block_without_ground_flies_a_parabola(stone):
    world = clast.World()
    world.add(stone, [0.0, 0.0, 100.0], velocity_m_s=[3.0, 0.0, 4.0])
    world.run(1.5)
    t = world.time_s
    assert t == pytest.approx(1.5)
    state = world.states()
    assert state["position_m"][0] == pytest.approx(
        [3.0 * t, 0.0, 100.0 + 4.0 * t - 0.5 * 9.81 * t * t], abs=1e-2
    )
    assert state["velocity_m_s"][0] == pytest.approx([3.0, 0.0, 4.0 - 9.81 * t], abs=1e-2)


def test_a_dropped_block_comes_to_rest_on_the_ground(stone, plane):
    world = clast.World(plane, ground=GROUND)
    number = world.add(stone, [1.0, 2.0, 1.0])
    steps = []
    assert world.run(20.0, steps.append) == "rest"
    state = world.states()
    assert state["resting"][number] and not state["gone"][number]
    assert state["position_m"][number][2] == pytest.approx(0.25, abs=0.02)
    force = world.contacts(number)["force_n"]
    # At rest it may still rock by 1 % of its weight.
    assert force == pytest.approx([0.0, 0.0, stone.mass * 9.81], rel=0.05, abs=0.1 * stone.mass)
    energy = world.energy()
    assert energy["energy_error"] < 0.01
    assert energy["energy_normal_j"] > 0.0


def test_blocks_hit_each_other(stone):
    world = clast.World(gravity_m_s2=0.01, between_blocks=GROUND["ground"])
    world.add(stone, [0.0, 0.0, 0.0], velocity_m_s=[2.0, 0.0, 0.0])
    world.add(stone, [1.0, 0.0, 0.0])
    world.run(1.0)
    velocity = world.states()["velocity_m_s"]
    assert velocity[1, 0] > 0.5  # the one that was hit moves on
    assert velocity[:, 0].sum() == pytest.approx(2.0, rel=1e-6)  # momentum


def test_steps_are_the_same_on_any_number_of_threads(stone, plane):
    ends = []
    for threads in (1, 2):
        world = clast.World(plane, ground=GROUND, threads=threads)
        for i in range(4):
            world.add(stone, [0.1 * i, 0.0, 0.6 + 0.8 * i])
        world.step(500)
        ends.append(world.states()["position_m"])
    assert np.array_equal(*ends)


def test_orientations_turn_the_block_as_its_scan_holds_it(stone):
    half = np.sqrt(0.5)
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    for orientation in ([half, 0.0, 0.0, half], turn):
        world = clast.World()
        world.add(stone, [0.0, 0.0, 0.0], orientation)
        found = world.states()["orientation"][0]
        assert abs(np.dot(found, [half, 0.0, 0.0, half])) == pytest.approx(1.0)


def test_a_known_block_may_come_later_and_leave(stone, plane):
    other = clast.reconstruct(cube(0.3), "other", radius=0.01)
    world = clast.World(plane, ground=GROUND)
    world.add(stone, [0.0, 0.0, 1.0])
    world.step()
    with pytest.raises(clast.SimulationError, match="other is not known"):
        world.add(other, [3.0, 0.0, 1.0])
    assert world.add(stone, [3.0, 0.0, 1.0]) == 1 and len(world) == 2
    world.remove(0)
    assert world.states()["gone"].tolist() == [True, False]
    assert world.contact()["time_step_s"] > 0.0


def test_a_world_is_left_alone_while_it_moves(stone, plane):
    world = clast.World(plane, ground=GROUND)
    world.add(stone, [0.0, 0.0, 5.0])
    caught = []

    def look(step):
        try:
            world.states()
        except clast.SimulationError as error:
            caught.append(str(error))

    world.run(3.0, look)
    assert all("is moving" in text for text in caught)
    world.states()


@pytest.mark.parametrize(
    ("keywords", "error", "words"),
    [
        ({}, clast.InputError, "ground"),
        ({"ground": {}}, clast.InputError, "zone ground of the terrain has no parameters"),
        ({"ground": {**GROUND, "moss": GROUND["ground"]}}, clast.InputError, "no zone moss"),
        ({"ground": {"ground": {"friction": -1.0}}}, clast.InputError, "friction"),
        ({"ground": {"ground": {"fricton": 1.0}}}, TypeError, "fricton"),
        ({"ground": GROUND, "law": "sticky"}, clast.InputError, "sticky"),
        ({"ground": GROUND, "gravity_m_s2": float("nan")}, clast.Error, "gravity"),
        ({"ground": GROUND, "threads": "two"}, TypeError, "threads"),
    ],
)
def test_settings_out_of_range_are_refused(plane, keywords, error, words):
    with pytest.raises(error, match=words):
        clast.World(plane, **keywords)


def test_starts_that_can_not_be_are_refused(stone, plane):
    world = clast.World(plane, ground=GROUND)
    for position in ([np.nan, 0.0, 1.0], [0.0, 1.0], [[0.0, 0.0, 1.0]]):
        with pytest.raises(clast.InputError, match="position"):
            world.add(stone, position)
    with pytest.raises(clast.InputError, match="orientation"):
        world.add(stone, [0.0, 0.0, 1.0], [2.0, 0.0, 0.0, 0.0])
    with pytest.raises(clast.InputError, match="not a rotation"):
        world.add(stone, [0.0, 0.0, 1.0], 2 * np.eye(3))
    with pytest.raises(TypeError):
        world.add("stone", [0.0, 0.0, 1.0])
    with pytest.raises(clast.SimulationError, match="empty"):
        world.step()
    world.add(stone, [0.0, 0.0, -3.0])
    with pytest.raises(clast.SimulationError):
        world.step()
    with pytest.raises(clast.InputError, match="duration"):
        world.run(float("nan"))


def test_a_block_falls_down_a_real_slope():
    tiles = [SAMPLES / "terrain" / f"quarry_{zone}.ply" for zone in ("blue", "gray", "red")]
    quarry = clast.terrain(tiles, zones=["blue", "gray", "red"])
    ground = {zone: GROUND["ground"] for zone in quarry.zone_names}
    block = clast.reconstruct(SAMPLES / "blocks" / "B01_compact.ply", vertices=40)
    world = clast.World(quarry, ground=ground)
    world.add(block, [2.3, 80.0, 209.5])
    world.run(2.0)
    place = world.states()["position_m"][0]
    assert place[2] < 209.0
    assert place[2] > quarry.height(place[:1], place[1:2])[0] - 0.1
