using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>The simulation's settings, presets of fluids and, while it runs, what it measures and costs.</summary>
    [CustomEditor(typeof(FluidSimulation))]
    [CanEditMultipleObjects]
    sealed class FluidSimulationEditor : RillEditor
    {
        const string FluidTitle = "Fluid", DomainTitle = "Domain", SolverTitle = "Solver", BudgetTitle = "Budget";
        const int MemoryInterval = 30;      // frames between two looks at the buffers; by frames, so that layout and repaint see the same

        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection(DomainTitle, true,
                new InspectorField("domainSize", "m"),
                new InspectorField("particleSpacing", "m"),
                new InspectorField("capacity", "particles"),
                new InspectorField("inertial"),
                new InspectorField("fluidColliderLayers"),
                new InspectorField("seed"),
                new InspectorField("startState")),
            new InspectorSection("Borders", false, Border("minX").With(Border("maxX")).With(Border("minZ")).With(Border("maxZ"))),
            new InspectorSection(FluidTitle, true, MaterialFields.Usual.With(
                new InspectorField("phaseMaterials"),
                new InspectorField("materialPairs"),
                new InspectorField("gravity", "m/s²"))),
            new InspectorSection(SolverTitle, false,
                new InspectorField("solver.deepWater"),
                new InspectorField("solver.iterations"),
                new InspectorField("solver.relaxation"),
                new InspectorField("solver.substeps"),
                new InspectorField("solver.sleepSpeed", "m/s"),
                new InspectorField("solver.numericalDamping", "of a first-order step's")),
            new InspectorSection("Advanced", false, MaterialFields.Advanced.With(
                new InspectorField("solver.softness"),
                new InspectorField("solver.listMargin", "support radii"),
                new InspectorField("solver.neighborCapacity"))),
            new InspectorSection(BudgetTitle, false,
                new InspectorField("budget.mode"),
                new InspectorField("budget.milliseconds", "ms", When.Is("budget.mode", BudgetMode.Milliseconds)),
                new InspectorField("budget.fraction", "of the frame", When.Is("budget.mode", BudgetMode.FrameFraction)),
                new InspectorField("budget.frameRate", "1/s", When.Is("budget.mode", BudgetMode.FrameFraction)),
                new InspectorField("budget.targetError", "C+", When.IsNot("budget.mode", BudgetMode.Off)),
                new InspectorField("budget.minIterations", when: When.IsNot("budget.mode", BudgetMode.Off)),
                new InspectorField("budget.maxIterations", when: When.IsNot("budget.mode", BudgetMode.Off)),
                new InspectorField("budget.minSubsteps", when: When.IsNot("budget.mode", BudgetMode.Off)),
                new InspectorField("budget.maxSubsteps", when: When.IsNot("budget.mode", BudgetMode.Off)),
                new InspectorField("budget.deviceFactor", "of the cost model", When.IsNot("budget.mode", BudgetMode.Off))),
            new InspectorSection("Time", false,
                new InspectorField("stepRate", "1/s"),
                new InspectorField("maxStepsPerFrame"),
                new InspectorField("paused"),
                new InspectorField("keepStateOnDisable"),
                new InspectorField("keptCapacity", "particles"),
                new InspectorField("cullingMode"),
                new InspectorField("cullingDistance", "m", When.IsNot("cullingMode", FluidCullingMode.AlwaysSimulate)),
                new InspectorField("culledRate", "of the time", When.Is("cullingMode", FluidCullingMode.Slow)),
                new InspectorField("statisticsInterval", "steps")),
            new InspectorSection("Build", false,
                new InspectorField("shadersInBuild")),
        };

        static readonly GUIContent presetLabel = new GUIContent("Preset",
            "A fluid that goes by a name: sets the material below and the look of the Fluid Surface on this object. Presets are assets: " +
            "Assets > Create > Rill > Fluid Preset makes one."),
            saveLabel = new GUIContent("Save as Fluid Preset", "Writes material and look into an asset, which is then among the presets.");

        List<MissingPart> missing = new List<MissingPart>();
        StageTimes times;
        FluidSnapshotRequest saving;
        readonly List<MemoryRows.Row> memory = new List<MemoryRows.Row>();
        [NonSerialized] int memoryAt = -MemoryInterval;

        internal override InspectorSection[] Sections => AllSections;

        static InspectorField[] Border(string side)
        {
            string path = $"borders.{side}.", kind = path + "kind";
            return new[]
            {
                new InspectorField(kind), new InspectorField(path + "width", "m", When.IsNot(kind, BorderKind.Wall)),
                new InspectorField(path + "velocity", "m/s", When.Is(kind, BorderKind.Open)),
                new InspectorField(path + "level", "m", When.Is(kind, BorderKind.Open)),
            };
        }

        internal override bool TryGetFrame(Object of, out Bounds bounds) => FrameBounds.TryGet((FluidSimulation)of, out bounds);

        FluidSimulation Simulation => (FluidSimulation)target;

        void OnDisable() => StopTimes();

        private protected override void DrawMessages()
        {
            if (targets.Length > 1)
                return;
            // Both passes of a frame have to draw the same rows.
            if (Event.current.type == EventType.Layout)
                missing = MissingPart.Of(Simulation);
            foreach (MissingPart part in missing)
            {
                EditorGUILayout.HelpBox(part.Text, MessageType.Info);
                if (part.Button != null && GUILayout.Button(part.Button))
                    part.Add();
            }
            foreach ((MessageType type, string text) in BudgetSummary.Messages(Simulation.Budget, Simulation.BudgetState,
                Simulation.StatisticsInterval))
                EditorGUILayout.HelpBox(text, type);
        }

        private protected override void DrawAboveSections()
        {
            if (targets.Length > 1)
                return;
            if (!Application.isPlaying && !EditorUtility.IsPersistent(target))
                SceneSimulationControls.Draw(Simulation);
            InspectorRows.Text("Deep Water", DeepWaterState.Describe(Simulation));
        }

        private protected override void DrawAbove(string title)
        {
            if (title == FluidTitle)
                DrawPresets();
        }

        private protected override void DrawBelow(string title)
        {
            if (targets.Length > 1)
                return;
            if (title == FluidTitle)
                DrawMaterialTexts();
            if (title == DomainTitle)
                DrawEstimates();
            if (title == SolverTitle && Simulation.Budget.mode != BudgetMode.Off)
                EditorGUILayout.HelpBox(BudgetSummary.SolverNote, MessageType.Info);
            if (title == BudgetTitle)
                foreach ((string label, string text) in BudgetSummary.Rows(Simulation.BudgetState))
                    InspectorRows.Text(label, text);
        }

        void DrawEstimates()
        {
            InspectorRows.Text("Volumes hold", Invariant($"about {FillEstimate.Particles(Simulation):N0} particles"));
            long bytes = Simulation.SolverOwner.EstimatedBytes;
            if (bytes > 0)
                InspectorRows.Text("GPU memory", MemoryRows.Text(bytes, Simulation.Capacity) + ", without optional stages");
        }

        void DrawPresets()
        {
            serializedObject.ApplyModifiedProperties();
            int current = FluidPresets.IndexOf((FluidSimulation)targets[0]);
            bool isMixed = false;
            foreach (Object one in targets)
                isMixed |= FluidPresets.IndexOf((FluidSimulation)one) != current;
            EditorGUI.showMixedValue = isMixed;
            EditorGUI.BeginChangeCheck();
            int chosen = EditorGUILayout.Popup(presetLabel, current + 1, FluidPresets.Names) - 1;
            bool isChosen = EditorGUI.EndChangeCheck();
            EditorGUI.showMixedValue = false;
            if (isChosen && chosen >= 0)
            {
                FluidPresets.Apply(FluidPresets.All[chosen], targets);
                GUIUtility.ExitGUI();       // another preset has other lines below it
            }
            if (targets.Length > 1)
                return;
            if (current >= 0)
                EditorGUILayout.HelpBox(PresetText.Describe(FluidPresets.All[current], Simulation.ParticleSpacing), MessageType.None);
            else if (GUILayout.Button(saveLabel))
                FluidPresets.SaveAs(Simulation);
        }

        void DrawMaterialTexts()
        {
            if (Simulation.Material.velocitySmoothing > 0f)
                InspectorRows.Text("Smoothing acts like", PresetText.SmoothingText(Simulation.Material, Simulation.ParticleSpacing));
            if (Simulation.Material.shearModulus > 0f)
                InspectorRows.Text("Elastic",
                    PresetText.ElasticityText(Simulation.Material, Simulation.ParticleSpacing,
                    Simulation.FixedStep / Simulation.Settings.substeps));
            PhaseMaterials phases = Simulation.Phases.ForStep();
            if (phases.Differ(Simulation.Material))
                InspectorRows.Text("Liquids", Invariant($"densities up to a factor of {phases.Ratio(Simulation.Material):0.##} apart; ") +
                    Invariant($"to {PhaseMaterials.MaxRatio:0} is possible, and to 20 costs least"));
            if (phases.MaxDiffusion > 0f)
                InspectorRows.Text("Diffusion", Diffusion.Text(phases.MaxDiffusion, Simulation.ParticleSpacing,
                    Simulation.FixedStep / Simulation.Settings.substeps, Simulation.Settings.substeps));
            if (Simulation.Material.contacts)
                InspectorRows.Text("Contacts", ContactsText());
            if (Simulation.Material.surfaceTension > 0f)
                InspectorRows.Text("Surface tension",
                    PresetText.TensionText(Simulation.Material, Simulation.Settings, Simulation.ParticleSpacing,
                    Simulation.FixedStep / Simulation.Settings.substeps));
        }

        string ContactsText()
        {
            int layers = Contacts.LayersHeld(Simulation.Gravity.magnitude, Simulation.ParticleSpacing,
                Simulation.FixedStep / Simulation.Settings.substeps);
            return layers > 3 ? "4 layers of balls hold; higher heaps are pressed together"
                : Invariant($"{layers} layer(s) of balls hold at this spacing; more with more substeps");
        }

        private protected override void DrawLive()
        {
            if (Application.isPlaying)
            {
                if (GUILayout.Button("Restart"))
                    Simulation.Restart();
                SnapshotAssets.Draw(Simulation, ref saving);
            }
            DrawStatistics();
            DrawTimes();
            DrawMemory();
        }

        void DrawStatistics()
        {
            if (!Unfold("Statistics", true))
                return;
            bool known = Simulation.TryGetStatistics(out FluidStatistics statistics);
            if (!known)
                EditorGUILayout.HelpBox(StatisticsSummary.WhyNone(Simulation.StatisticsInterval), MessageType.None);
            else
                foreach ((string label, string text) in StatisticsSummary.Rows(statistics, Simulation.Capacity))
                    InspectorRows.Text(label, text);
            if (known)
                foreach (string text in StatisticsSummary.Warnings(statistics))
                    EditorGUILayout.HelpBox(text, MessageType.Warning);
        }

        // Recorders cost a little, so they run while someone looks.
        void DrawTimes()
        {
            if (!Unfold("GPU time", false))
            {
                StopTimes();
                return;
            }
            times ??= new StageTimes();
            times.Update(Time.frameCount);
            if (times.Rows.Count == 0)
                EditorGUILayout.HelpBox(StageTimes.WhyNone(SystemInfo.supportsGpuRecorder), MessageType.None);
            foreach (StageTimes.Row row in times.Rows)
                InspectorRows.BarOf(row.Label, row.Fraction, Invariant($"{row.Milliseconds:0.000} ms"));
            if (times.Rows.Count > 0)
                InspectorRows.Text("All stages", Invariant($"{times.Total:0.000} ms a frame, of all simulations together"));
        }

        void StopTimes()
        {
            times?.Dispose();
            times = null;
        }

        void DrawMemory()
        {
            if (!Unfold("GPU memory", false))
                return;
            if (Time.frameCount - memoryAt >= MemoryInterval)
            {
                memoryAt = Time.frameCount;
                MemoryRows.List(Simulation.Results.Describe(), memory);
            }
            InspectorRows.Text("All buffers", MemoryRows.Text(MemoryRows.Total(memory), Simulation.Capacity));
            foreach (MemoryRows.Row row in memory)
                InspectorRows.BarOf(row.Label, row.Fraction, EditorUtility.FormatBytes(row.Bytes));
        }

        void OnSceneGUI()
        {
            // A fluid that runs would start again at every move.
            if (!Application.isPlaying && !SceneSimulation.Runs(Simulation))
                ShapeHandles.Box(Simulation, "domainSize", false, GizmoColors.Domain);
        }
    }
}
