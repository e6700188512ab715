using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Rill.Physics.Editor")]
[assembly: InternalsVisibleTo("Rill.Terrain.Editor")]
[assembly: InternalsVisibleTo("Rill.Editor.Tests")]
// The headless host's tests call the inspectors.
[assembly: InternalsVisibleTo("Host.Tests")]
