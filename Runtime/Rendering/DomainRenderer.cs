using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Draws the box of the <see cref="FluidSimulation"/> on this object: edges and a chequered floor.</summary>
    [AddComponentMenu("Rill/Domain Renderer"), Icon(PackagePaths.Icon), ManualPage("rendering", "domain-renderer")]
    public sealed class DomainRenderer : FluidRenderer
    {
        /// <summary>two for each of the box's edges</summary>
        [GenerateHlsl("Domain")] const int EdgeVertices = 24;

        /// <summary>two triangles</summary>
        [GenerateHlsl("Domain")] const int FloorVertices = 6;


        [Tooltip("Color of the box's edges. Each channel 0 to 1; alpha has no effect.")]
        [SerializeField] Color edges = new Color(0.25f, 0.28f, 0.32f);

        [Tooltip("Color of the floor's lighter tiles. Each channel 0 to 1; alpha has no effect.")]
        [SerializeField] Color floor = new Color(0.78f, 0.80f, 0.82f);

        [Tooltip("Side of a floor tile, m.")]
        [Min(1e-3f)]
        [SerializeField] float tile = 0.25f;

        MaterialPropertyBlock edgeProperties, floorProperties;

        /// <summary>Color of the box's edges; alpha has no effect.</summary>
        public Color Edges { get => edges; set => edges = value; }

        /// <summary>Color of the floor's lighter tiles; alpha has no effect.</summary>
        public Color Floor { get => floor; set => floor = value; }

        /// <summary>Side of a floor tile, m, at least 0.001.</summary>
        public float Tile { get => tile; set => tile = Mathf.Max(value, 1e-3f); }

        // The frame around the fluid is only an outline, so it casts no shadows.
        DomainRenderer() : base(ShadowCastingMode.Off) { }

        private protected override Feature Drawn => Features.DomainRenderer;
        private protected override string ShaderFile => "Domain";

        private protected override void Draw()
        {
            edgeProperties ??= new MaterialPropertyBlock();
            floorProperties ??= new MaterialPropertyBlock();
            Draw(edgeProperties, MeshTopology.Lines, EdgeVertices, 0f);
            Draw(floorProperties, MeshTopology.Triangles, FloorVertices, 1f);
        }

        private protected override void DescribeDraws(StageDescription description) => description.Draw(ShaderFile, 2);

        void Draw(MaterialPropertyBlock properties, MeshTopology topology, int vertices, float drawFloor)
        {
            Matrix4x4 scale = Matrix4x4.Scale(Simulation.DomainSize / Simulation.ParticleSpacing);
            properties.SetMatrix(Ids.BoxToWorld, Simulation.DomainToWorld * scale);
            properties.SetMatrix(Ids.LastBoxToWorld, LastDomainToWorld * scale);
            SetSun(properties, null);
            properties.SetVector(Ids.BoxSize, Simulation.DomainSize);
            properties.SetVector(Ids.LineColor, ShaderColor(edges));
            properties.SetVector(Ids.FloorColor, ShaderColor(floor));
            properties.SetFloat(Ids.FloorTile, tile);
            properties.SetFloat(Ids.DrawFloor, drawFloor);
            Graphics.RenderPrimitives(Parameters(properties), topology, vertices);
        }

        static class Ids
        {
            public static readonly int BoxToWorld = Shader.PropertyToID("_BoxToWorld");
            public static readonly int LastBoxToWorld = Shader.PropertyToID("_LastBoxToWorld");
            public static readonly int BoxSize = Shader.PropertyToID("_BoxSize");
            public static readonly int LineColor = Shader.PropertyToID("_LineColor");
            public static readonly int FloorColor = Shader.PropertyToID("_FloorColor");
            public static readonly int FloorTile = Shader.PropertyToID("_FloorTile");
            public static readonly int DrawFloor = Shader.PropertyToID("_DrawFloor");
        }
    }
}
