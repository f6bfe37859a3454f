# SPDX-License-Identifier: MIT
"""Makes robots in a further language and runs their vectors in it.

    python3 languages_test.py make QVGEN CC FOLDER ROBOT[:PARTS]...   robots in each language, and vectors by the C
    python3 languages_test.py rust|clippy|cargo|javascript|batches FOLDER    their vectors, or what the language's checker says
    python3 languages_test.py octave FOLDER                           their vectors, with the MEX file compiled
    python3 languages_test.py npm FOLDER                              packs, installs and imports a robot
    python3 languages_test.py readme FOLDER README                    the programs that the README shows
"""
import os
import pathlib
import shutil
import subprocess
import sys

import octave_runner
import rust_runner
import vectors

HERE = pathlib.Path(__file__).resolve().parent
SKIPPED = 77
# So many robots, the first of the list, also have vectors in float: one that has all parts, three in long runs.
IN_FLOAT = int(os.environ.get("QVGEN_ROBOTS_IN_FLOAT", "1"))


def vectors_in(folder, output, robot, cc, scalar):
    """Vectors of the robot's C in double or float, as JSON and as a program of Rust with its lines."""
    header, made = vectors.make(output, robot, cc, folder, 6, scalar)
    # These two take structs: the vectors called "representatives" go through rows by both.
    assert set(made["left_out"]) <= {"start_representatives", "next_representative"}, made["left_out"]
    (folder / f"{robot}.rs").write_text(rust_runner.program(header, scalar))
    (folder / f"{robot}.txt").write_text("".join(rust_runner.vector_lines(made)))
    return header, made


def make(tool, cc, folder, *robots):
    folder = pathlib.Path(folder)
    for each in robots:
        description, _, parts = each.partition(":")
        robot = pathlib.Path(description).stem
        only = ["--only", parts.replace("+", ",")] if parts else []
        subprocess.run([tool, "generate", description, *only, "--language", "c,rust,javascript,octave", "--output", folder / "made",
                        "--quiet"], check=True)
        header, made = vectors_in(folder / "vectors", folder / "made", robot, cc, "double")
        (folder / "vectors" / f"{robot}.m").write_text(
            octave_runner.write(header, made, folder / "vectors/octave", (folder / "made/octave").resolve()))
        print(f"{robot}: {len(made['calls'])} vectors of {len(header.functions)} functions")
    make_in_float(tool, cc, folder, robots[:IN_FLOAT])


def make_in_float(tool, cc, folder, robots):
    """Vectors of the C in float, which the crate's f32 has to give. Those of a run with more robots are removed."""
    for left in ("made_in_float", "vectors_in_float"):
        shutil.rmtree(folder / left, ignore_errors=True)
    for each in robots:
        description, _, parts = each.partition(":")
        only = ["--only", parts.replace("+", ",")] if parts else []
        subprocess.run([tool, "generate", description, *only, "--language", "c", "--scalar", "float", "--output",
                        folder / "made_in_float", "--quiet"], check=True)
        vectors_in(folder / "vectors_in_float", folder / "made_in_float", pathlib.Path(description).stem, cc, "float")


def robots_of(folder):
    return sorted(path.stem for path in (folder / "vectors").glob("*.json"))


def needed(program):
    if shutil.which(program) is None:
        print(f"skipped: there is no {program}; Debian has it in the package {PACKAGES[program]}")
        sys.exit(SKIPPED)
    return program


def npm(folder):
    """Packs a robot, installs the archive in an empty project without network, and imports it by its name."""
    program = needed("npm")
    package, project = folder / "made/javascript/qvgen_puma560", folder / "npm"
    shutil.rmtree(project, ignore_errors=True)
    project.mkdir()
    quiet = ["--silent", "--offline", "--cache", str(project / "cache"), "--no-audit", "--no-fund"]
    subprocess.run([program, "pack", package.resolve(), "--pack-destination", project, *quiet], check=True, stdout=subprocess.DEVNULL)
    archive, = project.glob("*.tgz")
    (project / "package.json").write_text('{"name": "user", "private": true, "type": "module"}')
    subprocess.run([program, "install", archive.name, *quiet], cwd=project, check=True)
    there = {path.name for path in (project / "node_modules/qvgen_puma560").iterdir()} - {"qvgen_puma560_wasm.mjs"}
    assert there == {"README.md", "package.json", "build.mjs", "source", "qvgen_puma560.d.mts", "qvgen_puma560.mjs",
                     "qvgen_puma560_batch.d.mts", "qvgen_puma560_batch.mjs"}, there
    text = readme_block(package / "README.md", "import * as arm from")
    (project / "use.mjs").write_text(text + "if (found.count === 0) throw new Error('nothing found');\n")
    subprocess.run([needed("node"), "use.mjs"], cwd=project, check=True, stdout=subprocess.DEVNULL)


PACKAGES = {"npm": "npm", "rustc": "rustc", "cargo": "cargo", "clippy-driver": "rust-clippy", "node": "nodejs", "clang": "clang", "wasm-ld": "lld",
            "octave-cli": "octave", "mkoctfile": "octave-dev"}
CRATE = ["--edition", "2021", "--crate-type", "lib", "--cfg", 'feature="std"']
SINGLE = ["--cfg", 'feature="f32"']


def rust(folder):
    rustc = needed("rustc")
    for robot in robots_of(folder):
        vectors_of = folder / "vectors"
        library = vectors_of / f"libqvgen_{robot}.rlib"
        crate = folder / "made/rust" / f"qvgen_{robot}/src/lib.rs"
        programs = [each for each in (vectors_of, folder / "vectors_in_float") if (each / f"{robot}.rs").exists()]
        options = [*CRATE, *(SINGLE if len(programs) == 2 else [])]
        subprocess.run([rustc, *options, "--crate-name", f"qvgen_{robot}", "-O", "-D", "warnings", crate, "-o", library],
                       check=True)
        for each in programs:
            run_in_rust(rustc, robot, library, each)


def run_in_rust(rustc, robot, library, vectors_of):
    program = vectors_of / f"{robot}_in_rust"
    subprocess.run([rustc, "--edition", "2021", "--extern", f"qvgen_{robot}={library}", vectors_of / f"{robot}.rs",
                    "-o", program], check=True)
    subprocess.run([program, vectors_of / f"{robot}.txt"], check=True)


def clippy(folder):
    driver = needed("clippy-driver")
    for robot in robots_of(folder):
        crate = folder / "made/rust" / f"qvgen_{robot}/src/lib.rs"
        subprocess.run([driver, *CRATE, *SINGLE, "--crate-name", f"qvgen_{robot}", "--emit", "metadata", "-D", "warnings",
                        "-D", "clippy::all", crate, "-o", folder / "vectors" / "checked.rmeta"], check=True)


def javascript(folder):
    node = needed("node")
    for robot in robots_of(folder):
        module = folder / "made/javascript" / f"qvgen_{robot}/qvgen_{robot}.mjs"
        subprocess.run([node, HERE / "run_vectors.mjs", module, folder / "vectors" / f"{robot}.json"], check=True)


def batches(folder):
    """Compiles batches of robots for WebAssembly; before that their module says what is to be done."""
    node = needed("node")
    for program in ("clang", "wasm-ld"):
        needed(program)
    for robot in ("ns_arm", "puma560", "bevel_arm"):
        package = folder / "made/javascript" / f"qvgen_{robot}"
        (package / f"qvgen_{robot}_wasm.mjs").unlink(missing_ok=True)
        early = subprocess.run([node, package / f"qvgen_{robot}_batch.mjs"], capture_output=True, text=True)
        assert early.returncode != 0 and "run node build.mjs" in early.stderr, early.stderr
        subprocess.run([node, package / "build.mjs"], check=True)
        subprocess.run([node, HERE / "run_batches.mjs", package, robot, folder / "vectors" / f"{robot}.json"], check=True)


def octave(folder):
    for robot in robots_of(folder):
        run_octave(folder / "vectors" / f"{robot}.m")


def run_octave(program):
    """Runs a program and prints its output, where Octave says what failed, without what it says at its end."""
    needed("mkoctfile")
    done = subprocess.run([needed("octave-cli"), "--norc", "--quiet", "--path", HERE, program], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
    print(done.stdout)
    done.check_returncode()


def readme_block(readme, first_line):
    """The indented block of a README that begins with that line."""
    lines = pathlib.Path(readme).read_text().splitlines()
    starts = [i for i, line in enumerate(lines) if line.startswith("    " + first_line)]
    assert starts, f"{readme} has no block that begins with {first_line}"
    block = []
    for line in lines[starts[0]:]:
        if line and not line.startswith("    "):
            break
        block.append(line)
    return "\n".join(line[4:] for line in block) + "\n"


def javascript_example(folder, page):
    program = folder / "readme/example.mjs"
    program.write_text(readme_block(page, "import * as arm from").replace("./out/", "../made/"))
    subprocess.run(["node", program], check=True)


def rust_example(folder, page):
    program = folder / "readme/example.rs"
    program.write_text(readme_block(page, "use qvgen_puma560"))
    library = folder / "readme/libqvgen_puma560.rlib"
    crate = folder / "made/rust/qvgen_puma560/src/lib.rs"
    subprocess.run(["rustc", *CRATE, "--crate-name", "qvgen_puma560", crate, "-o", library], check=True)
    subprocess.run(["rustc", "--edition", "2021", "--extern", f"qvgen_puma560={library}", program, "-o",
                    folder / "readme/example"], check=True)
    subprocess.run([folder / "readme/example"], check=True)


def octave_example(folder, page):
    program = folder / "readme/example.m"
    program.write_text(readme_block(page, "addpath('out/octave')").replace("out/octave", str((folder / "made/octave").resolve())))
    run_octave(program)


def readme(folder, page):
    """Runs the READMEs' programs in the languages that are there."""
    (folder / "readme").mkdir(exist_ok=True)
    examples = {"node": javascript_example, "rustc": rust_example, "mkoctfile": octave_example}
    missing = [program for program in examples if shutil.which(program) is None]
    for program, example in examples.items():
        if program not in missing:
            example(folder, page)
    if missing:
        print(f"skipped: {len(missing)} of {len(examples)} examples; there is no {', '.join(missing)}")
        sys.exit(SKIPPED)


def cargo(folder):
    """Builds a crate as its users do; the feature libm needs the network, or a cargo that has it."""
    program = needed("cargo")
    crate = folder / "made/rust/qvgen_ns_arm"
    target = ["--target-dir", str(folder / "cargo")]
    done = subprocess.run([program, "build", *target, "--no-default-features", "--features", "libm,f32"], cwd=crate,
                          capture_output=True, text=True, timeout=300)
    if done.returncode != 0 and any(word in done.stderr for word in ("index", "network", "resolve host", "download")):
        print("skipped: cargo cannot reach crates.io, where the crate libm is")
        sys.exit(SKIPPED)
    if done.returncode != 0:
        sys.exit(done.stderr)
    subprocess.run([program, "test", *target, "--quiet", "--features", "f32"], cwd=crate, check=True)
    subprocess.run([program, "doc", *target, "--quiet", "--no-deps", "--features", "f32"], cwd=crate, check=True,
                   env={**os.environ, "RUSTDOCFLAGS": "-D warnings"})
    listed = subprocess.run([program, "package", "--list", "--allow-dirty"], cwd=crate, check=True, capture_output=True, text=True)
    assert {"Cargo.toml", "README.md", "src/lib.rs", "src/metrics.rs", "src/f32.rs", "src/f32/math.rs"} <= set(listed.stdout.split()), listed.stdout


if __name__ == "__main__":
    what, *arguments = sys.argv[1:]
    try:
        if what == "make":
            make(*arguments)
        else:
            run = {"rust": rust, "clippy": clippy, "cargo": cargo, "javascript": javascript, "batches": batches, "octave": octave, "npm": npm, "readme": readme}[what]
            run(pathlib.Path(arguments[0]), *arguments[1:])
    except subprocess.CalledProcessError as error:
        sys.exit(f"failed: {error}")
