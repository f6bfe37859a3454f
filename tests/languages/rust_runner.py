# SPDX-License-Identifier: MIT
"""Writes a Rust program that runs a robot's vectors, for its C header: one arm of a match for each function."""
from c_driver import TOLERANCES


REPRESENTATIVES = """        "representatives" => {
            let g = &robot::DEFAULT_GEOMETRY;
            let found = robot::inverse_kinematics(&array::<4>(a[0]), &array::<3>(a[1]), None, g, %(tolerance)s);
            let (lower, upper) = (array::<%(dof)s>(a[2]), array::<%(dof)s>(a[3]));
            let mut all = robot::start_representatives(&found, Some(&lower), Some(&upper));
            let mut rows = 0;
            while rows < 50 && robot::next_representative(&mut all) != 0 {
                rows += 1;
                for x in all.row.q { out.push(bits(x)); }
            }
        }
"""

METRICS = """        "metrics" => {
            use robot::metrics::*;
            let g = &robot::DEFAULT_GEOMETRY;
            let seed = array::<%(dof)s>(a[2]);
            let drives = Drives { speeds: array(a[3]), accelerations: array(a[4]) };
            let all = || robot::inverse_kinematics(&array::<4>(a[0]), &array::<3>(a[1]), None, g, %(tolerance)s);
            let metrics: [(bool, bool, Box<dyn Fn(&Joints) -> Real>); 4] = [
                (true, false, Box::new(|way| fastest_time(way, &drives))),
                (true, true, Box::new(|way| weighted_distance(way, &drives.speeds))),
                (true, false, Box::new(|way| largest_joint(way, Some(&drives.accelerations)))),
                (false, false, Box::new(|way| largest_joint(way, None))),
            ];
            for (has_seed, within, metric) in metrics {
                let mut found = all();
                out.push(format!("#{}", best_by(&found, Some(&seed), within, &metric).map_or(-2, |row| row.branch)));
                sort_by(&mut found, if has_seed { Some(&seed) } else { None }, within, &metric);
                for row in &found.rows[..found.count as usize] { for x in row.q { out.push(bits(x)); } }
            }
        }
"""


def type_name(name, robot):
    return "".join(part[:1].upper() + part[1:] for part in name.removeprefix(robot + "_").split("_"))


HEAD = """// Runs the vectors of a file, a line each: name|arguments|=result; numbers by their bits.
use qvgen_%(robot)s%(module)s as robot;
type Real = %(real)s;
type Numbers = Vec<String>;
fn bits(x: Real) -> String { if x.is_nan() { "nan".into() } else { format!("{:016x}", (x as f64).to_bits()) } }
fn number(text: &str) -> Real { f64::from_bits(u64::from_str_radix(text, 16).unwrap()) as Real }
fn array<const N: usize>(text: &str) -> [Real; N] {
    let mut result = [0.0; N];
    for (to, from) in result.iter_mut().zip(text.split(',')) { *to = number(from); }
    result
}
fn option<const N: usize>(text: &str) -> Option<[Real; N]> { if text == "none" { None } else { Some(array(text)) } }
fn call(name: &str, a: &[&str]) -> Numbers {
    let mut out = Numbers::new();
    match name {
"""

TAIL = """        _ => panic!("no function {name}"),
    }
    out
}
fn main() {
    let text = std::fs::read_to_string(std::env::args().nth(1).unwrap()).unwrap();
    let (mut failures, mut count) = (0, 0);
    for line in text.lines() {
        let (left, wanted) = line.split_once("|=").unwrap();
        let mut parts = left.split('|');
        let name = parts.next().unwrap();
        let given = call(name, &parts.collect::<Vec<_>>());
        let same = |x: &str| if x.starts_with('#') { x.to_string() } else { bits(number(x)) };
        let wanted: Numbers = wanted.split(',').filter(|x| !x.is_empty()).map(same).collect();
        count += 1;
        if given != wanted { failures += 1; eprintln!("{left}\\n  is     {given:?}\\n  not    {wanted:?}"); }
    }
    println!("{count} vectors in Rust, {failures} failures");
    std::process::exit(if failures > 0 || count == 0 { 1 } else { 0 });
}
"""


def pushed(header, struct, place):
    text = ""
    for type_, field, sizes in header.structs[struct]:
        own = f"{place}.{field}"
        if sizes and type_ not in ("double", "int"):
            inner = pushed(header, type_, "each")
            text += f"for each in &{own}[..{place}.count as usize] {{ {inner} }} "
        elif type_ in ("double", "int"):
            text += numbers(own, len(sizes), type_)
        else:
            text += pushed(header, type_, own)
    return text


def numbers(place, depth, type_):
    one = "out.push(bits({}));" if type_ == "double" else 'out.push(format!("#{{}}", {}));'
    if depth == 0:
        return one.format(place) + " "
    names = [f"x{i}" for i in range(depth)]
    loops = "".join(f"for {name} in {'&' + place if i == 0 else names[i - 1]} {{ " for i, name in enumerate(names))
    return loops + one.format("*" + names[-1]) + " }" * depth + " "


def program(header, scalar="double"):
    """The program for f64, or for the module f32 of the crate."""
    real, module = {"double": ("f64", ""), "float": ("f32", "::f32")}[scalar]
    robot, text = header.robot, HEAD % {"robot": header.robot, "real": real, "module": module}
    for name, kinds, result in header.functions:
        arguments = []
        for i, (kind, own, size) in enumerate(kinds):
            if kind == "result":
                continue
            arguments.append({"geometry": "&robot::DEFAULT_GEOMETRY", "inertia": "&robot::DEFAULT_INERTIA",
                              "usual": "None", "number": f"number(a[{i}])", "array": f"&array::<{size}>(a[{i}])",
                              "optional": f"option::<{size}>(a[{i}]).as_ref()"}[kind])
        last = kinds[-1]
        if last[0] != "result":
            out = numbers("r", 0, result)
        elif isinstance(last[2], list):
            out = numbers("r", len(last[2]), "double")
        else:
            out = pushed(header, last[2], "r")
        text += f'        "{name}" => {{ let r = robot::{name}({", ".join(arguments)}); {out}}}\n'
    if header.has_representatives():
        text += (REPRESENTATIVES + METRICS) % {"dof": header.numbers[robot + "_dof"], "tolerance": TOLERANCES[scalar]}
    return text + TAIL


def vector_lines(vectors):
    for call in vectors["calls"]:
        arguments = [",".join(a) if isinstance(a, list) else a for a in call["arguments"]]
        yield "|".join([call["function"], *arguments, "=" + ",".join(call["result"])]) + "\n"
