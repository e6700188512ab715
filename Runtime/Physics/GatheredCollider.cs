using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>A collider of Unity's physics as one fluid sees it, sized by the rules of the physics.</summary>
    sealed class GatheredCollider : IFluidCollider
    {
        readonly FluidPhysicsColliders source;
        readonly IColliderGround ground;        // null for none
        ColliderTransform placement = ColliderTransform.Origin;
        FluidForce force;
        ContactWatch watch;
        bool hasForce, isDropped, problemIsKnown, leftOutIsKnown;

        public GatheredCollider(FluidPhysicsColliders source, Collider collider)
        {
            this.source = source;
            Collider = collider;
            ground = ColliderGround.Of(collider);
        }

        public Collider Collider { get; }

        /// <summary>Number of the last query that found it.</summary>
        public int Round { get; set; }

        /// <summary>Field of the mesh; null for the other shapes.</summary>
        public SignedDistanceField Field { get; private set; }

        public string Name => Collider.name;

        public bool IsAlive => !isDropped && Collider != null && Collider.enabled && Collider.gameObject.activeInHierarchy;

        public int Teleports => 0;

        public bool MeasuresForce => Floats || source.ListensToContacts;

        /// <summary>Whether the fluid carries its Rigidbody.</summary>
        public bool Floats { get; set; }

        public bool IsCarried => Floats;

        /// <summary>The fluid drops it; it counts as one that is gone.</summary>
        public void Drop()
        {
            isDropped = true;
            ground?.Dispose();
        }

        /// <summary>Parts that hold no water where they should, or too much; null for none.</summary>
        public string LeftOut => ground?.LeftOut;

        /// <summary>Its Rigidbody, where that is free and the collider is of one of these layers; null else.</summary>
        public Rigidbody FreeBody(LayerMask floatingLayers)
        {
            if ((floatingLayers & 1 << Collider.gameObject.layer) == 0)
                return null;
            Rigidbody body = Collider.attachedRigidbody;
            return body != null && !body.isKinematic ? body : null;
        }

        /// <summary>Adds it to its body as one of the parts, with what the fluid did to it.</summary>
        public void AddTo(FloatingBody body)
        {
            if (!TryDescribe(out ColliderMotion shape))
                return;
            float volume = FloatingBody.VolumeOf(shape, Field);
            if (!(volume > 0f))
                return;
            var part = new BodyPart { collider = this, shape = shape, field = Field, volume = volume };
            body.AddPart(part);
            if (hasForce)
                body.Add(part, force);
            else if (AwaitsForce)
                body.Await(source.Fluid);
        }

        public bool TryDescribe(out ColliderMotion motion)
        {
            motion = default;
            if (!IsAlive)
                return false;
            string problem = Describe(out motion);
            if (problem != null && !problemIsKnown)
                Debug.LogError($"Rill: FluidPhysicsColliders '{source.name}' leaves out the collider '{Name}': {problem}", Collider);
            problemIsKnown = problem != null;
            LogLeftOut();
            return problem == null;
        }

        public string Describe(out ColliderMotion motion)
        {
            motion = new ColliderMotion
            {
                friction = source.Friction, bounciness = source.Bounciness,
                contributesDensity = source.ContributesDensity, reacts = MeasuresForce,
                tellsWettedArea = source.ListensToContacts
            };
            string problem = placement.Follow(Collider.transform);
            var pose = new RigidPose(placement.position, placement.rotation);
            float3 scale = placement.scale;
            Field = null;
            switch (Collider)
            {
                case BoxCollider box:
                    motion.shape = ColliderShape.Box;
                    motion.size = 0.5f * (float3)box.size * scale;
                    pose.position = placement.PointOf(box.center);
                    problem ??= HasSize(math.cmin(motion.size));
                    break;
                case SphereCollider sphere:
                    motion.shape = ColliderShape.Sphere;
                    motion.size = sphere.radius * placement.EvenScale;
                    pose.position = placement.PointOf(sphere.center);
                    problem ??= HasSize(motion.size.x);
                    break;
                case CapsuleCollider capsule:
                    pose.position = placement.PointOf(capsule.center);
                    pose.rotation = math.mul(placement.rotation, FromY(capsule.direction));
                    problem ??= DescribeCapsule(ref motion, capsule.radius, capsule.height, capsule.direction);
                    break;
                case CharacterController character:     // upright, however its object is turned
                    pose.position = placement.PointOf(character.center);
                    pose.rotation = quaternion.identity;
                    problem ??= DescribeCapsule(ref motion, character.radius, character.height, 1);
                    break;
                case MeshCollider mesh:
                    Field = source.FieldOf(mesh.sharedMesh);
                    problem ??= Field == null ? "its mesh has no signed distance field. Bake one and add both to Mesh Fields, " +
                        "which Bake Missing Fields... does for what is near the box, or take the object out of Collider Layers."
                        : placement.DescribeField(Field, ref motion, ref pose);
                    break;
                case Collider _ when ground != null:
                    problem ??= DescribeGround(ref motion, ref pose);
                    break;
                default:
                    problem ??= "water takes no collider of this kind. Put a Fluid Collider on the object, or take it out of Collider Layers.";
                    break;
            }
            problem ??= FieldAtlas.DeviceProblem(motion.shape);
            motion.start = motion.end = pose;
            return problem;
        }

        /// <summary>Whether the fluid sums a first force.</summary>
        public bool AwaitsForce { get; private set; }

        public void AwaitForce(FluidSimulation fluid) => AwaitsForce = true;

        public void SetForce(in FluidForce newest)
        {
            AwaitsForce = false;
            force = newest;
            hasForce = true;
        }

        public void RaiseContacts(FluidSimulation fluid)
        {
            if (!source.ListensToContacts)
                return;
            ContactChange change = watch.Follow(force.Impulse.magnitude, force.Duration, source.HitImpulse);
            source.Raise(change, new FluidContact(Collider, force, watch.Follow(force.Wetted, Collider.transform.position)));
        }

        public bool Leave(FluidSimulation fluid)
        {
            bool touched = watch.Touches && source.ListensToContacts;
            hasForce = AwaitsForce = false;
            watch = default;
            return touched;
        }

        public void SaveForce(FluidSimulation fluid, ref ForceRecord record)
        {
            record.flags |= AwaitsForce ? ForceRecord.Awaits : 0;
            if (hasForce)
                record.Set(force, watch);
        }

        public void LoadForce(FluidSimulation fluid, in ForceRecord record, Vector3 moved)
        {
            hasForce = record.Has(ForceRecord.HasForce);
            if (hasForce)
                force = record.ForceFrom(fluid, moved);
            watch = ContactWatch.Of(record);
            AwaitsForce = record.Has(ForceRecord.Awaits);
        }

        public void RaiseExit(FluidSimulation fluid)
        {
            if (Collider != null)       // destroyed since
                source.Raise(ContactChange.Exit, FluidContact.Exit(Collider, fluid));
        }

        // The height follows the scale along it, the radius the larger of the other two.
        string DescribeCapsule(ref ColliderMotion motion, float radius, float height, int direction)
        {
            float scaled = radius * math.max(placement.scale[(direction + 1) % 3], placement.scale[(direction + 2) % 3]);
            motion.shape = ColliderShape.Capsule;
            motion.size = new float3(scaled, math.max(0.5f * height * placement.scale[direction] - scaled, 0f), 0f);
            return HasSize(scaled);
        }

        string DescribeGround(ref ColliderMotion motion, ref RigidPose pose)
        {
            HeightField heights = ground.GetHeights(out string problem);
            if (problem == null)
                placement.DescribeHeights(heights, ref motion, ref pose);
            return problem;
        }

        void LogLeftOut()
        {
            string leftOut = LeftOut;
            if (leftOut != null && !leftOutIsKnown)
                Debug.LogWarning($"Rill: FluidPhysicsColliders '{source.name}', collider '{Name}': {leftOut}", Collider);
            leftOutIsKnown = leftOut != null;
        }

        // Turns the y axis to another, by thirds of a turn.
        static quaternion FromY(int axis)
        {
            return axis == 0 ? new quaternion(-0.5f, -0.5f, -0.5f, 0.5f) : axis == 2 ? new quaternion(0.5f, 0.5f, 0.5f, 0.5f) : quaternion.identity;
        }

        static string HasSize(float size) => size > 0f && !float.IsInfinity(size) ? null
            : "its size or scale is 0 along an axis, or not finite. Set both above 0.";
    }
}
