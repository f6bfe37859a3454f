# SPDX-License-Identifier: MIT
"""Builds the Python package for pip (PEP 517 and 660), from this source tree alone.

The wheel holds the module and the sources that it compiles robots from. Robots that are asked for are compiled into it:
pip install . --config-settings=robots=ur5,puma560 (or all); the others, as those of qvgen.load, at first use by the user's compiler.
"""

import base64
import hashlib
import io
import json
import pathlib
import re
import sys
import sysconfig
import tarfile
import tomllib
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PACKAGE = ROOT / "runtime/python/qvgen"
SOURCES = ("runtime/include", "runtime/source", "generated/include", "generated/source", "generated/operation_counts.json")
DISTRIBUTED = ("LICENSE", "README.md", "CMakeLists.txt", "pyproject.toml", "runtime", "generated")


def _project():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    version = re.search(r"project\(qvgen VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
    return {**project, "version": version}


def _files(path):
    """The files of a folder, those that running it has left behind excepted; a file is itself."""
    if path.is_file():
        return [path]
    return sorted(each for each in path.rglob("*") if each.is_file() and each.suffix not in (".pyc", ".so"))


def _metadata():
    project = _project()
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {project['version']}",
             f"Summary: {project['description']}", "License: MIT", f"Requires-Python: {project['requires-python']}",
             *(f"Requires-Dist: {each}" for each in project["dependencies"])]
    return "\n".join(lines) + "\n\n" + (ROOT / "README.md").read_text()


def _known_robots():
    counts = json.loads((ROOT / "generated/operation_counts.json").read_text())
    return [name for name in counts if "/" not in name]


def _asked_robots(settings):
    asked = (settings or {}).get("robots", "")
    names = asked if isinstance(asked, list) else asked.split(",")
    names = [name for name in names if name]
    return _known_robots() if names == ["all"] else names


def _write_wheel(folder, tag, files):
    """files: (name in the wheel, content). Two wheels of the same are the same bytes."""
    name = "{name}-{version}".format(**_project())
    pure = tag.endswith("-any")
    info = f"{name}.dist-info"
    wheel = f"Wheel-Version: 1.0\nGenerator: qvgen\nRoot-Is-Purelib: {str(pure).lower()}\nTag: {tag}\n"
    files = [*files, (f"{info}/METADATA", _metadata().encode()), (f"{info}/WHEEL", wheel.encode()),
             (f"{info}/LICENSE", (ROOT / "LICENSE").read_bytes())]
    record = f"{info}/RECORD"
    lines = []
    target = pathlib.Path(folder) / f"{name}-{tag}.whl"
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in files:
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            lines.append(f"{path},sha256={digest},{len(content)}")
            archive.writestr(_entry(path), content)
        archive.writestr(_entry(record), "\n".join([*lines, f"{record},,"]) + "\n")
    return target.name


def _entry(path):
    entry = zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0))
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = 0o644 << 16
    return entry


def _compiled(robots):
    """(name in the wheel, content) of the robots' modules."""
    sys.path.insert(0, str(PACKAGE.parent))
    from qvgen import _build
    for robot in robots:
        module = _build.module_file(robot, _build.generated_folder)
        yield f"qvgen/robots/{module.name}", module.read_bytes()


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    robots = _asked_robots(config_settings)
    files = [(f"qvgen/{path.relative_to(PACKAGE)}", path.read_bytes()) for path in _files(PACKAGE)]
    files += [(f"qvgen/_tree/{path.relative_to(ROOT)}", path.read_bytes())
              for source in SOURCES for path in _files(ROOT / source)]
    files += _compiled(robots)
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub("[-.]", "_", sysconfig.get_platform())
    return _write_wheel(wheel_directory, f"{python}-{python}-{platform}" if robots else "py3-none-any", files)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    return _write_wheel(wheel_directory, "py3-none-any", [("qvgen.pth", f"{PACKAGE.parent}\n".encode())])


def build_sdist(sdist_directory, config_settings=None):
    name = "{name}-{version}".format(**_project())
    with tarfile.open(pathlib.Path(sdist_directory) / f"{name}.tar.gz", "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for each in DISTRIBUTED:
            for path in _files(ROOT / each):
                archive.add(path, f"{name}/{path.relative_to(ROOT)}")
        metadata = tarfile.TarInfo(f"{name}/PKG-INFO")
        metadata.size = len(_metadata().encode())
        archive.addfile(metadata, io.BytesIO(_metadata().encode()))
    return f"{name}.tar.gz"
