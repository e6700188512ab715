using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Rill.Physics.Editor")]
[assembly: InternalsVisibleTo("Rill.Physics.Tests")]
