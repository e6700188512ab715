namespace UnityEngine.Headless
{
    /// <summary>When the player's loop has the default physics scene stepped and shown.</summary>
    internal sealed class PhysicsTurns : PhysicsLoop
    {
        public override void BeginFixedStep()
        {
            if (PhysicsWorld.Stepped == PhysicsStepping.FixedUpdate)
                PhysicsWorld.BeginStep();
        }

        public override void FixedStep()
        {
            if (PhysicsWorld.Stepped == PhysicsStepping.FixedUpdate)
                PhysicsWorld.Step(null, Time.fixedDeltaTime);
        }

        public override void BeginUpdate()
        {
            if (PhysicsWorld.Stepped == PhysicsStepping.FixedUpdate)
                PhysicsWorld.Show(Time.Clock.StepFraction);
            else if (PhysicsWorld.Stepped == PhysicsStepping.Update && Time.deltaTime > 0f)
                PhysicsWorld.Step(null, Time.deltaTime);
        }

        // Cylinders get a capsule, planes and quads their mesh.
        public override void AddCollider(GameObject primitive, PrimitiveType type)
        {
            switch (type)
            {
                case PrimitiveType.Sphere: primitive.AddComponent<SphereCollider>(); break;
                case PrimitiveType.Capsule:
                case PrimitiveType.Cylinder: primitive.AddComponent<CapsuleCollider>(); break;
                case PrimitiveType.Cube: primitive.AddComponent<BoxCollider>(); break;
                default: primitive.AddComponent<MeshCollider>().sharedMesh = primitive.GetComponent<MeshFilter>().sharedMesh; break;
            }
        }

        public override void Reset() => PhysicsWorld.Reset();
    }
}
