using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Rill.Physics.Editor")]
[assembly: InternalsVisibleTo("Rill.Terrain.Editor")]
[assembly: InternalsVisibleTo("Rill.Editor.Tests")]
// The headless host's command bake draws with the same colors; its tests call inspectors and windows.
[assembly: InternalsVisibleTo("Host")]
[assembly: InternalsVisibleTo("Host.Tests")]
