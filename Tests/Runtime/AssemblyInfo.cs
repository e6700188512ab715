using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Rill.Editor.Tests")]
[assembly: InternalsVisibleTo("Rill.Timeline.Tests")]
