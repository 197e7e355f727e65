"""The ROS 2 launch file, carried out with a stand-in for the `launch` package that notes what it is given."""
import importlib.util
import pathlib
import sys
import types

ROOT = pathlib.Path(__file__).resolve().parents[3]


class Noted:
    """Any class of `launch`: keeps its arguments."""

    def __init__(self, *args, **kwargs):
        self.args = args
        self.__dict__.update(kwargs)


class LaunchConfiguration(Noted):
    def perform(self, context):
        return context[self.args[0]]


def stand_in():
    modules = {
        "launch": ["LaunchDescription"],
        "launch.actions": ["DeclareLaunchArgument", "EmitEvent", "ExecuteProcess", "OpaqueFunction",
                           "RegisterEventHandler"],
        "launch.event_handlers": ["OnProcessExit"],
        "launch.events": ["Shutdown"],
        "launch.substitutions": [],
    }
    for name, classes in modules.items():
        module = types.ModuleType(name)
        for one in classes:
            setattr(module, one, type(one, (Noted,), {}))
        sys.modules[name] = module
    sys.modules["launch.substitutions"].LaunchConfiguration = LaunchConfiguration


def commands(description, **given):
    declared, function = {}, None
    for action in description.args[0]:
        if type(action).__name__ == "DeclareLaunchArgument":
            assert action.description, action.args
            declared[action.args[0]] = action.default_value
        else:
            function = action.function
    unknown = set(given) - set(declared)
    assert not unknown, unknown
    context = {**declared, **given}
    return [a for a in function(context) if type(a).__name__ == "ExecuteProcess"]


def main():
    stand_in()
    path = ROOT / "config" / "launch" / "goalnet.launch.py"
    spec = importlib.util.spec_from_file_location("goalnet_launch", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    description = module.generate_launch_description()

    every = commands(description)
    assert [p.name for p in every] == ["simulator", "executor", "world_model", "goalnet", "planner", "manipulation",
                                       "coordinator", "visualization"], every
    simulator = every[0]
    assert simulator.cmd[:4] == ["goalnet", "component", "simulator", "--ros-args"], simulator.cmd
    assert "scene:=kitchen" in simulator.cmd and "__ns:=/" not in simulator.cmd, simulator.cmd
    assert not any(word.startswith("use_sim_time") for word in simulator.cmd), simulator.cmd
    assert all("use_sim_time:=true" in p.cmd for p in every[1:])
    assert not simulator.respawn and all(p.respawn for p in every[1:])
    assert simulator.additional_env == {}, "ROS_DISTRO of the shell decides"

    real = commands(description, simulator="false", use_sim_time="false", namespace="/robot1", distro="humble",
                    params_file="p.yaml", program="/opt/goalnet")
    assert [p.name for p in real][0] == "executor" and len(real) == 7
    for process in real:
        words = process.cmd
        assert words[0] == "/opt/goalnet"
        assert words[words.index("__ns:=/robot1") - 1] == "-r", words
        assert words[words.index("p.yaml") - 1] == "--params-file", words
        assert "use_sim_time:=false" in words and "/tf:=tf" in words
        assert process.additional_env == {"GOALNET_ROS_DISTRO": "humble"}


if __name__ == "__main__":
    main()
