using System;
using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>Snapshots of a fluid: taken without waiting, restored at once; and the start state that a restart begins with.</summary>
    sealed class FluidSnapshots
    {
        const float Tolerance = 1e-3f;      // within which an object is where it was: d in the box, and as many spacings in the world

        readonly FluidSimulation fluid;
        readonly SnapshotBodyMatching bodies;
        string startProblem;        // of the newest restart

        public FluidSnapshots(FluidSimulation fluid)
        {
            this.fluid = fluid;
            bodies = new SnapshotBodyMatching(fluid);
        }

        /// <summary>Why the start state is not used; null where it is, or there is none.</summary>
        public string StartStateProblem
        {
            get
            {
                FluidSnapshotAsset state = fluid.StartState;
                if (state == null)
                    return null;
                if (!state.Validate(out string problem))
                    return $"fills its volumes instead of its start state: {problem}";
                problem = fluid.Solver != null ? fluid.Solver.ProblemOf(state.Snapshot.Contents) : null;
                return problem != null ? $"fills its volumes instead of its start state '{state.name}': {problem}" : null;
            }
        }

        /// <summary>Requests a snapshot of the present state.</summary>
        public FluidSnapshotRequest Request()
        {
            fluid.BeginAgainIfChanged();
            if (fluid.Solver == null)
                throw new InvalidOperationException($"FluidSimulation '{fluid.name}' is not running: enable it before you take a snapshot.");
            var contents = new SnapshotContents();
            fluid.Editing.Recentering.LogNotSaved();
            SnapshotCapture capture = fluid.Solver.Capture(contents);
            Save(contents, capture);
            var request = new FluidSnapshotRequest();
            capture.Request(request.Finish);
            return request;
        }

        /// <summary>Replaces the present state by a snapshot.</summary>
        /// <param name="putsBodies">Whether floating bodies are put back.</param>
        public void Restore(FluidSnapshot snapshot, bool putsBodies)
        {
            if (snapshot == null)
                throw new ArgumentNullException(nameof(snapshot));
            fluid.Steps.Passes.ThrowInPass();
            if (fluid.Solver == null && FeatureSupport.HasNoGraphics)
                return;
            fluid.BeginAgainIfChanged();
            if (fluid.Solver == null)
                throw new InvalidOperationException($"FluidSimulation '{fluid.name}' is not running: enable it before you restore a snapshot.");
            if (fluid.Solver.ProblemOf(snapshot.Contents) is string problem)
                throw new ArgumentException($"The snapshot does not fit FluidSimulation '{fluid.name}': {problem}", nameof(snapshot));

            fluid.Resolution.Cancel();
            fluid.Solver.Restore(snapshot.Contents, FeaturesFor(snapshot.Contents));
            Load(snapshot.Contents, putsBodies);
        }

        /// <summary>Begins with the start state instead of the volumes; false where there is none, or it does not fit.</summary>
        public bool TryStart()
        {
            string before = startProblem;
            startProblem = StartStateProblem;
            if (fluid.StartState == null)
                return false;
            if (startProblem != null)
            {
                if (startProblem != before)
                    Debug.LogError($"Rill: FluidSimulation '{fluid.name}' {startProblem}", fluid);
                return false;
            }
            SnapshotContents contents = fluid.StartState.Snapshot.Contents;
            fluid.Solver.Restore(contents.Fluid(), FeaturesFor(contents));
            return true;
        }

        // Features that the scene asks for, as far as the build and the device have them.
        FeatureSet FeaturesFor(SnapshotContents contents)
        {
            SceneInputs inputs = fluid.Inputs;
            var still = new StepInput { settings = fluid.Settings, material = fluid.Material, phases = fluid.Phases.ForStep() };
            FeatureSet features = FeatureSet.None;
            if (contents.Has(SnapshotSection.Slips) && MaterialTable.IsNeeded(still))
                features = WithSupported(features, Features.Materials);
            if (contents.Has(SnapshotSection.Rest) && RestingRegions.IsNeeded(still))
                features = WithSupported(features, Features.Sleep);
            if (contents.Has(SnapshotSection.Coarse) && still.settings.deepWater != DeepWater.Off)
                features = WithSupported(features, Features.DeepWater);
            if (contents.Has(SnapshotSection.Conformation) && Viscoelasticity.IsNeeded(still))
                features = WithSupported(features, Features.Elasticity);
            if (contents.Has(SnapshotSection.FrictionStress) && GrainFriction.IsNeeded(still))
                features = WithSupported(features, Features.GrainFriction);
            if (contents.Has(SnapshotSection.NeighborCounts) && ImplicitViscosity.IsNeeded(still))
                features = WithSupported(features, Features.Viscosity);
            if (contents.Has(SnapshotSection.EmitterStates) && (inputs.Parts.HasEmitters || fluid.Borders.HasOpen))
                features = WithSupported(features, Features.Emitters);
            if (contents.Has(SnapshotSection.DrainStates) || contents.Has(SnapshotSection.Tags))
                features = WithSupported(features, Features.Drains);
            if (contents.Has(SnapshotSection.Fields) && inputs.Parts.HasFields)
                features = WithSupported(features, Features.ForceFields);
            if (contents.Has(SnapshotSection.Colliders) && (SceneColliders.Enabled.Count > 0 || inputs.Colliders.Source != null))
                features = WithSupported(features, Features.Colliders);
            return features;
        }

        FeatureSet WithSupported(FeatureSet features, Feature feature) => features.With(feature, fluid.Support.Has(feature));

        // Saves what the component and its parts know besides their settings.
        void Save(SnapshotContents contents, SnapshotCapture capture)
        {
            SceneInputs inputs = fluid.Inputs;
            var time = new TimeRecord();
            fluid.Clock.Save(ref time);
            fluid.Box.Save(ref time);
            inputs.Parts.Save(ref time);
            inputs.Colliders.Save(ref time);
            contents.Set(SnapshotSection.Time, time);

            DomainFrame frame = fluid.Box.Frame;
            inputs.Parts.Save(contents, frame);
            inputs.Colliders.Save(contents, frame);
            var calls = new CallsRecord();
            fluid.Box.Save(ref calls);
            inputs.Parts.Save(ref calls);
            fluid.Clock.Save(ref calls);
            contents.Set(SnapshotSection.Calls, calls);
            inputs.Colliders.SaveForces(contents, capture);
            bodies.Save(contents, capture);
        }

        void Load(SnapshotContents contents, bool putsBodies)
        {
            SceneInputs inputs = fluid.Inputs;
            TimeRecord time = contents.Get<TimeRecord>(SnapshotSection.Time);
            fluid.Clock.Load(time);
            fluid.Results.Measurements.Restart();
            fluid.Box.ResetMotion();
            inputs.Parts.Restart();
            fluid.Results.Queries.Restart();

            if (fluid.Box.TryLoad(time, Tolerance * fluid.ParticleSpacing) && contents.Has(SnapshotSection.Calls))
            {
                CallsRecord calls = contents.Get<CallsRecord>(SnapshotSection.Calls);
                fluid.Clock.Load(calls);
                fluid.Box.Load(calls);
                inputs.Parts.Load(calls);
            }
            fluid.GetPose(out Vector3 position, out Quaternion rotation);
            var box = new BoxMotion(time.box.Pose, new RigidPose(position, rotation));
            DomainFrame frame = fluid.Box.Frame;
            List<RestoredBody> restored = putsBodies ? bodies.Restore(contents, box) : new List<RestoredBody>();
            inputs.Parts.Load(contents, time, frame, Tolerance);
            inputs.Colliders.Load(contents, frame, box, Tolerance);
            inputs.Colliders.Load(time);
            bodies.Load(restored, box);
        }
    }
}
