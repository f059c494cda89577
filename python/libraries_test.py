import subprocess
import sys
import threading
from pathlib import Path

import clast
import numpy as np
import pytest
from conftest import program


def test_a_library_is_a_sequence_of_its_blocks(library):
    assert library.ids == ["B01_compact", "B02_platy", "B04_elongated"]
    assert [block.id for block in library] == library.ids
    assert len(library) == 3 and "B02_platy" in library and "B9" not in library
    with pytest.raises(clast.InputError, match="there is no block B9; there are B01_compact"):
        library["B9"]


def test_a_library_that_is_not_there_is_made_by_the_first_block(tmp_path, block):
    library = clast.Library(tmp_path / "new.h5")
    with pytest.raises(clast.InputError, match="new.h5"):
        library.ids
    library.add(block, id="B017")
    assert library.ids == ["B017"]
    assert "B017" in program("show", library.path)
    with pytest.raises(clast.InputError, match="B017"):
        library.add(block, id="B017")
    library.add(block, id="B017", replace=True)
    assert len(clast.Library(library.path)) == 1


@pytest.mark.parametrize("id", ["", "a/b", "..", "a\nb"])
def test_an_id_that_names_no_block_is_refused(tmp_path, block, id):
    with pytest.raises(clast.InputError):
        clast.Library(tmp_path / "new.h5").add(block, id=id)
    assert not (tmp_path / "new.h5").exists()


def test_what_is_no_library_is_refused(tmp_path, block):
    text = tmp_path / "text.h5"
    text.write_text("not a library")
    with pytest.raises(clast.InputError, match="text.h5"):
        clast.Library(text)
    with pytest.raises(clast.InputError):
        clast.Library(tmp_path)
    with pytest.raises(TypeError):
        clast.Library(17)
    assert text.read_text() == "not a library"


def test_a_block_passes_through_a_file_without_a_changed_bit(tmp_path, block):
    library = clast.Library(tmp_path / "copy.h5")
    library.add(block)
    copy = clast.Library(library.path)[block.id]
    assert np.array_equal(copy.core.vertices, block.core.vertices)
    assert np.array_equal(copy.inertia, block.inertia)
    assert copy.to_dict() == block.to_dict()


def test_merge_remove_and_notes_are_those_of_the_program(tmp_path, library):
    merged = clast.Library(tmp_path / "all.h5")
    merged.merge(library.path)
    merged.set("B02_platy", site="north face", taped=[0.4, 0.6, 0.5], weighed=342.0)
    field = merged["B02_platy"].to_dict()["field"]
    assert field == {"site": "north face", "taped_m": [0.6, 0.5, 0.4], "weighed_kg": 342.0}
    merged.remove("B01_compact")
    assert merged.ids == ["B02_platy", "B04_elongated"]
    with pytest.raises(clast.InputError):
        merged.remove(["B04_elongated", "B9"])
    assert len(clast.Library(merged.path)) == 2
    with pytest.raises(clast.InputError, match="nothing to set"):
        merged.set("B02_platy")
    with pytest.raises(clast.InputError, match="weighed"):
        merged.set("B02_platy", weighed=float("nan"))
    with pytest.raises(TypeError, match="taped"):
        merged.set("B02_platy", taped=[1.0, 2.0])


def test_export_writes_what_the_program_writes(tmp_path, made, library):
    files = library.export(tmp_path / "py", format=["shp", "obj"], what="core")
    program("export", made / "blocks.h5", "-o", tmp_path / "prog", "--format", "shp,obj",
            "--what", "core")  # fmt: skip
    assert len(files) == 6
    for file in (tmp_path / "prog").iterdir():
        assert (tmp_path / "py" / file.name).read_bytes() == file.read_bytes()
    with pytest.raises(clast.InputError):
        library.export(tmp_path / "py", format="shp")
    with pytest.raises(clast.InputError, match="what"):
        library.export(tmp_path / "new", format="obj", what="inside")


def test_a_gallery_is_a_page(tmp_path, library):
    page = library.report(tmp_path / "pages", "B01_compact")
    assert "B01_compact" in Path(page).read_text(encoding="utf-8")
    with pytest.raises(clast.InputError):
        library.report(tmp_path / "pages")
    assert "<img" in library._repr_html_()


def test_threads_share_files_without_harm(library):
    failures = []

    def read():
        for _ in range(10):
            try:
                assert len(clast.Library(library.path)) == 3
            except Exception as error:  # noqa: BLE001
                failures.append(error)

    threads = [threading.Thread(target=read) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures


def test_the_import_loads_neither_point_clouds_nor_pictures():
    code = (
        "import clast, pathlib; maps = pathlib.Path('/proc/self/maps').read_text().split();"
        "print([file for file in maps if 'pcl' in file or 'opencv' in file])"
    )
    done = subprocess.run([sys.executable, "-X", "dev", "-W", "error", "-c", code],
                          capture_output=True, text=True, check=True)  # fmt: skip
    assert done.stdout.strip() == "[]"
    assert done.stderr == ""


