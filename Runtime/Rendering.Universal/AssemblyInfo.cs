using UnityEngine.Scripting;

// No scene refers to this assembly, and no other assembly does: without the attribute a build that strips code has no fluid surfaces.
[assembly: AlwaysLinkAssembly]
