using System.Collections.Generic;
using Host.Check.Api;
using Host.Check.Build;

namespace Host.Check
{
    /// <summary>All rules, in the order of the table.</summary>
    static class RuleBook
    {
        public static IReadOnlyList<Rule> All { get; } = new Rule[]
        {
            new MetaFilesRule(),
            new FileNamesRule(),
            new ManifestRule(),
            new AssemblyDefinitionsRule(),
            new ScriptNamesRule(),
            new ReferencesRule(),
            new ScriptFieldsRule(),
            new PipelineMaterialsRule(),
            new SceneSettingsRule(),
            new RootRule(),
            new TarballRule(),
            new TestProjectRule(),
            new EngineRule(),
            new LinksRule(),
            new LoggedMessagesRule(),
            new GeneratedFilesRule(),
            new ResourcesRule(),
            new SceneReferencesRule(),
            new StrippingRule(),
            new RoomsRule(),
            new FrameCallsRule(),
            new StaticsRule(),
            new ReloadFieldsRule(),
            new UnsafeMomentsRule(),
            new LineLengthRule(),
            new HeaderSizesRule(),
            new CultureRule(),
            new ModulesRule(),
            new UnityMembersRule(),
            new HiddenMembersRule(),
            new MessagesRule(),
            new SourceNamesRule(),
            new SampleScriptsRule(),
            new NetStandardRule(),
            new NUnitRule(),
            new HostSurfaceRule(),
            new PipelineSurfaceRule(),
            new PipelineAdaptersRule(),
            new RenderPassesRule(),
            new FxcRule(),
            new LayoutRule(),
            new TargetsRule(),
            new ConstantBuffersRule(),
        };
    }
}
