#include "sim/contact_islands.h"

#include <new>

namespace goalnet::sim {

void ContactIslands::updateActivationState(btCollisionWorld* world, btDispatcher* dispatcher) {
  int index = 0;
  const btCollisionObjectArray& objects = world->getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    if (!objects[i]->isStaticOrKinematicObject()) objects[i]->setIslandTag(index++);
    objects[i]->setCompanionId(-1);
    objects[i]->setHitFraction(btScalar(1));
  }
  initUnionFind(index);
  for (int m = 0; m < dispatcher->getNumManifolds(); ++m) {
    const btPersistentManifold* manifold = dispatcher->getManifoldByIndexInternal(m);
    if (manifold->getNumContacts() == 0) continue;
    const btCollisionObject* a = manifold->getBody0();
    const btCollisionObject* b = manifold->getBody1();
    if (a->mergesSimulationIslands() && b->mergesSimulationIslands())
      getUnionFind().unite(a->getIslandTag(), b->getIslandTag());
  }
}

ContactIslandWorld::ContactIslandWorld(btDispatcher* dispatcher, btBroadphaseInterface* broadphase,
                                       btMultiBodyConstraintSolver* solver,
                                       btCollisionConfiguration* configuration)
    : btMultiBodyDynamicsWorld(dispatcher, broadphase, solver, configuration) {
  // The base class makes its own in aligned memory and frees what it finds there in the end.
  m_islandManager->~btSimulationIslandManager();
  btAlignedFree(m_islandManager);
  m_islandManager = new (btAlignedAlloc(sizeof(ContactIslands), 16)) ContactIslands();
}

}  // namespace goalnet::sim
