#include "components/visualization/text_drawing.h"

#include <algorithm>

namespace goalnet::visualization {
namespace {

constexpr double kFactHeight = 0.035, kGoalHeight = 0.05, kTaskHeight = 0.09;  // [m] of a capital letter
constexpr double kLine = 1.25;                                                 // lines are this much apart
constexpr double kTaskPlace = 2.5;                                             // [m] above the floor
constexpr std::size_t kLongestText = 2000;  // what a hostile message can make us draw

constexpr std::array<float, 4> kFactColor = {1.0f, 1.0f, 1.0f, 0.9f};
constexpr std::array<float, 4> kReached = {0.2f, 0.9f, 0.3f, 1.0f};
constexpr std::array<float, 4> kOpen = {1.0f, 0.6f, 0.1f, 1.0f};
constexpr std::array<float, 4> kTaskColor = {1.0f, 1.0f, 1.0f, 1.0f};

bool worth_showing(const Predicate& fact) {
  return fact.relation != "Near" && !fact.relation.starts_with("Is");
}

// "On Sink", "Water": what stands above its subject need not name it.
std::string short_text(const Predicate& fact) {
  if (fact.relation == "state") return fact.object;
  return fact.object.empty() ? fact.relation : fact.relation + " " + fact.object;
}

// Viewers centre a text on its position; it is to stand on `foot`.
Drawing text_at(const Eigen::Vector3d& foot, double height, const std::array<float, 4>& color,
                std::string text) {
  if (text.size() > kLongestText) {
    std::size_t end = kLongestText;  // at the start of a character: viewers may not survive half of one
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;
    text.resize(end);
  }
  const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
  Drawing drawing;
  drawing.kind = DrawingKind::kText;
  drawing.size.z() = height;
  drawing.color = color;
  drawing.pose.translation() =
      foot + Eigen::Vector3d(0, 0, height * (0.5 + 0.5 * kLine * static_cast<double>(lines)));
  drawing.text = std::move(text);
  return drawing;
}

std::string lines_about(const std::string& name, const FactSet& facts) {
  std::string text;
  for (const Predicate& fact : facts) {
    if (fact.subject == name && worth_showing(fact)) text += (text.empty() ? "" : "\n") + short_text(fact);
  }
  return text;
}

double lines_of(const std::string& text) {
  return text.empty() ? 0.0 : 1.0 + static_cast<double>(std::count(text.begin(), text.end(), '\n'));
}

std::string task_text(const FactSet& facts, const Task& task) {
  std::string text = task.instruction.empty() ? "" : "\"" + task.instruction + "\"\n";
  text += task.stage;
  if (task.finished && !task.message.empty()) text += ": " + task.message;
  for (const Action& action : task.plan)
    text += (action == task.current ? "\n> " : "\n  ") + to_string(action);
  if (const std::string robot = lines_about("Robot", facts); !robot.empty()) text += "\nRobot: " + robot;
  return text;
}

}  // namespace

void draw_facts(const scene::Scene& scene, const Poses& poses, const FactSet& facts,
                std::vector<Drawing>& out) {
  for (std::size_t i = 0; i < scene.symbols.size(); ++i) {
    const std::string& name = scene.symbols[i];
    Eigen::Vector3d place;
    const std::string text = lines_about(name, facts);
    if (text.empty() || !place_above(scene, poses, name, place)) continue;
    Drawing drawing = text_at(place, kFactHeight, kFactColor, text);
    drawing.group = "facts";
    drawing.id = static_cast<std::int32_t>(i);
    out.push_back(std::move(drawing));
  }
}

void draw_task(const scene::Scene& scene, const Poses& poses, const FactSet& facts, const Task& task,
               std::vector<Drawing>& out) {
  std::map<std::string, double> height;  // [m] already written on above each subject
  std::int32_t id = 0;
  const auto draw_goal = [&](const Predicate& predicate, bool wanted) {
    const std::int32_t its_id = id++;
    Eigen::Vector3d place;
    if (!place_above(scene, poses, predicate.subject, place)) return;
    const auto [used, is_new] = height.try_emplace(
        predicate.subject, kFactHeight * kLine * lines_of(lines_about(predicate.subject, facts)));
    place.z() += used->second;
    used->second += kGoalHeight * kLine;
    Drawing drawing = text_at(place, kGoalHeight, facts.contains(predicate) == wanted ? kReached : kOpen,
                              (wanted ? "goal: " : "goal: not ") + short_text(predicate));
    drawing.group = "goals";
    drawing.id = its_id;
    out.push_back(std::move(drawing));
  };
  for (const Predicate& predicate : task.goal.positive) draw_goal(predicate, true);
  for (const Predicate& predicate : task.goal.negative) draw_goal(predicate, false);
  const std::string text = task_text(facts, task);
  if (text.empty()) return;
  const Eigen::Vector3d middle(0.5 * (scene.floor_x_min + scene.floor_x_max),
                               0.5 * (scene.floor_y_min + scene.floor_y_max), kTaskPlace);
  Drawing drawing = text_at(middle, kTaskHeight, kTaskColor, text);
  drawing.group = "task";
  drawing.id = 0;
  out.push_back(std::move(drawing));
}

}  // namespace goalnet::visualization
