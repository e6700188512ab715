using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Rill.TerrainPhysics")]
[assembly: InternalsVisibleTo("Rill.TerrainPhysics.Tests")]
