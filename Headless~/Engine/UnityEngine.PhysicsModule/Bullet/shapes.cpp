// Shapes of colliders, in sizes that are scaled already.
#include "world.h"
#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>

Shape::~Shape()
{
    delete shape;
    delete edges;
    delete mesh;
}

// What Bullet rounds edges and corners by: a hundredth of the least half side, a millimeter at most.
static float marginOf(const btVector3& half) { return btMin(0.001f, 0.01f * half[half.minAxis()]); }

EXPORT Shape* rillShapeBox(Vec half)
{
    auto box = new btBoxShape(bt(half));
    box->setMargin(marginOf(bt(half)));
    box->initializePolyhedralFeatures();        // faces against triangles are clipped then, not probed point by point
    auto shape = new Shape;
    shape->shape = box;
    return shape;
}

EXPORT Shape* rillShapeSphere(float radius)
{
    auto shape = new Shape;
    shape->shape = new btSphereShape(radius);
    return shape;
}

// axis: 0 along x, 1 along y, 2 along z. half: from the center to the center of a cap.
EXPORT Shape* rillShapeCapsule(float radius, float half, int axis)
{
    auto shape = new Shape;
    shape->shape = axis == 0 ? static_cast<btCollisionShape*>(new btCapsuleShapeX(radius, 2 * half))
        : axis == 1 ? new btCapsuleShape(radius, 2 * half) : new btCapsuleShapeZ(radius, 2 * half);
    return shape;
}

// Bullet adds the margin around a hull.
EXPORT Shape* rillShapeHull(const float* points, int count)
{
    auto hull = new btConvexHullShape;
    for (int i = 0; i < count; i++)
        hull->addPoint(btVector3(points[3 * i], points[3 * i + 1], points[3 * i + 2]), false);
    hull->recalcLocalAabb();
    if (count > 32)
        hull->optimizeConvexHull();
    btVector3 low, high;
    hull->setMargin(0);
    hull->getAabb(btTransform::getIdentity(), low, high);
    hull->setMargin(marginOf((high - low) * 0.5f));
    hull->recalcLocalAabb();
    hull->initializePolyhedralFeatures();
    auto shape = new Shape;
    shape->shape = hull;
    return shape;
}

// Triangles of both sides, without margin.
EXPORT Shape* rillShapeMesh(const float* points, int pointCount, const int* indices, int indexCount)
{
    auto shape = new Shape;
    shape->vertices.assign(points, points + 3 * pointCount);
    shape->indices.assign(indices, indices + indexCount);
    shape->mesh = new btTriangleIndexVertexArray(indexCount / 3, shape->indices.data(), 3 * sizeof(int), pointCount,
        shape->vertices.data(), 3 * sizeof(float));
    auto mesh = new btBvhTriangleMeshShape(shape->mesh, true);
    mesh->setMargin(0);
    shape->edges = new btTriangleInfoMap;
    btGenerateInternalEdgeInfo(mesh, shape->edges);
    shape->shape = mesh;
    return shape;
}

EXPORT void rillShapeDelete(Shape* shape) { delete shape; }
