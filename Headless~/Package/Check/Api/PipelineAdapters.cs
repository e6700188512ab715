using Host.Pipelines;

namespace Host.Check.Api
{
    /// <summary>Locations of the package's adapters to render pipelines.</summary>
    static class PipelineAdapters
    {
        /// <summary>The assembly definition, from the package's root.</summary>
        public static string FileOf(PipelineKind kind) => kind == PipelineKind.Universal
            ? "Runtime/Rendering.Universal/Rill.Universal.asmdef" : "Runtime/Rendering.HighDefinition/Rill.HighDefinition.asmdef";
    }
}
