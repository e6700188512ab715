using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Rill.Editor.Tests")]
