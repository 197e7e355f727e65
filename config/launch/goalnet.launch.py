"""All components of goalnet for `ros2 launch`; they need no ROS package besides launch itself.

    ros2 launch config/launch/goalnet.launch.py scene:=living_room
    ros2 launch config/launch/goalnet.launch.py namespace:=/robot1 seed:=2

`goalnet` must be in PATH, or be given by program:=/path/to/goalnet.
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, EmitEvent, ExecuteProcess, OpaqueFunction, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.events import Shutdown
from launch.substitutions import LaunchConfiguration

ARGUMENTS = {
    "program": ("goalnet", "the goalnet command"),
    "namespace": ("/", "of all nodes and topics; two robots on one network have one each"),
    "scene": ("kitchen", "a name in config/scenes or a file"),
    "robot": ("default", "a name in config/robots or a file"),
    "model": ("goalnet", "a name in config/models or a file"),
    "seed": ("1", "where things stand"),
    "simulator": ("true", "false: a real robot and its perception are there"),
    "use_sim_time": ("true", "follow /clock; with simulator:=false usually false"),
    "autostart": ("true", "false: a lifecycle manager configures and activates the nodes"),
    "distro": ("", "whose conventions on the wire are followed: humble or jazzy; empty: ROS_DISTRO's"),
    "log_level": ("info", "debug, info, warn, error or fatal"),
    "params_file": ("", "YAML file with parameters of any of the nodes"),
}

# Which of the arguments are parameters of which component.
COMPONENTS = {
    "simulator": ["scene", "robot", "seed"],
    "executor": ["robot"],
    "world_model": ["scene", "robot"],
    "goalnet": ["model"],
    "planner": [],
    "manipulation": ["scene", "robot"],
    "coordinator": [],
    "visualization": ["scene", "robot"],
}


def command_of(component, given):
    """The words of one component's process."""
    words = [given["program"], "component", component, "--ros-args", "--log-level", given["log_level"]]
    if given["namespace"] not in ("", "/"):
        words += ["-r", "__ns:=" + given["namespace"]]
        # Transforms carry the same frame names for every robot.
        words += ["-r", "/tf:=tf", "-r", "/tf_static:=tf_static"]
    if given["params_file"]:
        words += ["--params-file", given["params_file"]]
    parameters = {name: given[name] for name in COMPONENTS[component] + ["autostart"]}
    if component != "simulator":
        parameters["use_sim_time"] = given["use_sim_time"]
    for name, value in parameters.items():
        words += ["-p", name + ":=" + value]
    return words


def processes(context):
    given = {name: LaunchConfiguration(name).perform(context) for name in ARGUMENTS}
    actions = []
    for component in COMPONENTS:
        if component == "simulator" and given["simulator"] != "true":
            continue
        lost = component == "simulator"  # time and the robot's body: nothing to go on with
        process = ExecuteProcess(
            cmd=command_of(component, given),
            name=component,
            output="screen",
            additional_env={"GOALNET_ROS_DISTRO": given["distro"]} if given["distro"] else {},
            respawn=not lost,
            respawn_delay=2.0,
            sigterm_timeout="5",
        )
        actions.append(process)
        if lost:
            actions.append(RegisterEventHandler(OnProcessExit(
                target_action=process, on_exit=[EmitEvent(event=Shutdown(reason="the simulator has ended"))])))
    return actions


def generate_launch_description():
    declared = [
        DeclareLaunchArgument(name, default_value=default, description=description)
        for name, (default, description) in ARGUMENTS.items()
    ]
    return LaunchDescription(declared + [OpaqueFunction(function=processes)])
