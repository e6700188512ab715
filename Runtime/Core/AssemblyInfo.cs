using System.Runtime.CompilerServices;
using UnityEngine.Scripting;

[assembly: AlwaysLinkAssembly]
[assembly: InternalsVisibleTo("Rill.Physics")]
[assembly: InternalsVisibleTo("Rill.Physics.Tests")]
[assembly: InternalsVisibleTo("Rill.Testing")]
[assembly: InternalsVisibleTo("Rill.Terrain")]
[assembly: InternalsVisibleTo("Rill.Terrain.Tests")]
[assembly: InternalsVisibleTo("Rill.TerrainPhysics")]
[assembly: InternalsVisibleTo("Rill.TerrainPhysics.Tests")]
[assembly: InternalsVisibleTo("Rill.Timeline")]
[assembly: InternalsVisibleTo("Rill.Timeline.Tests")]
[assembly: InternalsVisibleTo("Rill.Universal")]
[assembly: InternalsVisibleTo("Rill.HighDefinition")]
[assembly: InternalsVisibleTo("Rill.Editor")]
[assembly: InternalsVisibleTo("Rill.Physics.Editor")]
[assembly: InternalsVisibleTo("Rill.Terrain.Editor")]
[assembly: InternalsVisibleTo("Rill.Tests")]
[assembly: InternalsVisibleTo("Rill.Editor.Tests")]
// The headless host's benchmark and explain commands read the solver's stages.
[assembly: InternalsVisibleTo("Host")]
[assembly: InternalsVisibleTo("Host.Tests")]
