using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Rill.Physics.Editor")]
[assembly: InternalsVisibleTo("Rill.Physics.Tests")]
[assembly: InternalsVisibleTo("Rill.TerrainPhysics")]
[assembly: InternalsVisibleTo("Rill.TerrainPhysics.Tests")]
