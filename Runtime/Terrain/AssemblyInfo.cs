using System.Runtime.CompilerServices;
using UnityEngine.Scripting;

[assembly: AlwaysLinkAssembly]
[assembly: InternalsVisibleTo("Rill.TerrainPhysics")]
[assembly: InternalsVisibleTo("Rill.TerrainPhysics.Tests")]
