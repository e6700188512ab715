using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Solid colliders: ends paths at surfaces, keeps the particles outside, and adds what lies behind a surface to the density.
    /// Made when first needed.</summary>
    sealed class Colliders : Stage
    {
        const float SmallestCell = 4f;          // d
        const int MaxCells = 1 << 17;
        const int WordBits = 32;

        /// <summary>a particle's center stays this far from a wall, d</summary>
        [GenerateHlsl("Solver")] public const float ContactOffset = 0.5f;

        /// <summary>Keyword of the kernels that know of meshes that deform.</summary>
        public const string DeformingKeyword = "RILL_DEFORMING";

        /// <summary>threads that measure how much of a cell is solid</summary>
        [GenerateHlsl("Colliders")] const int VolumeLanes = 16;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Colliders");

        /// <summary>Measures at rest what the colliders add; the statistics list it among their kernels.</summary>
        public readonly Kernel FindBoundary;

        readonly ComputeShader shader = StageShader.LoadCompute("Colliders");
        readonly Kernel binColliders, measureColliderVolume, measureWettedArea;
        readonly KernelVariants collidePaths, collide, collideWithTension;        // with reactions; last pass, with reactions
        readonly Kernel collidePathsReactWithMaterials;
        readonly KernelVariants collideReactWithMaterials;      // last pass
        readonly KernelVariants collideWithTensionAndMaterials;     // last pass, with reactions
        readonly LocalKeyword deforming;
        readonly FieldAtlas meshes, heights;
        // a kernel wants a texture even where it reads none
        readonly Texture3D noField = new Texture3D(1, 1, 1, TextureFormat.RHalf, false)
        {
            name = "Rill.Colliders.NoField",
            hideFlags = HideFlags.HideAndDontSave
        };
        readonly int3 cells;
        readonly float cellSize;
        readonly GraphicsBuffer constants, states, colliderVolume, boundary, contactOffsets;
        GraphicsBuffer masks;
        readonly ColliderConstants[] constantsUpload = new ColliderConstants[1];
        readonly ColliderState[] statesUpload = new ColliderState[ColliderSet.MaxCount];
        int words, recordedCount;
        bool binned;
        int seenVersion = -1, seenOrder;
        readonly ReadbackErrors errors;
        ColliderReactions reactions;

        /// <param name="errors">Learns of forces that the device did not give; may be null.</param>
        public Colliders(SolverLayout layout, ReadbackErrors errors = null)
        {
            this.errors = errors;
            binColliders = new Kernel(shader, "BinColliders");
            measureColliderVolume = new Kernel(shader, "MeasureColliderVolume");
            deforming = new LocalKeyword(shader, DeformingKeyword);
            collidePaths = new KernelVariants(shader, "CollidePaths", "CollidePathsReact");
            FindBoundary = new Kernel(shader, "FindBoundary");
            measureWettedArea = new Kernel(shader, "MeasureWettedArea");
            collide = new KernelVariants(shader, "Collide", "CollideLast", "CollideReact", "CollideLastReact");
            collidePathsReactWithMaterials = new Kernel(shader, "CollidePathsReactWithMaterials");
            collideReactWithMaterials = new KernelVariants(shader, "CollideReactWithMaterials", "CollideLastReactWithMaterials");
            collideWithTension = new KernelVariants(shader, "CollideWithTension", "CollideLastWithTension", "CollideReactWithTension",
                "CollideLastReactWithTension");
            collideWithTensionAndMaterials = new KernelVariants(shader, "CollideWithTensionAndMaterials", "CollideLastWithTensionAndMaterials",
                "CollideReactWithTensionAndMaterials", "CollideLastReactWithTensionAndMaterials");

            cellSize = SmallestCell;
            while (Cells(layout.DomainSize, cellSize) > MaxCells)
                cellSize *= 1.25f;
            cells = (int3)math.ceil(layout.DomainSize / cellSize);
            meshes = new FieldAtlas(shader, ColliderShape.Mesh, "Rill.Colliders.Fields", "signed distance fields");
            heights = new FieldAtlas(shader, ColliderShape.HeightField, "Rill.Colliders.Heights", "height fields");
            constants = Buffers.Constants<ColliderConstants>("Rill.Colliders.Constants", "RillColliders");
            states = Buffers.Structured<ColliderState>("Rill.Colliders.States", ColliderSet.MaxCount, "_Colliders");
            colliderVolume = Buffers.Structured<uint>("Rill.Colliders.ColliderVolume", 1);
            boundary = Buffers.Structured<float4>("Rill.Colliders.Boundary", layout.Capacity);
            contactOffsets = Buffers.Structured<float>("Rill.Colliders.ContactOffsets", layout.Capacity);
            Buffers.Structured<float4>("Rill.Colliders.PathBoundary", layout.Capacity);
            Buffers.Structured<float>("Rill.Colliders.PathContactOffsets", layout.Capacity);
        }

        public static bool IsNeeded(in StepInput input) => input.colliders != null && input.colliders.Count > 0;

        /// <summary>Grows with each substep whose colliders are not those of the one before, at rest in the same places: what was made of
        /// them does not hold any more.</summary>
        public int Changes { get; private set; }

        /// <summary>Whether a mesh deforms in the substep that was recorded last.</summary>
        public bool HasDeforming { get; private set; }

        /// <summary>float4 [capacity], after <see cref="RecordBoundaryAtRest"/> what the colliders add to the density of a particle: xyz
        /// its gradient, 1/d; w relative to rest.</summary>
        public GraphicsBuffer Boundary => boundary;

        /// <summary>float [capacity]: contact offsets of the particles in a substep, d. <see cref="RecordBoundaryAtRest"/> replaces them by the
        /// distance of each particle from the nearest collider.</summary>
        public GraphicsBuffer ContactOffsets => contactOffsets;

        /// <summary>uint [1], what they take of the domain's volume; see OpenFraction.hlsl.</summary>
        public GraphicsBuffer ColliderVolume => colliderVolume;

        /// <summary>Forces and contacts of the fluid on them; null if none asks for them.</summary>
        public ColliderReactions Reactions => reactions;

        /// <summary>Whether a collider came, went, changed or moves: what rests has to wake.</summary>
        public bool ConsumeChanges(ColliderSet set)
        {
            bool changed = set.Version != seenVersion;
            seenVersion = set.Version;
            return changed || set.Moves;
        }

        /// <summary>Takes over colliders without a change: sleeping water came to rest beside them, and what was summed is theirs.</summary>
        public void Adopt(ColliderSet set) => (seenVersion, seenOrder) = (set.Version, set.Order);

        /// <summary>Whether what was summed is of these colliders.</summary>
        public bool HasSumsOf(ColliderSet set) => reactions != null && seenOrder == set.Order;

        /// <summary>Takes what was summed out of a snapshot, or begins without.</summary>
        public void LoadReactions(SnapshotContents contents)
        {
            reactions?.Dispose();
            reactions = null;
            if (!contents.Has(SnapshotSection.Reactions))
                return;
            reactions = new ColliderReactions(shader, contents.Get<ReactionsRecord>(SnapshotSection.Reactions).hasWettedAreas != 0, errors);
            reactions.Load(contents);
        }

        /// <summary>Records where the colliders are in a substep; little where all rest as they did.</summary>
        /// <exception cref="ArgumentException">The fields of the meshes, or the heights, do not fit a texture.</exception>
        public void RecordSubstep(in StepContext step, int substep)
        {
            CommandBuffer cmd = step.Commands;
            StepInput input = step.Input;
            ColliderSet set = input.colliders;
            bool changed = meshes.Hold(set) | heights.Hold(set) | Reserve((set.Count + WordBits - 1) / WordBits) | set.Count != recordedCount;
            recordedCount = set.Count;
            meshes.RecordDeforming(cmd, set);
            float from = math.lerp(input.frameFrom, input.frameTo, substep / (float)step.Substeps);
            float to = math.lerp(input.frameFrom, input.frameTo, (substep + 1) / (float)step.Substeps);
            HasDeforming = false;
            for (int i = 0; i < set.Count; i++)
            {
                ref readonly ColliderMotion motion = ref set.Items[i];
                FieldBrick brick = (motion.shape == ColliderShape.HeightField ? heights : meshes).Brick(motion);
                ColliderState state = ColliderState.For(motion, from, to, step.SubstepTime, VelocityExtrapolation.FractionAtOnce(input),
                    ImplicitViscosity.IsNeeded(input), brick);
                changed |= !StructBytes.AreSame(state, statesUpload[i]);
                HasDeforming |= state.IsDeforming;
                statesUpload[i] = state;
            }
            Changes += changed ? 1 : 0;
            var wanted = new ColliderConstants
            {
                colliderCells = (uint3)cells,
                colliderWords = (uint)words,
                colliderCellSize = cellSize,
                inverseColliderCellSize = 1f / cellSize,
                colliderCount = (uint)set.Count,
                rests = step.MaySleep ? 1u : 0u,
                colliderReach = Reach(input.settings.iterations, step.Coarse != null),
            };
            binned = changed || !wanted.Equals(constantsUpload[0]);
            constantsUpload[0] = wanted;
            cmd.BeginSample(Marker);
            cmd.SetKeyword(shader, deforming, HasDeforming);
            RecordReactions(cmd, set, step.SubstepTime);
            step.BindConstants(shader);     // the kernels are those of all fluids
            if (binned)
            {
                cmd.SetBufferData(constants, constantsUpload);
                cmd.SetBufferData(states, statesUpload, 0, 0, set.Count);
                int total = cells.x * cells.y * cells.z;
                BindShapes(cmd, shader, binColliders);
                CoarseGrid.Dispatch(cmd, shader, binColliders, total * words);
                BindShapes(cmd, shader, measureColliderVolume);
                CoarseGrid.Dispatch(cmd, shader, measureColliderVolume, total * VolumeLanes);
            }
            cmd.EndSample(Marker);
        }

        /// <summary>Records that the particles which lie in colliders are taken out: the sort leaves them out, and they were never added.</summary>
        public void RecordLeaveOut(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            int kernel = shader.FindKernel("LeaveOut");     // once after a start
            BindShapes(cmd, shader, kernel);
            step.Particles.Bind(cmd, shader, kernel);
            step.Particles.DispatchAlive(cmd, shader, kernel);
        }

        /// <summary>Records that the paths of the particles which the sort has left end at the surfaces they meet, and are counted into the
        /// cells there.</summary>
        /// <param name="cellHistogram">uint [cells + 1], particles in a cell.</param>
        /// <param name="cellRanks">uint2 [capacity], cell of a particle and its number there; see CellCount.hlsl.</param>
        public void RecordPaths(in StepContext step, GraphicsBuffer cellHistogram, GraphicsBuffer cellRanks)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            Kernel kernel = PathsKernel(step.Materials != null);
            cmd.BeginSample(Marker);
            Bind(step, kernel, step.MaySleep);
            Ids.Cells.Bind(cmd, shader, kernel, cellHistogram, cellRanks);
            cmd.DispatchCompute(shader, kernel, particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);
            cmd.EndSample(Marker);
        }

        /// <summary>Records the contacts after a pass of the constraint: from Multipliers to Predicted.</summary>
        /// <param name="last">Whether it is the last one of the substep.</param>
        public void RecordPass(in StepContext step, bool last)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            Kernel kernel = PassKernel(step.Input, last);
            cmd.BeginSample(Marker);
            if (SurfaceTension.IsNeeded(step.Input))
                SurfaceTension.Bind(step, shader);
            Bind(step, kernel, step.MaySleep);
            Ids.Pass.Bind(cmd, shader, kernel, particles.Multipliers, particles.Predicted);
            cmd.DispatchCompute(shader, kernel, particles.SortedArguments, GpuBuffer.DispatchArgumentsAt);
            cmd.EndSample(Marker);
        }

        /// <summary>Records <see cref="Boundary"/> at the current positions, in their order, for a measurement.</summary>
        public void RecordBoundaryAtRest(in StepContext step)
        {
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            cmd.BeginSample(Marker);
            step.BindConstants(shader);
            Bind(step, FindBoundary, false);
            cmd.SetComputeBufferParam(shader, FindBoundary, Ids.Distances, contactOffsets);       // free between steps
            cmd.DispatchCompute(shader, FindBoundary, particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);
            cmd.EndSample(Marker);
        }

        /// <summary>Records how much of the colliders is wet, as the particles and the colliders of the last substep lie; where one wants to
        /// know.</summary>
        public void RecordWettedAreas(in StepContext step)
        {
            if (reactions == null || !reactions.HasWettedAreas)
                return;
            CommandBuffer cmd = step.Commands;
            ParticleBuffers particles = step.Particles;
            cmd.BeginSample(Marker);
            step.BindConstants(shader);
            cmd.SetKeyword(shader, deforming, HasDeforming);
            BindShapes(cmd, shader, measureWettedArea);
            reactions.Bind(cmd, shader, measureWettedArea);
            particles.Bind(cmd, shader, measureWettedArea);
            cmd.DispatchCompute(shader, measureWettedArea, particles.AliveArguments, GpuBuffer.DispatchArgumentsAt);
            cmd.EndSample(Marker);
        }

        public override void Dispose()
        {
            meshes.Dispose();
            heights.Dispose();
            UnityEngine.Object.DestroyImmediate(noField);       // nothing else can hold it
            reactions?.Dispose();
            base.Dispose();
        }

        /// <param name="colliders">The stage, or null where none was made.</param>
        public static StageDescription Describe(Colliders colliders, in StepInput input)
        {
            bool needed = IsNeeded(input);
            var description = new StageDescription("Colliders", needed, needed ? Invariant($"{input.colliders.Count} of them in the domain")
                : "no collider is in the domain");
            if (!needed || colliders == null)
                return description;
            int substeps = input.settings.substeps;
            bool reacts = colliders.reactions != null;
            string variant = colliders.HasDeforming ? DeformingKeyword : null;
            if (colliders.binned)
            {
                description.Kernel(colliders.binColliders, substeps, variant);
                description.Kernel(colliders.measureColliderVolume, substeps, variant);
            }
            bool weighs = MaterialTable.IsNeeded(input);
            description.Kernel(colliders.PathsKernel(weighs), substeps, variant);
            if (input.settings.iterations > 1)
                description.Kernel(colliders.PassKernel(input, false), substeps * (input.settings.iterations - 1), variant);
            description.Kernel(colliders.PassKernel(input, true), substeps, variant);
            if (reacts && colliders.reactions.HasWettedAreas)
                description.Kernel(colliders.measureWettedArea, 0, variant);
            colliders.reactions?.Describe(description);
            colliders.Buffers.Describe(description);
            description.Buffers.Add(("Rill.Colliders.NoField", FieldAtlas.BytesOfVoxel));
            colliders.meshes.Describe(description);
            colliders.heights.Describe(description);
            return description;
        }

        // Forces weigh particles, where phases are of several materials.
        Kernel PathsKernel(bool weighs) => reactions != null && weighs ? collidePathsReactWithMaterials : collidePaths.For(reactions != null);

        Kernel PassKernel(in StepInput input, bool last)
        {
            bool weighs = MaterialTable.IsNeeded(input), reacts = reactions != null;
            if (SurfaceTension.IsNeeded(input))
                return (weighs ? collideWithTensionAndMaterials : collideWithTension).For(last, reacts);
            return reacts && weighs ? collideReactWithMaterials.For(last) : collide.For(last, reacts);
        }

        void Bind(in StepContext step, int kernel, bool maySleep)
        {
            CommandBuffer cmd = step.Commands;
            step.Materials?.Bind(step, shader, kernel);
            cmd.SetKeyword(shader, deforming, HasDeforming);
            step.Particles.Bind(cmd, shader, kernel);
            BindShapes(cmd, shader, kernel);
            if (maySleep)
                step.BindAsleep(shader, kernel);
            else
                cmd.SetComputeBufferParam(shader, kernel, Ids.RegionStates, masks);     // not read
            reactions?.Bind(cmd, shader, kernel);
        }

        /// <summary>Records what the colliders add to the density (ColliderDensity.hlsl), leave of the domain (OpenFraction.hlsl) and let the sort
        /// carry along, as a kernel reads it.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader reader, int kernel) => Buffers.Bind(cmd, reader, kernel);

        /// <summary>Records the colliders of the substep, with their fields, as what a kernel reads.</summary>
        public void BindShapes(CommandBuffer cmd, ComputeShader reader, int kernel)
        {
            Bind(cmd, reader, kernel);
            Ids.Fields.Bind(cmd, reader, kernel, TextureOf(meshes), TextureOf(heights));
        }

        Texture TextureOf(FieldAtlas atlas) => atlas.Texture != null ? (Texture)atlas.Texture : noField;

        // Sums are there while a collider wants them, and begin again when the colliders get other numbers.
        void RecordReactions(CommandBuffer cmd, ColliderSet set, float timeStep)
        {
            if (!set.Reacts)
            {
                reactions?.Dispose();
                reactions = null;
                return;
            }
            bool tellsWettedArea = set.TellsWettedArea;
            if (reactions != null && reactions.HasWettedAreas != tellsWettedArea)
            {
                reactions.Dispose();
                reactions = null;
            }
            reactions ??= new ColliderReactions(shader, tellsWettedArea, errors);
            if (seenOrder != set.Order)
                reactions.Invalidate(cmd);
            seenOrder = set.Order;
            reactions.AddTime(timeStep);
        }

        bool Reserve(int wantedWords)
        {
            if (masks != null && wantedWords == words)
                return false;
            Buffers.Release(ref masks);
            words = wantedWords;
            masks = Buffers.Structured<uint>("Rill.Colliders.Masks", (long)cells.x * cells.y * cells.z * words, "_ColliderMasks");
            return true;
        }

        // How far from a sorted particle a collider can matter in the rest of the substep, d: as far as it reaches, or what the passes
        // can move the particle until it touches.
        static float Reach(int iterations, bool deep) =>
            math.max((float)LatticeKernels.Support, ContactOffset + iterations * SolverConstants.MaxCorrection
            + (deep ? CoarseConstants.MaxPush : 0f));

        static float Cells(float3 domainSize, float size)
        {
            float3 counts = math.ceil(domainSize / size);
            return counts.x * counts.y * counts.z;
        }

        static class Ids
        {
            public static readonly ShaderParameters Fields = new ShaderParameters("_Fields", "_Heights");
            public static readonly ShaderParameters Pass = new ShaderParameters("_Before", "_Corrected");
            public static readonly ShaderParameters Cells = new ShaderParameters("_CellHistogram", "_CellRanks");
            public static readonly int Distances = Shader.PropertyToID("_Distances");
            public static readonly int RegionStates = Shader.PropertyToID("_RegionStates");
        }
    }
}
