// What belongs together when Bullet decides what may sleep: only things that touch. Bullet itself also unites
// things whose bounding boxes overlap, so that everything under the robot's outstretched arms stays awake and
// is solved for.
#pragma once

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>

namespace goalnet::sim {

class ContactIslands : public btSimulationIslandManager {
 public:
  void updateActivationState(btCollisionWorld* world, btDispatcher* dispatcher) override;
};

// A world that uses them.
class ContactIslandWorld : public btMultiBodyDynamicsWorld {
 public:
  ContactIslandWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase,
                     btMultiBodyConstraintSolver* solver, btCollisionConfiguration* configuration);
};

}  // namespace goalnet::sim
