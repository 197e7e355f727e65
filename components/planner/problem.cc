#include "components/planner/problem.h"

namespace goalnet::planner {

const std::string& Problem::object_name(ObjectId id) const {
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

void Problem::reserve_objects(std::size_t more) {
  objects_.reserve(more);
  object_types_.reserve(object_types_.size() + more);
  present_.reserve(present_.size() + more);
}

void Problem::restart() {
  name.clear();
  initial.clear();
  cost_atoms.clear();
  cost_values.clear();
  goal = Formula{};
  goal_slots.clear();
  minimise_cost = false;
  objects_.clear();
  object_types_ = domain_->constant_types;
  present_.assign(object_types_.size(), 1);
}

}  // namespace goalnet::planner
