#!/usr/bin/python3
"""Generates C++ from the .msg, .srv and .action files of this folder, at build time.

    generate.py SOURCE_DIR OUTPUT_DIR

.msg/.srv/.action --rosidl--> one IDL file per package --fastddsgen--> PKG.h, PKG.cxx; beside them
PKG/msg/TYPE.h (what users include), and types.cc: names, fields and RIHS01 hashes of all types.
One IDL file per package, because fastddsgen writes into one flat folder, where the KeyValue of two packages
would collide; and because one Java start for all takes a second, one for each file a minute.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import type_descriptions  # noqa: E402
from rosidl_adapter import convert_to_idl  # noqa: E402

# Comments as annotations: no use in C++, and fastddsgen stumbles over quotation marks in them.
COMMENTS = re.compile(r'@(verbatim|unit) \((language="comment", text|value)=(\s*"([^"\\]|\\.)*")*\s*\)')

# Field names that IDL reserves get an underscore in C++; names do not travel in the data.
KEYWORD_FIELDS = re.compile(r"(?<= )(sequence|map|string|struct|union|module|const|enum|default|octet|any|set|in|out);")

PROTOCOL_IDL = """
module {pkg} {{
  module action {{
    struct {name}_SendGoal_Request {{
      unique_identifier_msgs::msg::UUID goal_id;
      {pkg}::action::{name}_Goal goal;
    }};
    struct {name}_SendGoal_Response {{
      boolean accepted;
      builtin_interfaces::msg::Time stamp;
    }};
    struct {name}_GetResult_Request {{
      unique_identifier_msgs::msg::UUID goal_id;
    }};
    struct {name}_GetResult_Response {{
      int8 status;
      {pkg}::action::{name}_Result result;
    }};
    struct {name}_FeedbackMessage {{
      unique_identifier_msgs::msg::UUID goal_id;
      {pkg}::action::{name}_Feedback feedback;
    }};
  }};
}};
"""

SERVICE_HEADER = """#pragma once
#include "{pkg}.h"
namespace {pkg}::srv {{
// Names the service for Client<> and Server<>.
struct {name} {{
  using Request = {name}_Request;
  using Response = {name}_Response;
  static constexpr const char* kName = "{pkg}/srv/{name}";
}};
}}  // namespace {pkg}::srv
"""

ACTION_HEADER = """#pragma once
#include "{pkg}.h"
namespace {pkg}::action {{
// Names the action for ActionClient<> and ActionServer<>.
struct {name} {{
  using Goal = {name}_Goal;
  using Result = {name}_Result;
  using Feedback = {name}_Feedback;
  using FeedbackMessage = {name}_FeedbackMessage;
  struct SendGoal {{
    using Request = {name}_SendGoal_Request;
    using Response = {name}_SendGoal_Response;
    static constexpr const char* kName = "{pkg}/action/{name}_SendGoal";
  }};
  struct GetResult {{
    using Request = {name}_GetResult_Request;
    using Response = {name}_GetResult_Response;
    static constexpr const char* kName = "{pkg}/action/{name}_GetResult";
  }};
  static constexpr const char* kName = "{pkg}/action/{name}";
}};
}}  // namespace {pkg}::action
"""


def interface_files(source):
    """{package: [file]}, sorted, so that the output never depends on the file system."""
    packages = {}
    for file in sorted(source.glob("*/*/*")):
        if file.suffix in (".msg", ".srv", ".action"):
            packages.setdefault(file.parts[-3], []).append(file)
    return packages


def in_order_of_use(bodies):
    """Sorts {name: (text, names it needs)} so that each comes after what it needs."""
    done, order = set(), []

    def visit(name):
        if name in done or name not in bodies:
            return
        done.add(name)
        for needed in sorted(bodies[name][1]):
            visit(needed)
        order.append(name)

    for name in sorted(bodies):
        visit(name)
    return order


def package_idl(source, work, pkg, files):
    """The text of one IDL file for all interfaces of a package."""
    bodies, includes, typedefs = {}, set(), set()
    for file in files:
        relative = file.relative_to(source / pkg)
        convert_to_idl(source / pkg, pkg, relative, work / pkg)
        text = (work / pkg / relative).with_suffix(".idl").read_text(encoding="iso-8859-1")
        needs = re.findall(r'#include "(\w+)/msg/(\w+)\.idl"', text)
        includes |= {p for p, _ in needs if p != pkg}
        text = KEYWORD_FIELDS.sub(r"\1_;", COMMENTS.sub("", text))
        body = "\n".join(line for line in text.splitlines() if not line.startswith(("#include", "//")))
        for typedef in re.findall(r"^ *typedef .*;$", body, re.M):
            if (file.parent.name, typedef) in typedefs:
                body = body.replace(typedef, "")
            typedefs.add((file.parent.name, typedef))
        if file.suffix == ".action":
            body += PROTOCOL_IDL.format(pkg=pkg, name=file.stem)
            includes |= {"unique_identifier_msgs", "builtin_interfaces"}
        key = file.stem if file.suffix == ".msg" else f"{file.parent.name}/{file.stem}"
        bodies[key] = (body, {t for p, t in needs if p == pkg})
    lines = [f"#ifndef {pkg}_idl", f"#define {pkg}_idl", *[f'#include "{p}.idl"' for p in sorted(includes)]]
    return "\n".join(lines + [bodies[name][0] for name in in_order_of_use(bodies)] + ["#endif"]) + "\n"


def write_if_changed(path, text):
    """Leaves an equal file alone, so that nothing is compiled again for nothing."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def write_user_headers(output, pkg, files):
    for file in files:
        folder, name = file.parent.name, file.stem
        write_if_changed(output / pkg / folder / f"{name}.h", f'#pragma once\n#include "{pkg}.h"\n')
        if file.suffix == ".srv":
            write_if_changed(output / pkg / folder / f"{name}_service.h",
                             SERVICE_HEADER.format(pkg=pkg, name=name))
        if file.suffix == ".action":
            write_if_changed(output / pkg / folder / f"{name}_action.h", ACTION_HEADER.format(pkg=pkg, name=name))


def run_fastddsgen(work, idl_files):
    """One call for all packages. Leaves the C++ in `work`."""
    # It preprocesses into the system's temporary folder under the files' names, where another build would
    # overwrite them.
    temporary = work / "preprocessed"
    temporary.mkdir(exist_ok=True)
    command = [shutil.which("fastddsgen") or "fastddsgen", "-cs", "-typeros2", "-replace", "-d", str(work), "-t",
               str(temporary), "-I", str(work), *[file.name for file in idl_files]]
    # Only a second of work: the quick compiler and a small heap start faster than the defaults.
    options = {**os.environ, "JAVA_TOOL_OPTIONS": "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC -Xshare:auto"}
    done = subprocess.run(command, cwd=work, capture_output=True, text=True, env=options)
    if done.returncode != 0 or "ERROR" in done.stdout + done.stderr:
        sys.exit(f"idl/generate.py: fastddsgen failed:\n{done.stdout}{done.stderr}")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    source, output = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    work = output / "work"
    work.mkdir(parents=True, exist_ok=True)
    packages = interface_files(source)
    idl_files = []
    for pkg, files in packages.items():
        idl_files.append(work / f"{pkg}.idl")
        idl_files[-1].write_text(package_idl(source, work, pkg, files), encoding="utf-8")
    run_fastddsgen(work, idl_files)
    for pkg, files in packages.items():
        for suffix in (".h", ".cxx"):
            text = (work / f"{pkg}{suffix}").read_text(encoding="utf-8")
            # Comments with Java object numbers differ from run to run and would defeat compiler caches.
            write_if_changed(output / f"{pkg}{suffix}", re.sub(r"// m_\w+ com\.eprosima.*", "", text))
        write_user_headers(output, pkg, files)
    types = type_descriptions.describe(packages)
    write_if_changed(output / "types.cc", type_descriptions.table(types))
    write_if_changed(output / "supports.cc", type_descriptions.support_table(packages))
    for pkg in packages:
        write_if_changed(output / f"{pkg}_support.cc", type_descriptions.support(types, pkg))


if __name__ == "__main__":
    main()
