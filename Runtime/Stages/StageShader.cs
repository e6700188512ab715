using System;
using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// The compute shader or shader of one stage, as an asset that components refer to: a build contains the stages of the
    /// components that it contains, and no others.
    /// </summary>
    /// <remarks>A stage is found while something that is enabled refers to its asset; in the Editor always.</remarks>
    public sealed class StageShader : ScriptableObject
    {
        /// <summary>The stage that bakes meshes, which no fluid brings along.</summary>
        internal const string OfBaking = "MeshSdf";

        [SerializeField] ComputeShader compute;
        [SerializeField] Shader shader;

        // Components let go of their stages in OnDisable, when play mode ends too.
        [KeptBetweenPlays] static readonly List<StageShader> held = new List<StageShader>();
        [KeptBetweenPlays] static Func<string, StageShader> editorFind;
        [KeptBetweenPlays] static int changes;

        [NonSerialized] string stage;       // its name, which Unity would copy at each call
        [NonSerialized] int holders;

        /// <summary>The stage's kernels; null for a stage that only draws.</summary>
        public ComputeShader Compute => compute;

        /// <summary>The stage's passes; null for a stage that only computes.</summary>
        public Shader Shader => shader;

        /// <summary>Finds a stage's asset among all of the project's; null in a player.</summary>
        internal static Func<string, StageShader> EditorFind { get => editorFind; set => editorFind = value; }

        /// <summary>Differs from its last value once a stage has come or gone.</summary>
        internal static int Changes => changes;

        /// <summary>The stage's asset.</summary>
        /// <exception cref="InvalidOperationException">Nothing that is loaded refers to it.</exception>
        public static StageShader Load(string stage)
        {
            StageShader asset = Find(stage);
            if (asset == null)
                throw new InvalidOperationException(MissingProblem(stage));
            return asset;
        }

        /// <summary>The kernels of a stage.</summary>
        /// <exception cref="InvalidOperationException">Nothing that is loaded refers to the asset, or its compute shader is missing.</exception>
        public static ComputeShader LoadCompute(string stage)
        {
            ComputeShader compute = Load(stage).compute;
            if (compute == null)
                throw new InvalidOperationException($"the asset of the stage '{stage}' has lost its compute shader. Reimport the package.");
            return compute;
        }

        /// <summary>The stage's asset; null where nothing that is loaded refers to it.</summary>
        internal static StageShader Find(string stage)
        {
            foreach (StageShader asset in held)
                if (asset.stage == stage && asset != null)
                    return asset;
            StageShader found = editorFind?.Invoke(stage);
            return found != null ? found : null;
        }

        /// <summary>Describes a missing stage and what to do about it.</summary>
        internal static string MissingProblem(string stage)
        {
            string byFluid = stage == OfBaking ? "Put" :
                "Set Shaders In Build of a FluidSimulation in the scene to All Features, or put";
            return $"the shaders of the stage '{stage}' are not loaded: this build has no scene or prefab with a component that uses " +
                $"them, or the component was added by a script. {byFluid} the package's asset FluidShaders " +
                "into the Preloaded Assets of the player settings.";
        }

        /// <summary>The stage can be found until as many calls of <see cref="Release"/>.</summary>
        internal void Hold()
        {
            if (!held.Contains(this))
            {
                stage = name;
                holders = 0;
                held.Add(this);
                changes++;
            }
            holders++;
        }

        /// <summary>Takes one <see cref="Hold"/> back.</summary>
        internal void Release()
        {
            if (--holders > 0 || !held.Remove(this))
                return;
            changes++;
        }
    }
}
