"""Type descriptions and RIHS01 hashes of ROS 2 interfaces, and the C++ tables that carry them."""
import dataclasses
import hashlib
import json

from rosidl_adapter import parser

# type_description_interfaces/msg/FieldType; .msg knows `char` as uint8 since ROS 2.
TYPE_IDS = {"int8": 2, "uint8": 3, "char": 3, "int16": 4, "uint16": 5, "int32": 6, "uint32": 7, "int64": 8,
            "uint64": 9, "float32": 10, "float64": 11, "bool": 15, "byte": 16, "string": 17, "wstring": 18}
NESTED, BOUNDED_STRING = 1, 21
ARRAY, BOUNDED_SEQUENCE, SEQUENCE = 48, 96, 144


@dataclasses.dataclass
class Field:
    name: str
    type_id: int
    capacity: int = 0
    string_capacity: int = 0
    nested: str = ""
    default: str = ""  # not part of the hash


@dataclasses.dataclass
class Type:
    name: str  # pkg/msg/T
    fields: list
    source: str = ""    # raw text of the file it was written in
    encoding: str = ""  # msg, srv, action; implicit where no file has it
    is_data: bool = True  # false for services and actions as a whole: nothing of that type is ever sent
    hash: str = ""


def default_text(value):
    """A default value as rosidl's type descriptions have it."""
    if value is None:
        return ""
    return f"({', '.join(str(element) for element in value)})" if isinstance(value, list) else str(value)


def parsed_field(field):
    kind = field.type
    if kind.is_primitive_type():
        type_id, nested = TYPE_IDS[kind.type], ""
        if kind.string_upper_bound:
            type_id = BOUNDED_STRING
    else:
        type_id, nested = NESTED, f"{kind.pkg_name}/msg/{kind.type}"
    capacity = 0
    if kind.is_array:
        type_id += ARRAY if kind.is_fixed_size_array() else BOUNDED_SEQUENCE if kind.is_upper_bound else SEQUENCE
        capacity = kind.array_size or 0
    return Field(field.name, type_id, capacity, kind.string_upper_bound or 0, nested,
                 default_text(field.default_value))


def structure(name, spec, source, encoding):
    fields = [parsed_field(f) for f in spec.fields]
    return Type(name, fields or [Field("structure_needs_at_least_one_member", 3)], source, encoding)


def nested_field(name, nested, extra=0, capacity=0):
    return Field(name, NESTED + extra, capacity, 0, nested)


def service(types, base, request, response):
    """Adds request, response, event and the service itself under the name `base`."""
    event = Type(f"{base}_Event", [
        nested_field("info", "service_msgs/msg/ServiceEventInfo"),
        nested_field("request", f"{base}_Request", BOUNDED_SEQUENCE, 1),
        nested_field("response", f"{base}_Response", BOUNDED_SEQUENCE, 1)], encoding="implicit", is_data=False)
    whole = Type(base, [nested_field(f"{part}_message", f"{base}_{part.capitalize()}")
                        for part in ("request", "response", "event")], is_data=False)
    whole.source, whole.encoding = request.source, request.encoding
    for part in (request, response):
        part.encoding = "implicit"
    for part in (request, response, event, whole):
        types[part.name] = part


def action(types, base, spec, source):
    for part, fields in (("Goal", spec.goal), ("Result", spec.result), ("Feedback", spec.feedback)):
        types[f"{base}_{part}"] = structure(f"{base}_{part}", fields, "", "implicit")
    goal_id = nested_field("goal_id", "unique_identifier_msgs/msg/UUID")
    service(types, f"{base}_SendGoal",
            Type(f"{base}_SendGoal_Request", [goal_id, nested_field("goal", f"{base}_Goal")], "", "implicit"),
            Type(f"{base}_SendGoal_Response",
                 [Field("accepted", 15), nested_field("stamp", "builtin_interfaces/msg/Time")], "", "implicit"))
    service(types, f"{base}_GetResult",
            Type(f"{base}_GetResult_Request", [goal_id], "", "implicit"),
            Type(f"{base}_GetResult_Response",
                 [Field("status", 2), nested_field("result", f"{base}_Result")], "", "implicit"))
    types[f"{base}_FeedbackMessage"] = Type(f"{base}_FeedbackMessage",
                                            [goal_id, nested_field("feedback", f"{base}_Feedback")], "", "implicit")
    parts = (("goal", "Goal"), ("result", "Result"), ("feedback", "Feedback"), ("send_goal_service", "SendGoal"),
             ("get_result_service", "GetResult"), ("feedback_message", "FeedbackMessage"))
    types[base] = Type(base, [nested_field(name, f"{base}_{part}") for name, part in parts], source, "action", False)


def describe(packages):
    """{name: Type} of all interfaces in {package: [file]}, hashes included."""
    types = {}
    for pkg, files in packages.items():
        for file in files:
            text, base = file.read_text(encoding="utf-8"), f"{pkg}/{file.parent.name}/{file.stem}"
            if file.suffix == ".msg":
                types[base] = structure(base, parser.parse_message_string(pkg, file.stem, text), text, "msg")
            elif file.suffix == ".srv":
                spec = parser.parse_service_string(pkg, file.stem, text)
                service(types, base, structure(f"{base}_Request", spec.request, text, "srv"),
                        structure(f"{base}_Response", spec.response, text, "srv"))
            else:
                action(types, base, parser.parse_action_string(pkg, file.stem, text), text)
    for kind in types.values():
        kind.hash = rihs01(types, kind)
    return types


def referenced(types, kind):
    """Names of all types that `kind` contains at any depth, sorted."""
    found, todo = set(), [kind]
    while todo:
        for field in todo.pop().fields:
            if field.nested and field.nested not in found:
                if field.nested not in types:
                    raise SystemExit(f"idl: {kind.name} uses {field.nested}, which idl/ does not have; add its file")
                found.add(field.nested)
                todo.append(types[field.nested])
    return sorted(found)


def as_json(kind):
    return {"type_name": kind.name, "fields": [
        {"name": f.name, "type": {"type_id": f.type_id, "capacity": f.capacity, "string_capacity": f.string_capacity,
                                  "nested_type_name": f.nested}} for f in kind.fields]}


def rihs01(types, kind):
    text = json.dumps({"type_description": as_json(kind),
                       "referenced_type_descriptions": [as_json(types[n]) for n in referenced(types, kind)]})
    return "RIHS01_" + hashlib.sha256(text.encode("utf-8")).hexdigest()


def c_string(text):
    return json.dumps(text, ensure_ascii=True) if len(text) < 400 else \
        "\n    ".join(json.dumps(line + "\n") for line in text.split("\n"))


def table(types):
    """types.cc: one row per type, sorted by name for binary search."""
    out = ['// Generated by idl/generate.py.', '#include "idl/type_description.h"', "",
           "namespace goalnet::idl {", "namespace {", ""]
    rows = []
    for index, (name, kind) in enumerate(sorted(types.items())):
        out.append(f"const FieldDescription kFields{index}[] = {{")
        out += [f'    {{"{f.name}", {f.type_id}, {f.capacity}, {f.string_capacity}, "{f.nested}", {json.dumps(f.default)}}},'
                for f in kind.fields]
        out.append("};")
        refs = ", ".join(f'"{n}"' for n in referenced(types, kind))
        out.append(f"const char* const kReferenced{index}[] = {{{refs + ', ' if refs else ''}nullptr}};")
        rows.append(f'    {{"{name}", "{kind.hash}", kFields{index}, {len(kind.fields)}, kReferenced{index}, '
                    f'"{kind.encoding}", {c_string(kind.source)}}},')
    out += ["", "const TypeDescription kTypes[] = {", *rows, "};", "", "}  // namespace", "",
            "std::span<const TypeDescription> all_types() { return kTypes; }", "", "}  // namespace goalnet::idl", ""]
    return "\n".join(out)


def support(types, pkg):
    """PKG_support.cc: instantiates type_support<> for every type of the package that is sent."""
    names = [name for name, kind in sorted(types.items()) if kind.is_data and name.startswith(pkg + "/")]
    out = ['// Generated by idl/generate.py.', f'#include "{pkg}.h"', '#include "idl/type_support_impl.h"', "",
           "namespace goalnet::idl {"]
    for name in names:
        package, folder, type_name = name.split("/")
        cpp = "::" + name.replace("/", "::")
        out.append(f'template <>\nstruct NameOf<{cpp}> {{\n  static constexpr const char* kRos = "{name}";\n'
                   f'  static constexpr const char* kDds = "{package}::{folder}::dds_::{type_name}_";\n}};')
        out.append(f"template const TypeSupport& type_support<{cpp}>();")
    listed = ", ".join(f"&type_support<::{name.replace('/', '::')}>()" for name in names)
    out += [f"std::vector<const TypeSupport*> supports_of_{pkg}() {{ return {{{listed}}}; }}", "}  // namespace goalnet::idl", ""]
    return "\n".join(out)


def support_table(packages):
    """supports.cc: finds the TypeSupport of a name that is only known when running."""
    out = ["// Generated by idl/generate.py.", "#include <map>", "#include <string>", "#include <vector>",
           '#include "idl/type_support.h"', "", "namespace goalnet::idl {"]
    out += [f"std::vector<const TypeSupport*> supports_of_{pkg}();" for pkg in packages]
    out += ["const TypeSupport* find_type_support(std::string_view name) {",
            "  static const auto table = [] {", "    std::map<std::string, const TypeSupport*, std::less<>> all;"]
    out += [f"    for (const auto* one : supports_of_{pkg}()) all[one->ros_name] = one;" for pkg in packages]
    out += ["    return all;", "  }();", "  const auto found = table.find(name);",
            "  return found == table.end() ? nullptr : found->second;", "}", "}  // namespace goalnet::idl", ""]
    return "\n".join(out)
