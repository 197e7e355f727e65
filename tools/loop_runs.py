"""One run of `goalnet run --json` and its judgement: shared by tools/acceptance and tools/survey."""
import json
import subprocess
import time


def run(program, room, arguments, seed):
    """Returns the run's JSON object with `exit_code` added. A run that prints none says so in its outcome."""
    command = [str(program), "run", "--json", "--private", "--scene", room, "--seed", str(seed)] + arguments
    started = time.monotonic()
    done = subprocess.run(command, capture_output=True, text=True, timeout=900, check=False)
    try:
        result = json.loads(done.stdout)
    except json.JSONDecodeError:
        result = {"outcome": f"exit {done.returncode}", "message": done.stderr.strip()[-300:], "facts": [],
                  "sim_time_s": 0.0, "wall_time_s": time.monotonic() - started, "steps": []}
    result["exit_code"] = done.returncode
    return result


def goal_arguments(goal):
    return [word for fact in goal for word in ("--goal", fact)]


def judge(result, alternatives):
    """Whether the run ended well and one of the alternatives, each a list of facts, holds at its end."""
    facts = set(result["facts"])

    def holds(fact):
        return fact[4:] not in facts if fact.startswith("not ") else fact in facts

    return result["exit_code"] == 0 and any(all(map(holds, a)) for a in alternatives)
