using System.Collections.Generic;

namespace Host.Pipelines
{
    /// <summary>A scriptable render pipeline that has a stand-in here and an adapter in the package.</summary>
    sealed class PipelineKind
    {
        public static readonly PipelineKind Universal = new()
        {
            Name = "universal", Tag = "UniversalPipeline", Package = "com.unity.render-pipelines.universal",
                Assembly = "Unity.RenderPipelines.Universal.Runtime",
            Folder = "Universal", Asset = "UnityEngine.Rendering.Universal.UniversalRenderPipelineAsset",
        };

        public static readonly PipelineKind HighDefinition = new()
        {
            Name = "high-definition", Tag = "HDRenderPipeline", Package = "com.unity.render-pipelines.high-definition",
                Assembly = "Unity.RenderPipelines.HighDefinition.Runtime",
            Folder = "HighDefinition", Asset = "UnityEngine.Rendering.HighDefinition.HDRenderPipelineAsset",
        };

        public static IReadOnlyList<PipelineKind> All { get; } = new[] { Universal, HighDefinition };

        /// <summary>Name on the command line.</summary>
        public string Name { get; private init; }
        /// <summary>Tag of SubShaders.</summary>
        public string Tag { get; private init; }
        public string Package { get; private init; }
        /// <summary>Name of the stand-in's assembly, which is that of the pipeline's.</summary>
        public string Assembly { get; private init; }
        /// <summary>Folder of the stand-in's sources.</summary>
        public string Folder { get; private init; }
        /// <summary>Full name of the type of its asset.</summary>
        public string Asset { get; private init; }

        public override string ToString() => Name;
    }
}
