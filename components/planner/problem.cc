#include "components/planner/problem.h"

namespace goalnet::planner {

std::string Problem::object_name(ObjectId id) const {
  const std::int32_t constants = domain_->constants.size();
  return id < constants ? domain_->constants.name(id) : objects_.name(id - constants);
}

ObjectId Problem::find_object(std::string_view object_name) const {
  const ObjectId id = domain_->constants.find(object_name);
  if (id != SymbolTable::kNone) return id;
  const ObjectId own = objects_.find(object_name);
  return own == SymbolTable::kNone ? own : own + domain_->constants.size();
}

std::vector<std::string> Problem::first_object_names() const {
  std::vector<std::string> names;
  for (ObjectId id = 0; id < object_count() && names.size() < kMostNames; ++id) {
    if (present(id)) names.push_back(object_name(id));
  }
  return names;
}

ObjectId Problem::add_object(std::string_view object_name, TypeId type) {
  const ObjectId id = objects_.add(object_name) + domain_->constants.size();
  if (id == object_count()) {
    object_types_.push_back(type);
    present_.push_back(1);
  }
  return id;
}

void Problem::restart() {
  name.clear();
  initial.clear();
  cost_atoms.clear();
  cost_values.clear();
  goal = Formula{};
  arena_.clear();
  goal_slots.clear();
  minimise_cost = false;
  objects_.clear();
  object_types_.clear();
  present_.clear();
  for (const TypeId type : domain_->constant_types) {
    object_types_.push_back(type);
    present_.push_back(1);
  }
}

}  // namespace goalnet::planner
