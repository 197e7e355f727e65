#!/usr/bin/python3
"""goalnet_msgs as colcon sees it, as far as that can be tested without ROS 2: interface_package_test.py SOURCE_DIR

The manifest and the CMakeLists name every file and every package, rosidl parses everything, and every field is explained."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

from rosidl_adapter import convert_to_idl
from rosidl_parser.parser import parse_idl_file
from rosidl_parser.definition import IdlLocator

ROOT = pathlib.Path(sys.argv.pop()).resolve()
IDL = ROOT / "idl"
PACKAGE = IDL / "goalnet_msgs"
FILES = sorted(str(path.relative_to(PACKAGE)) for path in PACKAGE.glob("*/*")
               if path.suffix in (".msg", ".srv", ".action"))

# Stands in for ament_cmake and rosidl_default_generators: writes down what the CMakeLists asks of them.
STUB = """
macro(ament_package)
  file(APPEND ${CMAKE_BINARY_DIR}/asked "ament_package\\n")
endmacro()
macro(ament_export_dependencies)
  file(APPEND ${CMAKE_BINARY_DIR}/asked "export ${ARGN}\\n")
endmacro()
macro(rosidl_generate_interfaces target)
  cmake_parse_arguments(_ARG "ADD_LINTER_TESTS;SKIP_INSTALL;SKIP_GROUP_MEMBERSHIP_CHECK" "LIBRARY_NAME" "DEPENDENCIES" ${ARGN})
  file(APPEND ${CMAKE_BINARY_DIR}/asked "target ${target}\\nfiles ${_ARG_UNPARSED_ARGUMENTS}\\ndependencies ${_ARG_DEPENDENCIES}\\n")
endmacro()
"""


def lines_with_fields(path):
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.lstrip().startswith("#") and line.strip() != "---":
            yield line


def packages_used():
    used = set()
    for name in FILES:
        for line in lines_with_fields(PACKAGE / name):
            match = re.match(r"(\w+)/\w+", line.strip())
            if match:
                used.add(match.group(1))
        if name.endswith(".action"):
            used.add("action_msgs")  # what an action's goals and status are made of
    return used


class InterfacePackage(unittest.TestCase):
    def test_manifest(self):
        package = xml.etree.ElementTree.parse(PACKAGE / "package.xml").getroot()
        texts = lambda tag: [element.text for element in package.findall(tag)]
        self.assertEqual(package.get("format"), "3")
        self.assertEqual(texts("name"), ["goalnet_msgs"])
        self.assertRegex(texts("version")[0], r"^\d+\.\d+\.\d+$")
        for needed in ("description", "license"):
            self.assertTrue(texts(needed)[0].strip())
        self.assertRegex(package.find("maintainer").get("email"), r"^\S+@\S+\.\S+$")
        self.assertEqual(set(texts("buildtool_depend")), {"ament_cmake", "rosidl_default_generators"})
        self.assertEqual(set(texts("depend")), packages_used())
        self.assertEqual(texts("exec_depend"), ["rosidl_default_runtime"])
        self.assertEqual(texts("member_of_group"), ["rosidl_interface_packages"])
        self.assertEqual(package.find("export/build_type").text, "ament_cmake")

    def test_cmake_lists_everything(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            for package in {"ament_cmake", "rosidl_default_generators"} | packages_used():
                (folder / package).mkdir()
                (folder / package / f"{package}Config.cmake").write_text(STUB if package == "ament_cmake" else "")
            subprocess.run(["cmake", "-S", PACKAGE, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={folder}"], check=True,
                           capture_output=True, text=True)
            asked = dict(line.partition(" ")[::2] for line in (folder / "build/asked").read_text().splitlines())
        self.assertEqual(asked["target"], "goalnet_msgs")
        self.assertEqual(sorted(asked["files"].split(";")), FILES)
        self.assertEqual(set(asked["dependencies"].split(";")), packages_used())
        self.assertEqual(asked["export"], "rosidl_default_runtime")
        self.assertIn("ament_package", asked)

    def test_rosidl_parses_every_file(self):
        self.assertGreaterEqual(len(FILES), 15)
        with tempfile.TemporaryDirectory() as folder:
            for name in FILES:
                relative = pathlib.Path(name)
                convert_to_idl(PACKAGE, "goalnet_msgs", relative, pathlib.Path(folder))
                parsed = parse_idl_file(IdlLocator(folder, relative.with_suffix(".idl")))
                self.assertTrue(parsed.content.elements, name)

    def test_every_field_is_explained(self):
        for name in FILES:
            for line in lines_with_fields(PACKAGE / name):
                _, mark, comment = line.partition("#")
                self.assertTrue(mark and len(comment.strip()) >= 2, f"{name}: {line}")

    def test_packages_used_are_there(self):
        for package in packages_used():
            self.assertTrue((IDL / package).is_dir(), package)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
