using Host.Pipelines;

namespace Host.Tests
{
    /// <summary>A block of water above a floor that the package's adapter for URP draws.</summary>
    public abstract class UniversalSurfaceFixture : PipelineSurfaceFixture
    {
        private protected void Build(string version, bool editor = false) => Build(PipelineKind.Universal, version, editor);

        private protected void BuildWithFault(string version, string file, string line, string instead)
            => BuildWithFault(PipelineKind.Universal, version, file, line, instead);
    }
}
