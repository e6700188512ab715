using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Rill.TerrainPhysics.Editor")]
