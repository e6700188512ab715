using System.Runtime.CompilerServices;
using UnityEngine.Scripting;

// No scene refers to this assembly, and no other assembly does: without the attribute a build that strips code has no ground of terrains.
[assembly: AlwaysLinkAssembly]
[assembly: InternalsVisibleTo("Rill.TerrainPhysics.Editor")]
