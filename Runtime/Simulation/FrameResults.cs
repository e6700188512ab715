using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Results of the state that a frame leaves: the surface, queries, statistics, and forces on colliders. Records them after the
    /// steps, and requests what comes back.</summary>
    sealed class FrameResults
    {
        public readonly SurfaceRequests Surface;
        public readonly WaterQueries Queries;
        public readonly Measurements Measurements;

        readonly FluidSimulation fluid;

        public FrameResults(FluidSimulation fluid)
        {
            this.fluid = fluid;
            Surface = new SurfaceRequests(fluid);
            Queries = new WaterQueries(fluid);
            Measurements = new Measurements(fluid);
        }

        /// <summary>Records all that looks at the state that the steps of this frame leave, executes it with them, and requests the
        /// results.</summary>
        public void Execute(CommandBuffer commands)
        {
            Surface.Record(commands);
            int queries = Queries.Record(commands);
            Queries.RecordBatches(commands);
            fluid.Solver.RecordGhostRemoval(commands);

            bool measures = Measurements.Record(commands);
            ColliderReactions reactions = fluid.Inputs.Colliders.RecordReactions(commands, fluid.Steps.Input);
            Graphics.ExecuteCommandBuffer(commands);

            reactions?.Request();
            Queries.Request(queries);
            Queries.RequestBatches();
            if (measures)
                Measurements.Request();
        }

        /// <summary>Begins a frame: hands over what has come back, and requests again what was lost.</summary>
        public void BeginFrame()
        {
            PendingReadbacks.FinishResumed();
            fluid.Inputs.Colliders.RaiseExits();
            LogLost();
            fluid.Solver?.RequestLost();
        }

        /// <summary>Logs what the graphics device gave an error for instead of the data, each kind once.</summary>
        public void LogLost()
        {
            if (fluid.Solver == null)
                return;
            for (ReadbackKinds fresh = fluid.Solver.ReadbackErrors.ConsumeNew(); ReadbackErrors.TryTake(ref fresh, out ReadbackKinds kind);)
                Debug.LogError($"Rill: FluidSimulation '{fluid.name}' {ReadbackErrors.Problem(kind)}", fluid);
        }

        /// <summary>Lists what each stage costs this scene, and why it is there or not; empty when the fluid does not run.</summary>
        public List<StageDescription> Describe()
        {
            var stages = new List<StageDescription>();
            if (fluid.Solver == null)
                return stages;
            stages.AddRange(fluid.Solver.Describe(fluid.Steps.Input, fluid.StatisticsInterval));
            stages.Add(Queries.DescribeBatches());
            stages.Add(fluid.Steps.Budget.Describe());
            IDrawsFluid[] renderers = fluid.GetComponents<IDrawsFluid>();
            foreach (IDrawsFluid renderer in renderers)
                stages.Add(renderer.Describe());
            if (renderers.Length == 0)
                stages.Add(new StageDescription("Rendering", false, $"'{fluid.name}' has no renderer component"));
            return stages;
        }
    }
}
